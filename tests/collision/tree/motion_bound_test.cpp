// A query that is left out loses nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "collision/tree/motion_bound.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

TEST(MotionBound, without_a_query_nothing_is_covered)
{
    ThreadPool pool(1);
    const TreeCase cloth = as_grid("flat", flat_sheet(5), 5, 5);
    MotionBound bound;
    EXPECT_FALSE(bound.covers(cloth.still(), 0, pool));
    bound.note_query(cloth.still(), 0.01f);
    EXPECT_TRUE(bound.covers(cloth.still(), 0.01f, pool));
    EXPECT_FALSE(bound.covers(cloth.still(), 0.0101f, pool));
    bound.forget();
    EXPECT_FALSE(bound.covers(cloth.still(), 0, pool));
}

TEST(MotionBound, what_all_vertices_do_together_uses_up_nothing)
{
    ThreadPool pool(1);
    TreeCase cloth = as_grid("flat", flat_sheet(5), 5, 5);
    MotionBound bound;
    bound.note_query(cloth.still(), 0.01f);
    for (glm::vec4& p : cloth.t1) p += glm::vec4(0, -30, 0, 0);
    EXPECT_TRUE(bound.covers({cloth.t1, cloth.t1}, 0.0099f, pool));
    cloth.t1[3].x += 0.006f;
    EXPECT_TRUE(bound.covers({cloth.t1, cloth.t1}, 0.0039f, pool));
    EXPECT_FALSE(bound.covers({cloth.t1, cloth.t1}, 0.0041f, pool));
    EXPECT_TRUE(bound.covers(cloth.moving(), 0.0039f, pool)) << "at every time of the way they are together";
    EXPECT_FALSE(bound.covers(cloth.moving(), 0.0041f, pool));
}

TEST(MotionBound, some_of_the_vertices_cover_nothing)
{
    ThreadPool pool(1);
    TreeCase cloth = as_grid("flat", flat_sheet(9), 9, 9);
    MotionBound some, all;
    some.note_some(cloth.still());
    all.note_query(cloth.still(), 1);
    EXPECT_FALSE(some.covers(cloth.still(), 0, pool));
    cloth.t1 = shaken(cloth.t0, 0.1f, 3);
    EXPECT_GT(some.relative_motion(cloth.moving(), pool), 0.05);
    EXPECT_LE(some.relative_motion(cloth.moving(), pool), all.relative_motion(cloth.moving(), pool));
}

// Random steps from a crumpled pose, until the bound asks for a new query: at every one of them the list of the first
// query holds all pairs within the distance.
TEST(MotionBound, the_list_of_one_query_holds_until_the_bound_ends)
{
    ThreadPool pool(1);
    constexpr float kFoundWithin = 0.03f, kDistance = 0.004f;
    TreeCase cloth = as_grid("crumple", crumpled_sheet(17, 0.06f, 4), 17, 17);
    FaceTree tree = cloth.tree();
    tree.refit(cloth.still(), {kFoundWithin, Culling::sound}, pool);
    tree.query(pool);
    const std::vector<FacePair> list = sorted_pairs(tree);
    MotionBound bound;
    bound.note_query(cloth.still(), kFoundWithin);

    std::size_t steps = 0, near = 0;
    for (;; ++steps) {
        cloth.t1 = shaken(cloth.t0, 0.002f, static_cast<std::uint32_t>(steps + 1));
        for (glm::vec4& p : cloth.t1) p += glm::vec4(0.1f, 0.2f, -0.3f, 0);
        if (!bound.covers({cloth.t1, cloth.t1}, kDistance, pool)) break;
        for (std::uint32_t a = 0; a < cloth.faces.size(); ++a)
            for (std::uint32_t b = a + 1; b < cloth.faces.size(); ++b) {
                if (share_vertex(cloth.faces[a], cloth.faces[b])) continue;
                if (face_distance(cloth, {cloth.t1, cloth.t1}, {a, b}, 0) > kDistance) continue;
                ++near;
                EXPECT_TRUE(std::binary_search(list.begin(), list.end(), FacePair{a, b}));
            }
        cloth.t0 = cloth.t1;
    }
    EXPECT_GT(steps, 1u);
    EXPECT_GT(near, 100u);
}

// A way that is noted, and others beside it: at any time of them the list of the first holds all pairs near then.
TEST(MotionBound, the_list_of_a_way_holds_for_ways_beside_it)
{
    ThreadPool pool(1);
    constexpr float kDistance = 0.004f;
    TreeCase cloth = as_grid("crumple", crumpled_sheet(17, 0.06f, 4), 17, 17);
    cloth.t1 = crumpled_sheet(17, 0.08f, 9).positions;
    const std::vector<glm::vec4> t0 = cloth.t0, t1 = cloth.t1;
    MotionBound bound;
    bound.note_query(cloth.moving(), 0);
    std::size_t near = 0;
    for (std::uint32_t seed = 1; seed < 4; ++seed) {
        TreeCase beside = cloth;
        beside.t0 = shaken(t0, 0.003f, seed);
        beside.t1 = shaken(t1, 0.003f, seed + 10);
        for (glm::vec4& p : beside.t1) p += glm::vec4(2, 1, 0, 0);
        const double moved = bound.relative_motion(beside.moving(), pool);
        EXPECT_GT(moved, 0.006);
        FaceTree tree = cloth.tree();
        tree.refit(cloth.moving(), {kDistance + static_cast<float>(moved), Culling::sound}, pool);
        tree.query(pool);
        const std::vector<FacePair> list = sorted_pairs(tree);
        for (std::uint32_t a = 0; a < cloth.faces.size(); ++a)
            for (std::uint32_t b = a + 1; b < cloth.faces.size(); ++b) {
                if (share_vertex(cloth.faces[a], cloth.faces[b])) continue;
                const double t = 0.25 * ((a + b) % 5);
                if (face_distance(beside, beside.moving(), {a, b}, t) > kDistance) continue;
                ++near;
                EXPECT_TRUE(std::binary_search(list.begin(), list.end(), FacePair{a, b}));
            }
    }
    EXPECT_GT(near, 100u);
}

}  // namespace
}  // namespace nuno
