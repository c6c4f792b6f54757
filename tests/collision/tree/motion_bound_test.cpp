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
    EXPECT_FALSE(bound.covers(cloth.moving(), 0, pool)) << "between the poses they are not together";
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

}  // namespace
}  // namespace nuno
