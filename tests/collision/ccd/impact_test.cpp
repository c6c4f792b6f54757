// First times of contact where they are known, the symmetries they have, and the filter against exact arithmetic.
#include "collision/ccd/impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "collision/ccd/exact_impact.h"
#include "collision/ccd/filter.h"
#include "collision/ccd/oracle_check.h"
#include "collision/ccd/plain_filter.h"
#include "collision/ccd/random_query.h"

namespace nuno {
namespace {

using glm::dvec3;

constexpr dvec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

std::optional<double> impact(const Query& query)
{
    return query.kind == PairKind::vertex_face ? vertex_face_impact(query.t0, query.t1)
                                               : edge_edge_impact(query.t0, query.t1);
}

// A vertex on its way past a face that stays.
std::optional<double> past_face(const dvec3& from, const dvec3& to)
{
    return vertex_face_impact({from, kA, kB, kC}, {to, kA, kB, kC});
}

// Edge a moves, edge b stays from (-1, 0, 0) to (1, 0, 0).
std::optional<double> past_edge(const dvec3& a0, const dvec3& a1, const dvec3& motion)
{
    const dvec3 b0(-1, 0, 0), b1(1, 0, 0);
    return edge_edge_impact({a0, a1, b0, b1}, {a0 + motion, a1 + motion, b0, b1});
}

void expect_impact(const std::optional<double>& time, double expected)
{
    ASSERT_TRUE(time);
    EXPECT_LE(*time, expected);
    EXPECT_GE(*time, expected - kImpactTimeBracket);
}

TEST(VertexFaceImpact, through_the_middle)
{
    expect_impact(past_face({0.3, 0.3, 1}, {0.3, 0.3, -1}), 0.5);
    expect_impact(past_face({0.3, 0.3, -1}, {0.3, 0.3, 3}), 0.25);
    expect_impact(past_face({0.9, 0.9, 1}, {-0.3, -0.3, -1}), 0.5);
    EXPECT_FALSE(past_face({0.6, 0.6, 1}, {0.6, 0.6, -1}));
    EXPECT_FALSE(past_face({0.3, 0.3, 1}, {0.3, 0.3, 1e-300}));
}

TEST(VertexFaceImpact, edges_and_corners_belong_to_the_face)
{
    expect_impact(past_face({0.5, 0, 1}, {0.5, 0, -1}), 0.5);
    expect_impact(past_face({0.5, 0.5, 1}, {0.5, 0.5, -1}), 0.5);
    expect_impact(past_face({0, 0, 1}, {0, 0, -1}), 0.5);
    expect_impact(past_face({1, 0, 1}, {1, 0, -1}), 0.5);
    EXPECT_FALSE(past_face({1, 0x1p-60, 1}, {1, 0x1p-60, -1}));
    EXPECT_FALSE(past_face({0.5, -0x1p-60, 1}, {0.5, -0x1p-60, -1}));
    expect_impact(past_face({0.5, 0x1p-60, 1}, {0.5, 0x1p-60, -1}), 0.5);
}

TEST(VertexFaceImpact, the_start_and_the_end_count)
{
    EXPECT_EQ(past_face({0.3, 0.3, 0}, {0.3, 0.3, 1}), 0.0);
    expect_impact(past_face({0.3, 0.3, 1}, {0.3, 0.3, 0}), 1.0);
    EXPECT_EQ(past_face({0, 0, 0}, {1, 1, 1}), 0.0);
    expect_impact(past_face({1, 1, 1}, {0, 0, 0}), 1.0);
}

// The face z = s x tilts, s = T, and the point is at x = 0.3 + 0.2 T, T = 2 t - 1: its height over the face is
// h - 0.3 T - 0.2 T^2, with roots T = (-0.3 +- sqrt(0.09 + 0.8 h)) / 0.4.
TEST(VertexFaceImpact, the_first_of_two_roots)
{
    const auto tilting = [](double h) {
        return vertex_face_impact({dvec3(0.1, 0.25, h), kA, {1, 0, -1}, kC}, {dvec3(0.5, 0.25, h), kA, {1, 0, 1}, kC});
    };
    const auto first_root = [](double h) { return 0.5 + 0.5 * (-0.3 - std::sqrt(0.09 + 0.8 * h)) / 0.4; };
    const auto second_root = [](double h) { return 0.5 + 0.5 * (-0.3 + std::sqrt(0.09 + 0.8 * h)) / 0.4; };
    ASSERT_TRUE(tilting(-0.105));
    EXPECT_NEAR(*tilting(-0.105), first_root(-0.105), 2e-9);
    ASSERT_TRUE(tilting(0.3));
    EXPECT_NEAR(*tilting(0.3), second_root(0.3), 2e-9);
    EXPECT_FALSE(tilting(-0.2));
}

// As above with x = (3 + 2 T) / 8: the height is -(T / 2 + 3 / 8)^2, which touches 0 at t = 1 / 8.
TEST(VertexFaceImpact, a_touch_without_crossing)
{
    const auto touching = [](double h) {
        return vertex_face_impact({dvec3(0.125, 0.25, h), kA, {1, 0, -1}, kC},
                                  {dvec3(0.625, 0.25, h), kA, {1, 0, 1}, kC});
    };
    expect_impact(touching(-0.140625), 0.125);
    EXPECT_FALSE(touching(-0.14062500000000003));
}

TEST(EdgeEdgeImpact, crossing_and_ends)
{
    expect_impact(past_edge({0, -1, 1}, {0, 1, 1}, {0, 0, -2}), 0.5);
    expect_impact(past_edge({0, 0, 1}, {0, 1, 1}, {0, 0, -2}), 0.5);   // with an end of one
    expect_impact(past_edge({1, 0, 1}, {2, 1, 1}, {0, 0, -4}), 0.25);  // end to end
    EXPECT_FALSE(past_edge({0, 0x1p-60, 1}, {0, 1, 1}, {0, 0, -2}));
    EXPECT_FALSE(past_edge({1 + 0x1p-52, 0, 1}, {2, 1, 1}, {0, 0, -2}));
    EXPECT_FALSE(past_edge({0, -1, 1}, {0, 1, 1}, {0, 0, -0.999}));
    EXPECT_EQ(past_edge({0, -1, 0}, {0, 1, 0}, {0, 0, 5}), 0.0);
    expect_impact(past_edge({0, -1, 1}, {0, 1, 1}, {0, 0, -1}), 1.0);
}

TEST(Impact, does_not_depend_on_the_order_of_points_the_direction_of_time_or_the_axes)
{
    for (int i = 0; i < static_cast<int>(QueryFamily::count); ++i)
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Query query = random_query(static_cast<QueryFamily>(i), seed);
            const bool expected = impact(query).has_value();
            Query turned = query, mirrored = query, back = query;
            const bool face = query.kind == PairKind::vertex_face;
            for (FourPoints* points : {&turned.t0, &turned.t1}) {
                if (face)
                    *points = {(*points)[0], (*points)[3], (*points)[1], (*points)[2]};
                else
                    *points = {(*points)[3], (*points)[2], (*points)[0], (*points)[1]};
            }
            for (FourPoints* points : {&mirrored.t0, &mirrored.t1})
                for (dvec3& p : *points) p = {-p.y, p.z, 0.25 * p.x};
            std::swap(back.t0, back.t1);
            EXPECT_EQ(impact(turned).has_value(), expected) << text_of(query);
            EXPECT_EQ(impact(back).has_value(), expected) << text_of(query);
            if (static_cast<QueryFamily>(i) == QueryFamily::extreme) continue;  // where a quarter may round
            EXPECT_EQ(impact(mirrored).has_value(), expected) << text_of(query);
        }
}

TEST(Impact, is_the_same_to_the_bit_in_another_unit)
{
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        const Query query = random_query(QueryFamily::built, seed);
        Query doubled = query;
        for (FourPoints* points : {&doubled.t0, &doubled.t1})
            for (dvec3& p : *points) p *= 1024;
        EXPECT_EQ(impact(query), impact(doubled)) << text_of(query);
    }
}

