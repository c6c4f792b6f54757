// Level `spheres`: the grid finds what brute force finds; pairs part to their distance, with Coulomb friction.
#include "collision/spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "collision/poses.h"

namespace nuno {
namespace {

std::vector<VertexPair> pairs_of(const Pose& pose, float distance, int threads = 1)
{
    ThreadPool pool(threads);
    SphereSearch search(pose.rest, pose.sheets);
    search.sort(pose.positions, distance);
    const std::span<const VertexPair> pairs = search.find(pool);
    return {pairs.begin(), pairs.end()};
}

std::vector<VertexPair> brute_force(const Pose& pose, float distance)
{
    const SphereSearch search(pose.rest, pose.sheets);
    std::vector<VertexPair> pairs;
    for (std::uint32_t a = 0; a < pose.positions.size(); ++a)
        for (std::uint32_t b = a + 1; b < pose.positions.size(); ++b)
            if (search.is_pair(pose.positions[a], pose.positions[b], {a, b}, distance)) pairs.push_back({a, b});
    return pairs;
}

std::size_t expect_as_brute_force(const Pose& pose, float distance)
{
    SCOPED_TRACE("distance " + std::to_string(distance));
    std::vector<VertexPair> found = pairs_of(pose, distance);
    std::sort(found.begin(), found.end());
    const std::vector<VertexPair> expected = brute_force(pose, distance);
    EXPECT_EQ(found, expected);
    return expected.size();
}

TEST(SphereSearch, agrees_with_brute_force)
{
    for (const float distance : {0.01f, 0.05f, 0.3f}) {
        EXPECT_GT(expect_as_brute_force(folded_sheet(33, 0.2f * distance), distance), 0u);
        EXPECT_GT(expect_as_brute_force(rolled_sheet(33, 0.01f), std::max(distance, 0.02f)), 0u);
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            EXPECT_GT(expect_as_brute_force(crumpled_sheet(33, 0.1f, seed), distance), 0u);
            EXPECT_GT(expect_as_brute_force(stacked_sheets(17, 4, seed), distance), 0u);
            expect_as_brute_force(face_soup(500, seed), distance);
        }
    }
}

TEST(SphereSearch, agrees_with_brute_force_far_from_the_origin_and_in_a_row_or_a_point)
{
    for (const float offset : {-1000.0f, 1e5f}) {
        Pose pose = crumpled_sheet(17, 0.1f, 1);
        for (glm::vec4& p : pose.positions) p += glm::vec4(offset, -offset, 0.5f * offset, 0);
        expect_as_brute_force(pose, 0.05f);
    }
    for (const glm::vec3 squeeze : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0)}) {
        Pose pose = crumpled_sheet(17, 0.1f, 2);
        for (glm::vec4& p : pose.positions) p = glm::vec4(squeeze * glm::vec3(p), 1);
        EXPECT_GT(expect_as_brute_force(pose, 0.01f), 0u);
    }
}

// One vertex a million metres away: cells are made wider, and nothing overflows.
TEST(SphereSearch, agrees_with_brute_force_where_one_vertex_is_far_away)
{
    Pose pose = crumpled_sheet(17, 0.1f, 1);
    pose.positions[7] = {1e6f, -1e6f, 1e6f, 1};
    for (const float distance : {1e-6f, 0.05f}) expect_as_brute_force(pose, distance);
}

TEST(SphereSearch, spheres_without_width_are_never_close)
{
    Pose pose = flat_sheet(5);
    for (glm::vec4& p : pose.positions) p = glm::vec4(0, 0, 0, 1);
    EXPECT_TRUE(pairs_of(pose, 0).empty());
}

TEST(SphereSearch, leaves_neighbours_at_rest_alone)
{
    EXPECT_TRUE(pairs_of(flat_sheet(17), 2.5f / 16).empty());
    EXPECT_TRUE(pairs_of(flat_sheet(17), 0.99f / 16).empty());
}

