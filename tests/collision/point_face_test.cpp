// The foot of the perpendicular (seed paper, section 2.5.1.2), against its defining equations and against double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "collision/poses.h"
#include "model/formulas.h"

namespace nuno {
namespace {

const glm::vec3 kX0(0, 0, 0), kX1(2, 0, 0), kX2(0, 2, 0);

TEST(PointFace, foot_weights_and_distance_of_a_point_above_a_face)
{
    const formulas::FaceFoot foot = formulas::face_foot({0.5f, 1.0f, 0.25f}, kX0, kX1, kX2);
    EXPECT_FLOAT_EQ(foot.weights.x, 0.25f);
    EXPECT_FLOAT_EQ(foot.weights.y, 0.25f);
    EXPECT_FLOAT_EQ(foot.weights.z, 0.5f);
    EXPECT_EQ(foot.normal, glm::vec3(0, 0, 1));
    EXPECT_FLOAT_EQ(foot.distance, 0.25f);
}

TEST(PointFace, distance_is_negative_on_the_other_side)
{
    EXPECT_FLOAT_EQ(formulas::face_foot({0.5f, 1.0f, -0.25f}, kX0, kX1, kX2).distance, -0.25f);
}

TEST(PointFace, a_foot_outside_has_a_negative_weight)
{
    EXPECT_FLOAT_EQ(formulas::face_foot({-1, 1, 3}, kX0, kX1, kX2).weights.y, -0.5f);
    EXPECT_FLOAT_EQ(formulas::face_foot({1, -1, 3}, kX0, kX1, kX2).weights.z, -0.5f);
    EXPECT_FLOAT_EQ(formulas::face_foot({2, 2, 3}, kX0, kX1, kX2).weights.x, -1.0f);
}

// x20.x23 = w0 x20.x20 + w1 x20.x21 and x21.x23 = w0 x21.x20 + w1 x21.x21, in double, to rounding of the terms' size.
TEST(PointFace, weights_solve_the_system_of_the_paper)
{
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Pose soup = face_soup(2, seed);
        const auto at = [&](int i) { return glm::dvec3(soup.positions[i]); };
        const glm::dvec3 x3 = at(3), x20 = at(0) - at(2), x21 = at(1) - at(2), x23 = x3 - at(2);
        const formulas_f64::FaceFoot foot = formulas_f64::face_foot(x3, at(0), at(1), at(2));
        const double scale = glm::dot(x23, x23) + glm::dot(x20, x20) + glm::dot(x21, x21);
        const double w0 = foot.weights.x, w1 = foot.weights.y;
        EXPECT_NEAR(glm::dot(x20, x23), w0 * glm::dot(x20, x20) + w1 * glm::dot(x20, x21), 1e-12 * scale);
        EXPECT_NEAR(glm::dot(x21, x23), w0 * glm::dot(x21, x20) + w1 * glm::dot(x21, x21), 1e-12 * scale);
        EXPECT_NEAR(w0 + w1 + foot.weights.z, 1.0, 1e-12 * (1 + std::abs(w0) + std::abs(w1)));
        EXPECT_NEAR(foot.distance, glm::dot(foot.normal, x23), 1e-12 * std::sqrt(scale));
    }
}

// The weights move by the rounding of x23 (eps |x23|) over the height of the face, a few times.
TEST(PointFace, float_agrees_with_double_as_far_as_the_shape_of_the_face_allows)
{
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Pose soup = face_soup(2, seed);
        const auto at = [&](int i) { return glm::vec3(soup.positions[i]); };
        const formulas::FaceFoot single = formulas::face_foot(at(3), at(0), at(1), at(2));
        const formulas_f64::FaceFoot exact = formulas_f64::face_foot(at(3), at(0), at(1), at(2));
        const float longest = std::max(glm::length(at(0) - at(2)), glm::length(at(1) - at(2)));
        const float area = glm::length(glm::cross(at(0) - at(2), at(1) - at(2)));
        const float reach = glm::length(at(3) - at(2)) + longest;
        const double tolerance = 20 * 6e-8 * reach * longest * longest * longest / (area * area);
        EXPECT_NEAR(single.weights.x, exact.weights.x, tolerance);
        EXPECT_NEAR(single.weights.y, exact.weights.y, tolerance);
        EXPECT_NEAR(single.distance, exact.distance, tolerance * longest);
    }
}

// No test of nearness accepts what these give; none of it is NaN.
TEST(PointFace, a_face_without_area_is_near_nothing)
{
    const glm::vec3 a(1, 2, 3), b(2, 2, 3);
    const glm::vec3 faces[][3] = {{a, a, a},          {a, a, b}, {a, b, a}, {b, a, a}, {a, b, 0.5f * (a + b)},
                                  {a, b, b + (b - a)}};
    for (const auto& face : faces) {
        for (const glm::vec3& point : {a, b, a + glm::vec3(0.3f, 0, 0), glm::vec3(0, 0, 0)}) {
            const formulas::FaceFoot foot = formulas::face_foot(point, face[0], face[1], face[2]);
            EXPECT_GT(foot.distance, 1e20f);
            EXPECT_LT(foot.weights.x, -1e20f);
            EXPECT_FALSE(std::isnan(foot.normal.x + foot.normal.y + foot.normal.z));
        }
    }
}

TEST(PointFace, huge_and_tiny_faces_give_no_nan)
{
    for (const float size : {1e-30f, 1e-20f, 1e-10f, 1e10f, 1e15f, 1e18f}) {
        const formulas::FaceFoot foot =
            formulas::face_foot(size * glm::vec3(0.2f, 0.2f, 0.1f), size * kX0, size * kX1, size * kX2);
        EXPECT_FALSE(std::isnan(foot.weights.x + foot.weights.y + foot.weights.z + foot.distance)) << size;
        EXPECT_FALSE(std::isnan(foot.normal.x + foot.normal.y + foot.normal.z)) << size;
    }
}

// A point at `distance` from the foot is so far from the weighted corners, however thin the face: the tree relies on
// it.
TEST(PointFace, distance_is_measured_to_the_weighted_corners_even_of_a_needle)
{
    for (const float width : {1e-1f, 1e-3f, 1e-5f}) {
        const glm::vec3 x0(0, 0, 0), x1(1, 0.3f, 0.2f), x2 = 0.5f * x1 + glm::vec3(0, width, 0);
        for (std::uint32_t seed = 1; seed <= 50; ++seed) {
            const glm::vec3 x3 = shaken(std::vector<glm::vec4>{{0, 0, 0, 0}}, 1, seed)[0];
            const formulas::FaceFoot foot = formulas::face_foot(x3, x0, x1, x2);
            const glm::dvec3 w = foot.weights;
            const glm::dvec3 x4 = w.x * glm::dvec3(x0) + w.y * glm::dvec3(x1) + w.z * glm::dvec3(x2);
            const double size = 3 + std::abs(w.x) + std::abs(w.y);
            EXPECT_NEAR(glm::length(glm::dvec3(x3) - x4), std::abs(foot.distance), 1e-6 * size)
                << width << " seed " << seed;
        }
    }
}

}  // namespace
}  // namespace nuno