FilterVerdict filtered(const Query& query)
{
    return query.kind == PairKind::vertex_face ? filter_vertex_face(query.t0, query.t1)
                                               : filter_edge_edge(query.t0, query.t1);
}

TEST(Filter, never_contradicts_exact_arithmetic)
{
    int counts[3] = {};
    for (int i = 0; i < static_cast<int>(QueryFamily::count); ++i)
        for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
            const Query query = random_query(static_cast<QueryFamily>(i), seed);
            const FilterVerdict verdict = filtered(query);
            const std::optional<double> exact = exact_impact(query.kind, query.t0, query.t1);
            ++counts[static_cast<int>(verdict.answer)];
            if (verdict.answer != FilterAnswer::unknown) {
                EXPECT_EQ(exact.has_value(), verdict.answer == FilterAnswer::impact) << text_of(query);
            }
            if (!exact) continue;
            EXPECT_LE(verdict.time, *exact + 4e-15) << text_of(query);
            if (verdict.answer != FilterAnswer::impact) continue;
            EXPECT_LE(*exact - verdict.time, kImpactTimeBracket) << text_of(query);
        }
    for (const int count : counts) EXPECT_GT(count, 1000) << "each kind of answer is to be met";
}

TEST(Filter, gives_the_same_bits_without_wide_vectors)
{
    for (int i = 0; i < static_cast<int>(QueryFamily::count); ++i)
        for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
            const Query query = random_query(static_cast<QueryFamily>(i), seed);
            const FilterVerdict verdict = filtered(query), plain = plainly_filtered(query);
            EXPECT_EQ(verdict.answer, plain.answer) << text_of(query);
            EXPECT_EQ(verdict.time, plain.time) << text_of(query);
        }
}

TEST(AxisGap, says_only_what_is_so)
{
    int gap_count = 0;
    for (int i = 0; i < static_cast<int>(QueryFamily::count); ++i)
        for (std::uint64_t seed = 1; seed <= 500; ++seed) {
            const Query query = random_query(static_cast<QueryFamily>(i), seed);
            const bool gap = query.kind == PairKind::vertex_face
                                 ? has_axis_gap<PairKind::vertex_face>(query.t0, query.t1, 0)
                                 : has_axis_gap<PairKind::edge_edge>(query.t0, query.t1, 0);
            if (!gap) continue;
            ++gap_count;
            EXPECT_FALSE(exact_impact(query.kind, query.t0, query.t1)) << text_of(query);
        }
    EXPECT_GT(gap_count, 500);
}

TEST(AxisGap, is_found_along_each_axis_and_on_either_side)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            dvec3 far(0);
            far[axis] = 2 * side;
            const FourPoints at{far, kA, kB, kC}, edges{far, far, kB, kC};
            EXPECT_TRUE(has_axis_gap<PairKind::vertex_face>(at, at, 0.5)) << axis;
            EXPECT_FALSE(has_axis_gap<PairKind::vertex_face>(at, at, 2)) << axis;
            EXPECT_TRUE(has_axis_gap<PairKind::edge_edge>(edges, edges, 0.5)) << axis;
            far[axis] = -2 * side;
            const FourPoints beyond{far, kA, kB, kC};
            EXPECT_FALSE(has_axis_gap<PairKind::vertex_face>(at, beyond, 0)) << "went through";
        }
}

}  // namespace
}  // namespace nuno