// The same rest shape twice, in the same place: vertices of different sheets have no distance at rest.
TEST(SphereSearch, no_sheet_has_neighbours_in_another)
{
    Pose pose = flat_sheet(5);
    Pose other = flat_sheet(5);
    for (glm::vec4& p : other.positions) p.z = 0.01f;
    add_sheets(pose, other);
    const std::vector<VertexPair> pairs = pairs_of(pose, 0.02f);
    EXPECT_EQ(pairs.size(), 25u);
    for (const VertexPair pair : pairs) EXPECT_EQ(pair.b, pair.a + 25);
}

TEST(SphereSearch, does_not_depend_on_the_number_of_threads)
{
    const Pose pose = crumpled_sheet(96, 0.1f, 1);
    const std::vector<VertexPair> one = pairs_of(pose, 0.02f);
    EXPECT_GT(one.size(), 1000u);
    for (const int threads : {2, 3}) EXPECT_EQ(pairs_of(pose, 0.02f, threads), one);
}

// Two spheres, one pass of 10 ms.
struct TwoSpheres
{
    std::vector<glm::vec4> positions, velocities{2};
    SphereSettings settings{0.01f, 0.0f, 0.0f};

    TwoSpheres(glm::vec3 a, glm::vec3 b, float ka, float kb) : positions{{a, ka}, {b, kb}} {}
    void push()
    {
        const VertexPair pair{0, 1};
        push_spheres_apart({&pair, 1}, settings, {positions, velocities, 0.01f});
    }
    float distance() const { return glm::length(glm::vec3(positions[0]) - glm::vec3(positions[1])); }
    // Along the line from 1 to 0.
    float parting() const
    {
        const glm::vec3 way = glm::vec3(positions[0]) - glm::vec3(positions[1]);
        return glm::dot(glm::vec3(velocities[0]) - glm::vec3(velocities[1]), way / distance());
    }
};

TEST(Spheres, a_pair_parts_to_its_distance_by_inverse_masses_and_no_further)
{
    TwoSpheres two({0, 0, 0}, {0.0036f, 0, 0.0048f}, 1, 3);
    two.push();
    EXPECT_NEAR(two.parting(), parting_speed(0.006f, two.settings, 0.01f), 1e-6f);
    EXPECT_NEAR(3 * glm::length(glm::vec3(two.velocities[0])), glm::length(glm::vec3(two.velocities[1])), 1e-6f);
    for (int pass = 0; pass < 100; ++pass) {
        for (int i = 0; i < 2; ++i) {
            two.positions[i] += 0.01f * two.velocities[i];
            two.velocities[i] = glm::vec4(0);
        }
        EXPECT_LT(two.distance(), 0.01f * 1.00001f);
        two.push();
    }
    EXPECT_NEAR(two.distance(), 0.01f, 1e-6f);
    // Of the 4 mm that were missing, along (0.6, 0, 0.8), the first has taken a quarter.
    EXPECT_NEAR(two.positions[0].x, -0.0006f, 1e-6f);
    EXPECT_NEAR(two.positions[0].z, -0.0008f, 1e-6f);
}

TEST(Spheres, overlap_of_any_depth_parts_without_a_kick)
{
    const SphereSettings thick{1.0f, 0, 0};
    EXPECT_LE(parting_speed(0, thick, 1e-4f), 0.25f);
    EXPECT_EQ(parting_speed(1.0f, thick, 0.01f), 0);
    EXPECT_EQ(parting_speed(2.0f, thick, 0.01f), 0);
}

TEST(Spheres, pinned_ones_stay_and_the_other_takes_all)
{
    TwoSpheres two({0, 0, 0}, {0, 0.009f, 0}, 0, 1);
    two.velocities[1] = {0, -1, 0, 0};
    two.push();
    EXPECT_EQ(two.velocities[0], glm::vec4(0));
    EXPECT_NEAR(two.velocities[1].y, parting_speed(0.009f, two.settings, 0.01f), 1e-6f);
    TwoSpheres pinned({0, 0, 0}, {0, 0.004f, 0}, 0, 0);
    pinned.push();
    EXPECT_EQ(pinned.velocities, std::vector<glm::vec4>(2));
}

TEST(Spheres, in_one_place_they_part_too)
{
    TwoSpheres two({1, 2, 3}, {1, 2, 3}, 1, 1);
    two.push();
    EXPECT_GT(glm::length(glm::vec3(two.velocities[0]) - glm::vec3(two.velocities[1])), 0.1f);
}

