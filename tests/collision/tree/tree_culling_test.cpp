// What culling leaves out: with Culling::sound nothing that comes within the distance, at any time of the way; with
// Culling::seed a number that is printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>

#include "collision/tree/culling_outcome.h"
#include "collision/tree/face_tree.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

// Small waves on a sheet that is bent, pressed together along one side by `pressed`.
TreeCase wavy(int n, float amplitude, float pressed, std::uint32_t seed)
{
    TreeCase cloth = as_grid("waves of " + std::to_string(amplitude), flat_sheet(n), n, n);
    for (glm::vec4& p : cloth.t0) {
        const float u = p.x, v = p.y;
        p = glm::vec4(u * (1 - pressed), v, amplitude * std::sin(9 * u + 4 * v) + 0.5f * amplitude * std::sin(23 * v),
                      1);
    }
    cloth.t0 = shaken(cloth.t0, 0.02f * amplitude, seed);
    cloth.t1 = cloth.t0;
    return cloth;
}

std::vector<TreeCase> culling_cases()
{
    std::vector<TreeCase> cases = hard_cases(33);
    cases.push_back(as_grid("wide roll", rolled_sheet(49, 0.1f), 49, 49));
    cases.push_back(as_grid("wide fold", folded_sheet(41, 0.2f), 41, 41));
    for (const float amplitude : {0.02f, 0.05f, 0.1f, 0.2f}) cases.push_back(wavy(37, amplitude, 0.3f, 3));
    for (const float amplitude : {0.01f, 0.03f, 0.06f})
        cases.push_back(as_grid("crumple " + std::to_string(amplitude), crumpled_sheet(41, amplitude, 11), 41, 41));
    return cases;
}

TEST(TreeCulling, sound_loses_no_pair_within_the_distance)
{
    std::size_t near = 0, left_out = 0;
    for (const TreeCase& cloth : culling_cases())
        for (const TreeCase& form : {cloth, in_random_order(cut_at_random(cloth, 1), 2)})
            for (const float distance : {0.0f, 0.002f, 0.01f, 0.03f}) {
                SCOPED_TRACE(form.name + ", distance " + std::to_string(distance));
                const CullingOutcome outcome = culling_outcome(form, form.still(), distance, Culling::sound);
                EXPECT_EQ(outcome.lost, 0u);
                EXPECT_GT(outcome.nearest_left_out, distance);
                near += outcome.near;
                left_out += outcome.left_out;
            }
    EXPECT_GT(near, 10000u);
    EXPECT_GT(left_out, 10000u);
    std::cout << "sound: " << near << " pairs within the distance, none lost; " << left_out << " left out\n";
}

TEST(TreeCulling, sound_loses_no_pair_at_any_time_of_a_way)
{
    std::size_t near = 0, left_out = 0;
    for (const TreeCase& cloth : culling_cases()) {
        TreeCase back = cloth;  // rippled through, or turned inside out
        for (glm::vec4& p : back.t1) p.z = -p.z;
        const TreeCase rippled = moved_to(cloth, shaken(cloth.t0, 0.01f, 4));
        for (const TreeCase& way : {rippled, back, in_random_order(back, 5)})
            for (const float distance : {0.0f, 0.008f}) {
                SCOPED_TRACE(way.name + ", distance " + std::to_string(distance));
                const CullingOutcome outcome = culling_outcome(way, way.moving(), distance, Culling::sound);
                EXPECT_EQ(outcome.lost, 0u);
                near += outcome.near;
                left_out += outcome.left_out;
            }
    }
    EXPECT_GT(near, 5000u);
    EXPECT_GT(left_out, 10000u);
    std::cout << "sound, moving: " << near << " pairs looked at within the distance, none lost; " << left_out
              << " left out\n";
}

