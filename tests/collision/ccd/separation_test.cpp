// Minimal separation: known times, and random pairs against the distance between primitives, taken in another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "collision/ccd/exact_impact.h"
#include "collision/ccd/impact.h"
#include "collision/ccd/random_query.h"
#include "support/verification.h"

namespace nuno {
namespace {

using glm::dvec3;

constexpr dvec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

std::optional<double> impact(const Query& query, double separation)
{
    return query.kind == PairKind::vertex_face ? vertex_face_impact(query.t0, query.t1, separation)
                                               : edge_edge_impact(query.t0, query.t1, separation);
}

double distance_to_segment(const dvec3& p, const dvec3& a, const dvec3& b)
{
    const dvec3 e = b - a;
    const double ee = glm::dot(e, e), s = ee > 0 ? std::clamp(glm::dot(p - a, e) / ee, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + s * e));
}

// Below this the square of an angle's sine is rounding, and a normal says nothing.
constexpr double kNoAngle = 1e-26;

double face_distance(const FourPoints& p)
{
    const double sides = std::min({distance_to_segment(p[0], p[1], p[2]), distance_to_segment(p[0], p[2], p[3]),
                                   distance_to_segment(p[0], p[3], p[1])});
    const dvec3 n = glm::cross(p[2] - p[1], p[3] - p[1]), q = p[0] - p[1];
    const double nn = glm::dot(n, n), b = glm::dot(glm::cross(q, p[3] - p[1]), n);
    const double c = glm::dot(glm::cross(p[2] - p[1], q), n);
    const double size_sq = glm::dot(p[2] - p[1], p[2] - p[1]) * glm::dot(p[3] - p[1], p[3] - p[1]);
    const bool is_over = nn > kNoAngle * size_sq && b >= 0 && c >= 0 && b + c <= nn;
    return is_over ? std::fabs(glm::dot(q, n)) / std::sqrt(nn) : sides;
}

double edge_distance(const FourPoints& p)
{
    const double ends = std::min({distance_to_segment(p[0], p[2], p[3]), distance_to_segment(p[1], p[2], p[3]),
                                  distance_to_segment(p[2], p[0], p[1]), distance_to_segment(p[3], p[0], p[1])});
    const dvec3 ea = p[1] - p[0], eb = p[3] - p[2], d = p[2] - p[0], n = glm::cross(ea, eb);
    const double nn = glm::dot(n, n), s = glm::dot(glm::cross(d, eb), n), r = glm::dot(glm::cross(d, ea), n);
    const double size_sq = glm::dot(ea, ea) * glm::dot(eb, eb);
    const bool is_crossing = nn > kNoAngle * size_sq && s >= 0 && s <= nn && r >= 0 && r <= nn;
    return is_crossing ? std::fabs(glm::dot(d, n)) / std::sqrt(nn) : ends;
}

double distance(const Query& query, double t)
{
    FourPoints points;
    for (int i = 0; i < 4; ++i) points[i] = (1 - t) * query.t0[i] + t * query.t1[i];
    return query.kind == PairKind::vertex_face ? face_distance(points) : edge_distance(points);
}

// Families whose sizes are near 1, so that rounding is 1e-13 or so in the distances above.
constexpr QueryFamily kFamilies[] = {QueryFamily::any,    QueryFamily::grid,   QueryFamily::planar,
                                     QueryFamily::rigid,  QueryFamily::built,  QueryFamily::nudged,
                                     QueryFamily::scaled, QueryFamily::sliver, QueryFamily::turning};

TEST(Separation, is_met_when_a_plane_is_that_near)
{
    const auto falling = [](double separation) {
        return vertex_face_impact({dvec3(0.3, 0.3, 1), kA, kB, kC}, {dvec3(0.3, 0.3, -1), kA, kB, kC}, separation);
    };
    for (const double separation : {0.5, 0.1, 0.01, 1e-5, 1e-8}) {
        ASSERT_TRUE(falling(separation));
        EXPECT_LE(*falling(separation), 0.5 - 0.5 * separation);
        expect_measured("time at which the separation is met", *falling(separation), 0.5 - 0.5 * separation,
                        kSeparationSlack * separation + 1e-15);
    }
    EXPECT_EQ(falling(0), vertex_face_impact({dvec3(0.3, 0.3, 1), kA, kB, kC}, {dvec3(0.3, 0.3, -1), kA, kB, kC}));
}

TEST(Separation, holds_a_slide_up_only_where_it_is_too_near)
{
    const auto sliding = [](double height, double separation) {
        return vertex_face_impact({dvec3(-1, 0.3, height), kA, kB, kC}, {dvec3(2, 0.3, height), kA, kB, kC},
                                  separation);
    };
    EXPECT_FALSE(sliding(0.011, 0.01));
    EXPECT_FALSE(sliding(0.01002, 0.01));
    ASSERT_TRUE(sliding(0.0099, 0.01));
    // Near the edge x = 0 of the face: 0.01^2 = 0.0099^2 + x^2.
    EXPECT_NEAR(*sliding(0.0099, 0.01), (1 - std::sqrt(1e-4 - 0.0099 * 0.0099)) / 3, 1e-4);
}

TEST(Separation, is_met_at_once_by_a_start_that_is_too_near)
{
    const FourPoints t0{dvec3(0.3, 0.3, 0.005), kA, kB, kC}, t1{dvec3(0.3, 0.3, 1), kA, kB, kC};
    EXPECT_EQ(vertex_face_impact(t0, t1, 0.01), 0.0);
    EXPECT_EQ(vertex_face_impact(t0, t1, 0.005), 0.0);
    EXPECT_FALSE(vertex_face_impact(t0, t1, 0.5 * distance_at_least(PairKind::vertex_face, t0)));
}

TEST(Separation, is_kept_before_the_time_and_reached_there)
{
    int impact_count = 0, free_count = 0;
    for (const QueryFamily family : kFamilies)
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            const Query query = random_query(family, seed);
            const double separation = std::ldexp(0.3, -static_cast<int>(seed % 20));
            const std::optional<double> time = impact(query, separation);
            const double end = time.value_or(1.0), rounding = 1e-12 * (1 + glm::length(query.t0[0] - query.t0[1]));
            for (int sample = 0; sample <= 200; ++sample) {
                const double t = end * sample / 200;
                if (t == 0 && time == 0.0) continue;
                ASSERT_GE(distance(query, t), separation - rounding) << name_of(family) << " " << seed << " t " << t;
            }
            ++(time ? impact_count : free_count);
            if (!time) continue;
            ASSERT_LE(distance(query, *time), separation * (1 + kSeparationSlack) + rounding)
                << name_of(family) << " " << seed;
        }
    EXPECT_GT(impact_count, 500);
    EXPECT_GT(free_count, 500);
}

