// Answers to impacts, against Coulomb's law and the conservation of momentum.
#include "collision/impact_zone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr double kKinetic = 0.2, kResting = 0.5;

// A square that lies on a large face, tilted about z: corners 0 to 2 are the face's, 3 to 6 the square's.
struct Slope
{
    glm::dvec3 down, normal;
    std::vector<glm::dvec3> start;

    explicit Slope(double angle)
        : down(std::cos(angle), -std::sin(angle), 0), normal(std::sin(angle), std::cos(angle), 0)
    {
        const glm::dvec3 side(0, 0, 1);
        start = {-5.0 * down - 4.0 * side, 5.0 * down - 4.0 * side, 8.0 * side};
        for (const double a : {-0.1, 0.1})
            for (const double b : {-0.1, 0.1}) start.push_back(a * down + b * side);
    }

    // Of each of the square's vertices with the face.
    std::vector<Impact> impacts() const
    {
        std::vector<Impact> found;
        for (std::uint32_t v = 3; v < 7; ++v) {
            // w0 + w1 + w2 = 1 with the foot at the vertex itself.
            const double a = glm::dot(start[v], down), b = start[v].z, w2 = (b + 4) / 12, w1 = (a / 5 + 1 - w2) / 2;
            found.push_back({.pair = {PairKind::vertex_face, {v, 0, 1, 2}, 0},
                             .time = 0,
                             .normal = normal,
                             .weights = {1, w1 + w2 - 1, -w1, -w2},
                             .target = 0});
        }
        return found;
    }

    std::vector<glm::dvec3> answered(const std::vector<double>& inverse_masses, const glm::dvec3& way) const
    {
        std::vector<glm::dvec3> positions = start;
        for (std::size_t v = 3; v < 7; ++v) positions[v] += way;
        std::vector<Impact> all = impacts();
        answer_impacts(all, start, {kKinetic, kResting, inverse_masses}, positions);
        return positions;
    }
};

const std::vector<double> kFaceHeld = {0, 0, 0, 2, 2, 2, 2}, kAllFree = {0.5, 0.5, 0.5, 2, 2, 2, 2};

// What falls straight down on a slope of angle a has the way g sin a along it and g cos a into it.
TEST(ImpactFriction, holds_on_slopes_up_to_the_angle_of_static_friction)
{
    const double fall = 0.01;
    for (const double slope : {0.0, 0.1, 0.3, 0.49, 0.51, 0.7, 2.0}) {
        const double angle = std::atan(slope);
        const Slope pair(angle);
        const std::vector<glm::dvec3> end = pair.answered(kFaceHeld, {0, -fall, 0});
        const double slid = slope <= kResting ? 0 : fall * (std::sin(angle) - kKinetic * std::cos(angle));
        for (std::size_t v = 3; v < 7; ++v) {
            EXPECT_NEAR(glm::dot(end[v] - pair.start[v], pair.down), slid, 1e-9) << slope;
            EXPECT_NEAR(glm::dot(end[v] - pair.start[v], pair.normal), 0, 1e-9) << slope;
        }
    }
}

TEST(ImpactFriction, keeps_the_momentum_of_layers_that_are_free)
{
    const Slope pair(0);
    for (const double across : {0.002, 0.02}) {
        const glm::dvec3 way(across, -0.01, 0.3 * across);
        const std::vector<glm::dvec3> end = pair.answered(kAllFree, way);
        glm::dvec3 momentum(0);
        for (std::size_t v = 0; v < end.size(); ++v) momentum += (end[v] - pair.start[v]) / kAllFree[v];
        EXPECT_LT(glm::length(momentum - 4.0 * way / 2.0), 1e-12);
    }
}

// The drag of a sweep may turn out too large in the next one, as the impulse does.
TEST(ImpactFriction, of_no_impact_is_more_than_its_impulse_bears)
{
    const Slope pair(0.2);
    std::vector<glm::dvec3> positions = pair.start;
    for (std::size_t v = 3; v < 7; ++v) positions[v] += glm::dvec3(0.004 * double(v), -0.01 * double(v - 3), 0.01);
    std::vector<Impact> all = pair.impacts();
    answer_impacts(all, pair.start, {kKinetic, kResting, kAllFree}, positions);
    int sliding = 0;
    for (const Impact& impact : all) {
        const double drag = glm::length(impact.drag), most = kResting * impact.impulse;
        EXPECT_LE(drag, most * (1 + 1e-12));
        EXPECT_NEAR(glm::dot(impact.drag, pair.normal), 0, 1e-12);
        sliding += std::abs(drag - kKinetic * impact.impulse) < 1e-12 && drag > 0;
    }
    EXPECT_GT(sliding, 0);
}

TEST(ImpactFriction, leaves_layers_that_part_alone)
{
    const Slope pair(0);
    const glm::dvec3 way(0.1, 0.001, 0);
    const std::vector<glm::dvec3> end = pair.answered(kAllFree, way);
    for (std::size_t v = 0; v < end.size(); ++v) EXPECT_EQ(end[v], pair.start[v] + (v < 3 ? glm::dvec3(0) : way));
}

}  // namespace
}  // namespace nuno