// Vertices and edges of faces that share a vertex are in no list: they come near only where that is not ruled out.
TEST(TreeCulling, sound_knows_which_faces_are_apart_from_their_neighbours)
{
    ThreadPool pool(1);
    std::size_t ruled_out = 0, others = 0;
    for (const TreeCase& cloth : {wavy(33, 0.1f, 0.3f, 3), in_random_order(wavy(33, 0.1f, 0.5f, 3), 1),
                                  as_grid("crumple", crumpled_sheet(33, 0.05f, 2), 33, 33)})
    {
        FaceTree tree = cloth.tree();
        tree.refit(cloth.still(), {0.01f, Culling::sound}, pool);
        for (std::uint32_t a = 0; a < cloth.faces.size(); ++a) {
            const bool apart = tree.is_apart_from_neighbours(a);
            (apart ? ruled_out : others)++;
            for (std::uint32_t b = 0; apart && b < cloth.faces.size(); ++b)
                if (a != b && share_vertex(cloth.faces[a], cloth.faces[b])) {
                    ASSERT_GT(face_elements_distance(cloth, cloth.still(), {a, b}, 0), 0.01) << a << " and " << b;
                }
        }
    }
    EXPECT_GT(ruled_out, 500u);
    EXPECT_GT(others, 500u);
}

// Two poses without contacts, with one between them: the sheet passes through itself and comes out on the other side.
TEST(TreeCulling, sound_sees_what_happens_between_two_clean_poses)
{
    const int n = 33;
    TreeCase cloth = as_grid("fold", folded_sheet(n, 0.1f), n, n);
    for (std::size_t v = 0; v < cloth.t1.size(); ++v)
        if (cloth.rest[v].x > 0.6f) cloth.t1[v].z = -cloth.t1[v].z;
    const CullingOutcome still = culling_outcome(cloth, cloth.still(), 0.001f, Culling::sound);
    const CullingOutcome moving = culling_outcome(cloth, cloth.moving(), 0.001f, Culling::sound);
    EXPECT_EQ(still.near, 0u);
    EXPECT_GT(moving.near, 100u);
    EXPECT_EQ(moving.lost, 0u);
}

TEST(TreeCulling, sound_proves_a_waving_sheet_apart_and_looks_at_nothing)
{
    ThreadPool pool(1);
    const TreeCase cloth = wavy(65, 0.03f, 0.1f, 7);
    FaceTree tree = cloth.tree();
    tree.refit(cloth.still(), {0.004f, Culling::sound}, pool);
    tree.query(pool);
    EXPECT_TRUE(tree.is_proven_apart());
    EXPECT_EQ(tree.pair_count(), 0u);
    EXPECT_EQ(tree.visits(), 0u);
}

// Two sheets, each clean in itself, are looked at as soon as they meet.
TEST(TreeCulling, sound_finds_what_is_between_two_sheets_that_are_clean_in_themselves)
{
    ThreadPool pool(1);
    const TreeCase sheet = wavy(33, 0.02f, 0.1f, 7);
    for (const float gap : {0.5f, 0.002f}) {
        TreeCase other = sheet;
        for (glm::vec4& p : other.t0) p.z += gap;
        const TreeCase both = together(sheet, other);
        const CullingOutcome outcome = culling_outcome(both, both.still(), 0.004f, Culling::sound);
        EXPECT_EQ(outcome.lost, 0u);
        EXPECT_EQ(outcome.proven_apart, gap > 0.1f);
        EXPECT_EQ(outcome.near > 0, gap < 0.1f);
    }
}

// A cell turned inside out has edges that look harmless one by one.
TEST(TreeCulling, sound_proves_nothing_where_a_triangle_is_turned_over)
{
    TreeCase cloth = as_grid("flat", flat_sheet(9), 9, 9);
    std::swap(cloth.t0[40], cloth.t0[41]);
    const CullingOutcome outcome = culling_outcome(cloth, cloth.still(), 0.01f, Culling::sound);
    EXPECT_FALSE(outcome.proven_apart);
    EXPECT_EQ(outcome.lost, 0u);
}

TEST(TreeCulling, seed_misses_what_lies_between_layers_whose_normals_agree)
{
    std::size_t ramp_lost = 0;
    for (const TreeCase& cloth : hard_cases(33)) {
        const CullingOutcome outcome = culling_outcome(cloth, cloth.still(), 0.022f, Culling::seed);
        std::cout << cloth.name << ": the seed's rule misses " << outcome.lost << " of " << outcome.near
                  << " pairs of faces nearer than 22 mm\n";
        EXPECT_LE(outcome.lost, outcome.near);
        if (cloth.name == "ramp") ramp_lost = outcome.lost;
    }
    EXPECT_GT(ramp_lost, 100u);
}

}  // namespace
}  // namespace nuno