TEST(Separation, is_met_before_contact_in_every_family)
{
    for (int i = 0; i < static_cast<int>(QueryFamily::count); ++i)
        for (std::uint64_t seed = 1; seed <= 300; ++seed) {
            const Query query = random_query(static_cast<QueryFamily>(i), seed);
            const std::optional<double> contact = exact_impact(query.kind, query.t0, query.t1);
            if (!contact) continue;
            for (const double separation : {1e-300, 1e-9, 0.01, 1e300}) {
                const std::optional<double> time = impact(query, separation);
                ASSERT_TRUE(time) << text_of(query);
                EXPECT_LE(*time, *contact + 4e-15) << text_of(query);  // that is rounded down by so much
                EXPECT_GE(*time, 0);
            }
        }
}

TEST(Separation, the_least_distance_is_the_distance)
{
    for (const QueryFamily family : kFamilies)
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            const Query query = random_query(family, seed);
            const double measured = distance_at_least(query.kind, query.t0), expected = distance(query, 0);
            const double rounding = 1e-12 * (1 + glm::length(query.t0[0] - query.t0[1]));
            EXPECT_NEAR(measured, expected, rounding) << name_of(family) << " " << seed;
            EXPECT_GE(measured, 0);
        }
}

TEST(Separation, has_an_answer_without_area_length_or_motion)
{
    const FourPoints points{kA, kA, kA, kA};
    EXPECT_EQ(vertex_face_impact(points, points, 0.1), 0.0);
    EXPECT_EQ(edge_edge_impact(points, points, 0.1), 0.0);
    const FourPoints apart{kC, kA, kA, kB}, edges{kC, kC, kA, kA};
    EXPECT_FALSE(vertex_face_impact(apart, apart, 0.9));
    EXPECT_EQ(vertex_face_impact(apart, apart, 1.0), 0.0);
    EXPECT_FALSE(edge_edge_impact(edges, edges, 0.9));
    EXPECT_EQ(edge_edge_impact(edges, edges, 1.0), 0.0);
}

TEST(Separation, is_met_at_any_size)
{
    for (const double size : {1e-300, 1e-200, 1e-80, 1e-30, 1e30, 1e80, 1e200, 1e300}) {
        const auto at = [&](double x, double y, double z) { return size * dvec3(x, y, z); };
        const FourPoints t0{at(2, 2, 4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
        const FourPoints t1{at(2, 2, -4), at(0, 0, 0), at(8, 0, 0), at(0, 8, 0)};
        const std::optional<double> time = vertex_face_impact(t0, t1, size);
        ASSERT_TRUE(time) << size;
        EXPECT_NEAR(*time, 0.375, 1e-3) << size;
        EXPECT_LE(*time, 0.375) << size;
        EXPECT_NEAR(distance_at_least(PairKind::vertex_face, t0) / (4 * size), 1, 1e-12) << size;
    }
}

}  // namespace
}  // namespace nuno
