// The continuous levels, against every pair tested by itself.
#include "collision/continuous.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <tuple>

#include <glm/geometric.hpp>

#include "collision/ccd/impact.h"
#include "collision/poses.h"
#include "core/task_share.h"

namespace nuno {
namespace {

using Key = std::array<std::uint32_t, 5>;

Key key_of(const ElementPair& pair)
{
    glm::uvec4 v = pair.vertices;
    if (pair.kind == PairKind::edge_edge) {
        if (v.x > v.y) std::swap(v.x, v.y);
        if (v.z > v.w) std::swap(v.z, v.w);
        if (std::tie(v.z, v.w) < std::tie(v.x, v.y)) {
            std::swap(v.x, v.z);
            std::swap(v.y, v.w);
        }
    } else {
        std::array<std::uint32_t, 3> face{v.y, v.z, v.w};
        std::sort(face.begin(), face.end());
        v = {v.x, face[0], face[1], face[2]};
    }
    return {static_cast<std::uint32_t>(pair.kind), v.x, v.y, v.z, v.w};
}

// Every vertex with every face, every edge with every other, that share no vertex.
std::vector<ElementPair> all_pairs(const Pose& pose)
{
    std::vector<ElementPair> pairs;
    for (std::uint32_t f = 0; f < pose.faces.size(); ++f)
        for (std::uint32_t v = 0; v < pose.positions.size(); ++v) {
            const glm::uvec3& face = pose.faces[f];
            if (v != face.x && v != face.y && v != face.z)
                pairs.push_back({PairKind::vertex_face, {v, face.x, face.y, face.z}, f});
        }
    const FaceElements elements(pose.faces, static_cast<std::uint32_t>(pose.positions.size()));
    const std::span<const glm::uvec2> edges = elements.edges();
    for (std::size_t a = 0; a < edges.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const glm::uvec2 &p = edges[a], &q = edges[b];
            if (p.x != q.x && p.x != q.y && p.y != q.x && p.y != q.y)
                pairs.push_back({PairKind::edge_edge, {p.x, p.y, q.x, q.y}, 0});
        }
    return pairs;
}

std::vector<Key> sorted_keys(const std::vector<ElementPair>& pairs)
{
    std::vector<Key> keys;
    for (const ElementPair& pair : pairs) keys.push_back(key_of(pair));
    std::sort(keys.begin(), keys.end());
    return keys;
}

std::vector<ElementPair> found_pairs(const Pose& pose, std::span<const glm::vec4> end, float distance, Culling culling)
{
    ThreadPool pool(1);
    ElementQuery query(pose.rest, pose.faces);
    const int tasks = query.begin({pose.positions, end}, {distance, culling}, pool);
    std::vector<ElementPair> pairs;
    for (int task = 0; task < tasks; ++task) query.run(task, [&](const ElementPair& pair) { pairs.push_back(pair); });
    return pairs;
}

bool come_near(const ElementPair& pair, const Pose& pose, std::span<const glm::vec4> end, double distance)
{
    FourPoints t0, t1;
    for (std::size_t i = 0; i < 4; ++i) {
        t0[i] = glm::dvec3(pose.positions[pair.vertices[int(i)]]);
        t1[i] = glm::dvec3(end[pair.vertices[int(i)]]);
    }
    return impact_of_near_pair(pair.kind, t0, t1, distance).has_value();
}

// Of all pairs, by the exact test; and what is found is less than all.
void expect_all_near_pairs(const Pose& pose, float way, float distance)
{
    const std::vector<glm::vec4> end = shaken(pose.positions, way, 3);
    std::vector<ElementPair> near;
    const std::vector<ElementPair> all = all_pairs(pose);
    for (const ElementPair& pair : all)
        if (come_near(pair, pose, end, double(distance))) near.push_back(pair);
    const std::vector<Key> expected = sorted_keys(near);
    EXPECT_FALSE(expected.empty());
    for (const Culling culling : {Culling::none, Culling::sound}) {
        const std::vector<Key> found = sorted_keys(found_pairs(pose, end, distance, culling));
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
        EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
        EXPECT_LT(found.size(), all.size() / 2);
    }
}

TEST(ElementQuery, finds_every_pair_that_comes_near_once)
{
    expect_all_near_pairs(flat_sheet(8), 0.0f, 0.15f);
    expect_all_near_pairs(crumpled_sheet(9, 0.4f, 5), 0.1f, 0.01f);
    expect_all_near_pairs(folded_sheet(9, 0.01f), 0.05f, 0.0f);
    expect_all_near_pairs(rolled_sheet(9, 0.02f), 0.02f, 0.005f);
    expect_all_near_pairs(stacked_sheets(5, 3, 2), 0.05f, 0.01f);
    expect_all_near_pairs(face_soup(40, 4), 0.1f, 0.0f);
}

ClothModel model_of(const Pose& pose)
{
    SheetSource source;
    source.name = "cloth";
    source.mesh.positions = pose.rest;
    source.mesh.faces = pose.faces;
    return build_cloth_model(std::span(&source, 1), MassLumping::area);
}

std::size_t impacts_left(const Pose& pose, std::span<const glm::vec4> end)
{
    std::size_t count = 0;
    for (const ElementPair& pair : all_pairs(pose)) {
        FourPoints t0, t1;
        for (int i = 0; i < 4; ++i) {
            t0[std::size_t(i)] = glm::dvec3(pose.positions[pair.vertices[i]]);
            t1[std::size_t(i)] = glm::dvec3(end[pair.vertices[i]]);
        }
        count +=
            (pair.kind == PairKind::vertex_face ? vertex_face_impact(t0, t1) : edge_edge_impact(t0, t1)).has_value();
    }
    return count;
}

struct Responded
{
    std::vector<glm::vec4> end, velocities;
    CollisionCounts counts;
};

Responded respond(const Pose& pose, const std::vector<glm::vec4>& end, bool guaranteed, int threads = 1,
                  float budget_ms = 0)
{
    const ClothModel model = model_of(pose);
    ThreadPool pool(threads);
    ContinuousCollision collision(model, pool);
    Responded result{end, std::vector<glm::vec4>(end.size(), glm::vec4(0)), {}};
    result.counts =
        collision.respond({pose.positions, result.end, result.velocities, 1.0f / 60}, {.thickness = 0.005f,
                                                                                       .friction = 0.2f,
                                                                                       .static_friction = 0.3f,
                                                                                       .guaranteed = guaranteed,
                                                                                       .budget_ms = budget_ms});
    return result;
}

// Layers thrown through one another.
std::vector<glm::vec4> thrown(const Pose& pose, float way) { return shaken(pose.positions, way, 17); }

TEST(Guaranteed, leaves_no_impact_whatever_the_motion)
{
    std::uint32_t rollbacks = 0;
    for (const float way : {0.02f, 0.2f, 2.0f})
        for (const Pose& pose : {flat_sheet(7), folded_sheet(7, 0.02f), stacked_sheets(5, 3, 2)}) {
            const std::vector<glm::vec4> end = thrown(pose, way);
            ASSERT_EQ(impacts_left(pose, pose.positions), 0u) << "the start is not clean";
            const Responded result = respond(pose, end, true);
            EXPECT_EQ(impacts_left(pose, result.end), 0u) << way;
            EXPECT_EQ(result.counts.unresolved, 0u);
            EXPECT_TRUE(result.counts.impacts > 0 || way < 0.1f);
            rollbacks += result.counts.rollbacks;
        }
    EXPECT_GT(rollbacks, 0u) << "impulses alone were enough";
}

TEST(Guaranteed, leaves_no_impact_when_its_time_is_up)
{
    for (const Pose& pose : {folded_sheet(7, 0.02f), stacked_sheets(5, 3, 2)}) {
        const Responded result = respond(pose, thrown(pose, 0.2f), true, 1, 1e-6f);
        EXPECT_GT(result.counts.rollbacks, 0u);
        EXPECT_GT(result.counts.largest_zone, 3u);
        EXPECT_GT(result.counts.lost_m, 0.0);
        EXPECT_EQ(impacts_left(pose, result.end), 0u);
    }
}

TEST(Continuous, counts_what_it_could_not_answer)
{
    const Pose pose = stacked_sheets(5, 3, 2);
    const Responded result = respond(pose, thrown(pose, 2.0f), false);
    EXPECT_GT(result.counts.unresolved, 0u);
    EXPECT_LE(impacts_left(pose, result.end), result.counts.unresolved);
}

TEST(Guaranteed, changes_the_velocity_by_what_it_took_of_the_way)
{
    const Pose pose = stacked_sheets(5, 2, 2);
    const std::vector<glm::vec4> end = thrown(pose, 0.5f);
    const Responded result = respond(pose, end, true);
    for (std::size_t v = 0; v < end.size(); ++v) {
        const glm::vec3 expected = (glm::vec3(result.end[v]) - glm::vec3(end[v])) * 60.0f;
        EXPECT_LT(glm::length(glm::vec3(result.velocities[v]) - expected), 1e-3f);
    }
}

// Two layers a thousandth of a millimetre apart whose edges are nearly parallel.
Pose close_layers()
{
    Pose pose;
    pose.positions = {{0, 0, -0.03f, 1},    {0.03f, 0, -0.03f, 1},   {0, 0, 0, 1},
                      {0.03f, 0, 0, 1},     {0, 1e-6f, -12e-6f, 1},  {0.03f, 1e-6f, 12e-6f, 1},
                      {0, 1e-6f, 0.03f, 1}, {0.03f, 1e-6f, 0.03f, 1}};
    pose.rest.assign(pose.positions.begin(), pose.positions.end());
    pose.faces = {{0, 2, 1}, {1, 2, 3}, {4, 6, 5}, {5, 6, 7}};
    return pose;
}

TEST(Guaranteed, lets_layers_move_that_are_very_close)
{
    const Pose pose = close_layers();
    ASSERT_EQ(impacts_left(pose, pose.positions), 0u);
    std::vector<glm::vec4> end = pose.positions;
    for (glm::vec4& x : end) x.y -= 0.25f;
    const Responded result = respond(pose, end, true);
    EXPECT_EQ(result.counts.standstills, 0u);
    EXPECT_EQ(result.counts.rollbacks, 0u);
    EXPECT_LT(result.end[0].y, -0.2f);
}

TEST(Guaranteed, counts_pairs_that_touch_at_the_start_and_ends)
{
    Pose pose = close_layers();
    for (glm::vec4& x : pose.positions) x.y = 0;
    const Responded result = respond(pose, thrown(pose, 0.1f), true);
    EXPECT_GT(result.counts.touching, 0u);
}

TEST(Guaranteed, touches_nothing_that_meets_nothing)
{
    const Pose pose = stacked_sheets(5, 2, 2);
    std::vector<glm::vec4> end = pose.positions;
    for (glm::vec4& x : end) x += glm::vec4(3, 2, 1, 0);
    const Responded result = respond(pose, end, true);
    EXPECT_EQ(result.counts.impacts, 0u);
    EXPECT_EQ(result.end, end);
}

TEST(Guaranteed, gives_the_same_bits_on_any_number_of_threads)
{
    const Pose pose = stacked_sheets(9, 3, 2);
    const std::vector<glm::vec4> end = thrown(pose, 0.3f);
    const Responded one = respond(pose, end, true, 1);
    for (const int threads : {2, 3}) {
        const Responded more = respond(pose, end, true, threads);
        EXPECT_EQ(one.end, more.end);
        EXPECT_EQ(one.velocities, more.velocities);
    }
}

// What could come within the thickness on the way foreseen is among the contacts, unless it is a neighbour.
TEST(Speculative, foresees_layers_that_near_each_other)
{
    Pose pose = stacked_sheets(2, 2, 1);
    // Two squares 3 cm apart, the upper one falling.
    pose.positions = {{0, 0, 0, 1},           {1, 0, 0, 1},           {0, 1, 0, 1},           {1, 1, 0, 1},
                      {0.2f, 0.2f, 0.03f, 1}, {0.8f, 0.2f, 0.03f, 1}, {0.2f, 0.8f, 0.03f, 1}, {0.8f, 0.8f, 0.03f, 1}};
    const ClothModel model = model_of(pose);
    ThreadPool pool(1);
    ContinuousCollision collision(model, pool);
    std::vector<glm::vec4> velocities(8, glm::vec4(0));
    const LayerSettings settings{.thickness = 0.005f, .friction = 0, .static_friction = 0, .guaranteed = false};
    EXPECT_TRUE(collision.foresee(pose.positions, velocities, 1.0f / 60, settings).contacts.empty());
    for (std::size_t v = 4; v < 8; ++v) velocities[v].z = -3;
    const auto contacts = collision.foresee(pose.positions, velocities, 1.0f / 60, settings).contacts;
    for (std::uint32_t v = 4; v < 8; ++v)
        EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [&](const LayerContact& c) {
            return c.kind == 0.0f && c.vertices.x == v && c.normal.z > 0.9f;
        })) << v;
}

}  // namespace
}  // namespace nuno
