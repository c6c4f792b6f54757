// Cloth that crosses itself is taken apart, or said to be left.
#include "collision/untangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "collision/poses.h"

namespace nuno {
namespace {

UntangleResult untangled(const Pose& pose, int threads = 1)
{
    ThreadPool pool(threads);
    TangleSearch search(pose.rest, pose.faces, {});
    return untangle(search, pose.positions, pool);
}

std::vector<Tangle> tangles_in(const Pose& pose, std::span<const glm::vec4> positions)
{
    ThreadPool pool(1);
    return TangleSearch(pose.rest, pose.faces, {}).find(positions, pool);
}

// The largest change of an edge's length, over what it was.
double largest_strain(const Pose& pose, std::span<const glm::vec4> positions)
{
    double largest = 0;
    for (const glm::uvec3& face : pose.faces)
        for (int i = 0; i < 3; ++i) {
            const auto length = [&](std::span<const glm::vec4> x) {
                return glm::distance(glm::vec3(x[face[i]]), glm::vec3(x[face[(i + 1) % 3]]));
            };
            largest = std::max(largest, std::abs(length(positions) / length(pose.positions) - 1.0));
        }
    return largest;
}

// A flat sheet, and another 1 cm above it with a dent that goes through.
Pose dented_pair(int n, float depth)
{
    Pose pose = flat_sheet(n);
    const Pose upper = flat_sheet(n);
    const auto first = static_cast<std::uint32_t>(pose.rest.size());
    for (const glm::vec3& x : upper.rest) {
        const float from_middle_sq = (x.x - 0.52f) * (x.x - 0.52f) + (x.y - 0.47f) * (x.y - 0.47f);
        pose.rest.push_back(x + glm::vec3(0, 0, 1));
        pose.positions.emplace_back(x.x + 0.003f, x.y + 0.002f, 0.01f - depth * std::exp(-from_middle_sq / 0.03f), 1);
    }
    for (const glm::uvec3& face : upper.faces) pose.faces.push_back(face + first);
    return pose;
}

// A flat sheet whose corner is bent over by 240 degrees and goes straight on, so that its tip is through the sheet.
Pose bent_corner(int n)
{
    Pose pose = flat_sheet(n);
    const float fold = 1.025f, radius = 0.05f, turn = 4.2f, root = std::sqrt(2.0f);
    for (glm::vec4& x : pose.positions) {
        const float beyond = (x.x + x.y) / root - fold;
        if (beyond <= 0) continue;
        const float angle = std::min(beyond / radius, turn), straight = beyond - radius * angle;
        const float shift = radius * std::sin(angle) + straight * std::cos(angle) - beyond;
        x.x += shift / root;
        x.y += shift / root;
        x.z += radius * (1 - std::cos(angle)) + straight * std::sin(angle);
    }
    return pose;
}

// Two flat sheets, the upper one tilted so that its rim is `depth` under the lower one.
Pose dipping_rim(int n, float depth)
{
    Pose pose = flat_sheet(n);
    const Pose upper = flat_sheet(n);
    const auto first = static_cast<std::uint32_t>(pose.rest.size());
    for (const glm::vec3& x : upper.rest) {
        pose.rest.push_back(x + glm::vec3(0, 0, 1));
        pose.positions.emplace_back(0.1f + 0.77f * x.x, 0.1f + 0.8f * x.y, 0.03f - (0.03f + depth) * x.y, 1);
    }
    for (const glm::uvec3& face : upper.faces) pose.faces.push_back(face + first);
    return pose;
}

// Two flat sheets that cut halfway into each other, like the lids of a box.
Pose interlocked(int n)
{
    Pose pose = flat_sheet(n);
    const Pose other = flat_sheet(n);
    const auto first = static_cast<std::uint32_t>(pose.rest.size());
    for (const glm::vec3& x : other.rest) {
        pose.rest.push_back(x + glm::vec3(0, 0, 1));
        pose.positions.emplace_back(x.x + 0.71f, 0.51f + 0.5f * (x.y - 0.5f), 0.8f * (x.y - 0.52f), 1);
    }
    for (const glm::uvec3& face : other.faces) pose.faces.push_back(face + first);
    return pose;
}

TEST(Untangle, cloth_that_does_not_cross_is_left_as_it_is)
{
    const Pose pose = folded_sheet(17, 0.05f);
    const UntangleResult result = untangled(pose);
    EXPECT_EQ(result.steps, 0);
    EXPECT_EQ(result.before.crossing, 0u);
    EXPECT_EQ(result.largest_move, 0);
    EXPECT_EQ(result.positions, pose.positions);
}

TEST(Untangle, a_dent_goes_back_through_the_sheet_below)
{
    for (const float depth : {0.02f, 0.05f}) {
        const Pose pose = dented_pair(24, depth);
        const UntangleResult result = untangled(pose);
        EXPECT_GT(result.before.crossing, 20u);
        EXPECT_EQ(result.left.crossing, 0u) << depth;
        EXPECT_TRUE(tangles_in(pose, result.positions).empty());
        EXPECT_LT(result.largest_move, 2 * depth);
        EXPECT_LT(largest_strain(pose, result.positions), 0.2);
    }
}

// Of more than `crossing` pairs at the start none is left; the result.
UntangleResult expect_apart(const Pose& pose, std::uint64_t crossing)
{
    UntangleResult result = untangled(pose);
    EXPECT_GT(result.before.crossing, crossing);
    EXPECT_EQ(result.left.crossing, 0u);
    EXPECT_TRUE(tangles_in(pose, result.positions).empty());
    return result;
}

TEST(Untangle, a_corner_bent_through_its_own_sheet_comes_out)
{
    const Pose pose = bent_corner(33);
    EXPECT_LT(largest_strain(pose, expect_apart(pose, 5).positions), 0.2);
}

TEST(Untangle, a_rim_that_dips_through_a_sheet_comes_up)
{
    const Pose pose = dipping_rim(24, 0.01f);
    EXPECT_LT(largest_strain(pose, expect_apart(pose, 50).positions), 0.1);
}

TEST(Untangle, sheets_that_have_cut_half_into_each_other_come_apart) { expect_apart(interlocked(16), 10); }

// Both sheets are held at all of their rims.
TEST(Untangle, what_does_not_come_apart_is_counted_and_left)
{
    Pose pose = interlocked(16);
    for (std::size_t v = 0; v < pose.positions.size(); ++v) {
        const glm::vec3 rest = pose.rest[v];
        if (std::min(rest.x, rest.y) == 0 || std::max(rest.x, rest.y) == 1) pose.positions[v].w = 0;
    }
    const UntangleResult result = untangled(pose);
    EXPECT_GT(result.left.crossing, 0u);
    EXPECT_LE(result.left.all(), result.before.all());
    EXPECT_EQ(tangles_in(pose, result.positions).size(), result.left.all());
}

// There is no line to shorten.
TEST(Untangle, layers_in_one_plane_come_apart)
{
    Pose pose = dipping_rim(12, -0.03f);
    for (std::size_t v = pose.rest.size() / 2; v < pose.rest.size(); ++v) pose.positions[v].z = 0;
    const UntangleResult result = untangled(pose);
    EXPECT_GT(result.before.touching, 100u);
    EXPECT_EQ(result.before.crossing, 0u);
    EXPECT_EQ(result.left.all(), 0u);
    EXPECT_LT(result.largest_move, 0.03f);
}

TEST(Untangle, pinned_vertices_stay)
{
    Pose pose = dented_pair(24, 0.03f);
    for (std::size_t v = 0; v < 24 * 24; ++v) pose.positions[v].w = 0;
    const UntangleResult result = untangled(pose);
    EXPECT_EQ(result.left.crossing, 0u);
    for (std::size_t v = 0; v < 24 * 24; ++v) EXPECT_EQ(result.positions[v], pose.positions[v]);
}

TEST(Untangle, does_not_depend_on_the_number_of_threads)
{
    const Pose pose = dented_pair(40, 0.02f);
    const UntangleResult one = untangled(pose, 1), three = untangled(pose, 3);
    EXPECT_EQ(one.positions, three.positions);
    EXPECT_EQ(one.steps, three.steps);
}

}  // namespace
}  // namespace nuno
