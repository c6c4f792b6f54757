// Primitives without area or length, motion in a plane or none, and numbers of any size: an answer, and the right one.
#include <gtest/gtest.h>

#include <cfloat>

#include "collision/ccd/impact.h"

namespace nuno {
namespace {

using glm::dvec3;

constexpr dvec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

void expect_impact(const std::optional<double>& time, double expected)
{
    ASSERT_TRUE(time);
    EXPECT_LE(*time, expected);
    EXPECT_GE(*time, expected - kImpactTimeBracket);
}

TEST(DegenerateImpact, without_motion)
{
    const FourPoints on{dvec3(0.25, 0.25, 0), kA, kB, kC}, off{dvec3(0.25, 0.25, 1e-300), kA, kB, kC};
    EXPECT_EQ(vertex_face_impact(on, on), 0.0);
    EXPECT_FALSE(vertex_face_impact(off, off));
    const FourPoints crossed{dvec3(0.5, -1, 0), dvec3(0.5, 1, 0), kA, kB},
        apart{dvec3(0, 1, 0), dvec3(1, 1, 0), kA, kB};
    EXPECT_EQ(edge_edge_impact(crossed, crossed), 0.0);
    EXPECT_FALSE(edge_edge_impact(apart, apart));
}

TEST(DegenerateImpact, a_face_that_is_a_segment_or_a_point)
{
    const dvec3 up(0.25, 0, 1), down(0.25, 0, -1), beside(0.25, 0.1, 1), gone(0.25, 0.1, -1);
    expect_impact(vertex_face_impact({up, kA, kB, 0.5 * kB}, {down, kA, kB, 0.5 * kB}), 0.5);
    EXPECT_FALSE(vertex_face_impact({beside, kA, kB, 0.5 * kB}, {gone, kA, kB, 0.5 * kB}));
    expect_impact(vertex_face_impact({up, kA, kB, kB}, {down, kA, kB, kB}), 0.5);
    const dvec3 point(0.25, 0, 0);
    expect_impact(vertex_face_impact({up, point, point, point}, {down, point, point, point}), 0.5);
    EXPECT_FALSE(vertex_face_impact({beside, point, point, point}, {gone, point, point, point}));
}

TEST(DegenerateImpact, a_face_that_loses_its_area_only_at_the_impact)
{
    // Flat at t = 1/2, when the vertex arrives on the line that is left of it.
    const FourPoints t0{dvec3(0.25, 0, 1), kA, kB, dvec3(0.5, 1, 0)}, t1{dvec3(0.25, 0, -1), kA, kB, dvec3(0.5, -1, 0)};
    expect_impact(vertex_face_impact(t0, t1), 0.5);
}

TEST(DegenerateImpact, parallel_and_collinear_edges)
{
    const FourPoints above{dvec3(0.5, 0, 1), dvec3(2, 0, 1), kA, kB}, below{dvec3(0.5, 0, -1), dvec3(2, 0, -1), kA, kB};
    expect_impact(edge_edge_impact(above, below), 0.5);
    const FourPoints far{dvec3(3, 0, 0), dvec3(4, 0, 0), kA, kB}, near{dvec3(-1, 0, 0), dvec3(0, 0, 0), kA, kB};
    expect_impact(edge_edge_impact(far, near), 0.5);
    const FourPoints right{dvec3(1.5, 0, 1), dvec3(2, 0, 1), kA, kB}, under{dvec3(1.5, 0, -1), dvec3(2, 0, -1), kA, kB};
    EXPECT_FALSE(edge_edge_impact(right, under));
}

TEST(DegenerateImpact, edges_that_are_points)
{
    const dvec3 up(0.5, 0, 1), down(0.5, 0, -1), middle(0.5, 0, 0);
    expect_impact(edge_edge_impact({up, up, kA, kB}, {down, down, kA, kB}), 0.5);
    expect_impact(edge_edge_impact({up, up, middle, middle}, {down, down, middle, middle}), 0.5);
    EXPECT_FALSE(edge_edge_impact({up, up, kA, kA}, {down, down, kA, kA}));
    EXPECT_EQ(edge_edge_impact({kA, kA, kA, kA}, {kA, kA, kA, kA}), 0.0);
}

TEST(DegenerateImpact, motion_within_the_plane_of_the_face)
{
    expect_impact(vertex_face_impact({dvec3(-1, 0.5, 0), kA, kB, kC}, {dvec3(1, 0.5, 0), kA, kB, kC}), 0.5);
    EXPECT_FALSE(vertex_face_impact({dvec3(1, 1, 0), kA, kB, kC}, {dvec3(2, -0.5, 0), kA, kB, kC}));
    expect_impact(
        edge_edge_impact({dvec3(0, 1, 0), dvec3(0, 2, 0), kA, kB}, {dvec3(0, -3, 0), dvec3(0, -2, 0), kA, kB}), 0.25);
}

TEST(DegenerateImpact, ten_kilometres_from_the_origin)
{
    const dvec3 far(1e4, -1e4, 1e4);
    const double fine = 0x1p-20;
    const auto at = [&](double x, double y, double z) { return far + fine * dvec3(x, y, z); };
    const FourPoints t0{at(2, 2, 9), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
    const FourPoints t1{at(2, 2, -9), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
    expect_impact(vertex_face_impact(t0, t1), 0.5);
    const FourPoints beside_t0{at(5, 5, 9), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
    const FourPoints beside_t1{at(5, 5, -9), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
    EXPECT_FALSE(vertex_face_impact(beside_t0, beside_t1));
}

TEST(DegenerateImpact, from_the_least_numbers_to_the_greatest)
{
    for (const double size : {0x1p-1070, 1e-300, 1e-200, 1e-80, 1e-30, 1.0, 1e30, 1e80, 1e200, 1e300, DBL_MAX / 8}) {
        const auto at = [&](double x, double y, double z) { return size * dvec3(x, y, z); };
        const FourPoints t0{at(2, 2, 4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
        const FourPoints t1{at(2, 2, -4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
        expect_impact(vertex_face_impact(t0, t1), 0.5);
        const FourPoints beside_t0{at(5, 5, 4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
        const FourPoints beside_t1{at(5, 5, -4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
        EXPECT_FALSE(vertex_face_impact(beside_t0, beside_t1)) << size;
        const FourPoints a{at(0, -1, 1), at(0, 1, 1), at(-1, 0, 0), at(1, 0, 0)};
        const FourPoints b{at(0, -1, -1), at(0, 1, -1), at(-1, 0, 0), at(1, 0, 0)};
        expect_impact(edge_edge_impact(a, b), 0.5);
    }
}

TEST(DegenerateImpact, each_axis_with_a_size_of_its_own)
{
    const dvec3 size(DBL_MAX / 8, 0x1p-1070, 1);
    const auto at = [&](double x, double y, double z) { return size * dvec3(x, y, z); };
    const FourPoints t0{at(2, 2, 4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
    const FourPoints t1{at(2, 2, -4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
    expect_impact(vertex_face_impact(t0, t1), 0.5);
    EXPECT_FALSE(vertex_face_impact({at(5, 5, 4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)},
                                    {at(5, 5, -4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)}));
}

}  // namespace
}  // namespace nuno