TEST(Spheres, approach_ends_and_parting_goes_on)
{
    TwoSpheres two({0, 0, 0}, {0.01f, 0, 0}, 1, 1);
    two.velocities = {{1, 0, 0, 0}, {-3, 0, 0, 0}};
    two.push();
    EXPECT_NEAR(two.velocities[0].x, -1, 1e-6f);
    EXPECT_NEAR(two.velocities[1].x, -1, 1e-6f);
    const std::vector<glm::vec4> parting = {{-2, 0, 0, 0}, {1, 0, 0, 0}};
    two.velocities = parting;
    two.push();
    EXPECT_EQ(two.velocities, parting);
}

// Coulomb: an impulse J along the normal stops sliding at s <= mu_s J, else it takes mu_k J of it. With k = 1 for both,
// J = c / 2 for the closing speed c, and the relative sliding speed changes by twice the impulse along it.
TEST(Spheres, friction_is_coulombs)
{
    const float closing = 2, mu_static = 0.5f, mu_kinetic = 0.25f;
    for (const float sliding : {0.2f, 0.99f, 1.01f, 3.0f}) {
        TwoSpheres two({0, 0, 0}, {0, 0, 0.01f}, 1, 1);
        two.settings = {0.01f, mu_kinetic, mu_static};
        two.velocities = {{sliding, 0, closing, 0}, {0, 0, 0, 0}};
        two.push();
        const float expected = sliding <= mu_static * closing ? 0 : sliding - mu_kinetic * closing;
        EXPECT_NEAR(two.velocities[0].x - two.velocities[1].x, expected, 1e-5f) << sliding;
        EXPECT_NEAR(two.velocities[0].x + two.velocities[1].x, sliding, 1e-5f) << sliding;
    }
}

// A sheet of vertices alone falls onto one that is pinned, each vertex over the middle of a cell, where it has the
// furthest to fall: it comes to rest near sqrt(d^2 - s^2 / 2), s being the spacing and d the diameter. How much lower:
// each pass of t seconds it falls by g t^2 / 2, which its speed at the start of the pass has to make good; that is the
// parting speed of the overlap divided by the cosine between a pair and the vertical, for four pairs alike.
TEST(Spheres, one_sheet_lies_on_another)
{
    const int n = 9;
    const float spacing = 1.0f / (n - 1), thickness = spacing, step_s = 1.0f / 240;
    Pose pose = flat_sheet(n);
    for (glm::vec4& p : pose.positions) p.w = 0;
    Pose upper = flat_sheet(n - 1);
    for (glm::vec4& p : upper.positions)
        p = glm::vec4(glm::vec2(p) * (1.0f - spacing) + 0.5f * spacing, 1.1f * thickness, 1);
    add_sheets(pose, upper);
    std::vector<glm::vec4> velocities(pose.positions.size());
    ThreadPool pool(1);
    SphereSearch search(pose.rest, pose.sheets);
    const SphereSettings settings{thickness, 0.3f, 0.3f};
    for (int step = 0; step < 480; ++step) {
        for (std::size_t v = 81; v < velocities.size(); ++v) {
            pose.positions[v] += velocities[v] * step_s - glm::vec4(0, 0, 0.5f * 9.81f * step_s * step_s, 0);
            velocities[v].z -= 9.81f * step_s;
        }
        search.sort(pose.positions, thickness);
        push_spheres_apart(search.find(pool), settings, {pose.positions, velocities, step_s});
    }
    const float height = std::sqrt(thickness * thickness - 0.5f * spacing * spacing), cosine = height / thickness;
    const float speed_a_metre = parting_speed(0.999f * thickness, settings, step_s) / (0.001f * thickness);
    const float overlap = 0.5f * 9.81f * step_s * cosine / speed_a_metre;
    for (std::size_t v = 81; v < velocities.size(); ++v)
        EXPECT_NEAR(pose.positions[v].z, height - overlap / cosine, 0.3f * overlap / cosine) << v;
}

}  // namespace
}  // namespace nuno
