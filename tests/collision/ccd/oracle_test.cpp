// The oracle itself, where the answer is known, and that the check against it can fail.
#include "collision/ccd/exact_oracle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nuno {
namespace {

using glm::dvec3;

constexpr dvec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

TEST(Oracle, knows_when_a_vertex_goes_through_a_face)
{
    const ExactOracle oracle(PairKind::vertex_face, {dvec3(0.25, 0.25, 1), kA, kB, kC},
                             {dvec3(0.25, 0.25, -2), kA, kB, kC});
    ASSERT_TRUE(oracle.has_contact());
    EXPECT_TRUE(oracle.has_none_before(0.333333));
    EXPECT_TRUE(oracle.has_none_before(1.0 / 3));  // which is less than a third
    EXPECT_FALSE(oracle.has_none_before(std::nextafter(1.0 / 3, 1)));
    EXPECT_FALSE(oracle.has_one_by(1.0 / 3));
    EXPECT_TRUE(oracle.has_one_by(std::nextafter(1.0 / 3, 1)));
}

TEST(Oracle, knows_when_edges_cross)
{
    const ExactOracle oracle(PairKind::edge_edge, {dvec3(0.5, -1, 1), dvec3(0.5, 1, 1), kA, kB},
                             {dvec3(0.5, -1, -1), dvec3(0.5, 1, -1), kA, kB});
    ASSERT_TRUE(oracle.has_contact());
    EXPECT_TRUE(oracle.has_none_before(0.5));
    EXPECT_TRUE(oracle.has_one_by(0.5));
    EXPECT_FALSE(oracle.has_one_by(0.4999));
    EXPECT_FALSE(ExactOracle(PairKind::edge_edge, {dvec3(1.5, -1, 1), dvec3(1.5, 1, 1), kA, kB},
                             {dvec3(1.5, -1, -1), dvec3(1.5, 1, -1), kA, kB})
                     .has_contact());
}

TEST(Oracle, knows_what_has_no_area_or_length_and_what_stays_in_a_plane)
{
    const dvec3 up(0.5, 0, 1), down(0.5, 0, -1), beside(0.5, 1, 1);
    EXPECT_TRUE(ExactOracle(PairKind::vertex_face, {up, kA, kB, kB}, {down, kA, kB, kB}).has_one_by(0.5));
    EXPECT_TRUE(ExactOracle(PairKind::edge_edge, {up, up, kA, kB}, {down, down, kA, kB}).has_one_by(0.5));
    EXPECT_FALSE(ExactOracle(PairKind::edge_edge, {beside, beside, kA, kB}, {down, down, kA, kB}).has_contact());
    const ExactOracle sliding(PairKind::vertex_face, {dvec3(-1, 0.5, 0), kA, kB, kC}, {dvec3(1, 0.5, 0), kA, kB, kC});
    EXPECT_TRUE(sliding.has_none_before(0.5));
    EXPECT_TRUE(sliding.has_one_by(0.5));
    const FourPoints touching{0.5 * (kA + kB), kA, kB, kC};
    EXPECT_TRUE(ExactOracle(PairKind::vertex_face, touching, touching).has_one_by(0));
}

// A face z = T x and a vertex at x = (3 + 2 T) / 8, T = 2 t - 1: its height over the face is -(T / 2 + 3 / 8)^2.
TEST(Oracle, sees_a_touch_that_only_a_double_root_tells_of)
{
    const auto touching = [](double height) {
        return ExactOracle(PairKind::vertex_face, {dvec3(0.125, 0.25, height), kA, {1, 0, -1}, kC},
                           {dvec3(0.625, 0.25, height), kA, {1, 0, 1}, kC});
    };
    EXPECT_TRUE(touching(-0.140625).has_none_before(0.125));
    EXPECT_TRUE(touching(-0.140625).has_one_by(0.125));
    EXPECT_FALSE(touching(-0.14062500000000003).has_contact());
}

}  // namespace
}  // namespace nuno
