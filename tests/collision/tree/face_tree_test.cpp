// The pairs of the tree are those of brute force, whatever the cloth, its numbering, its motion, the threads and the
// machine's vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "collision/tree/face_tree.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

constexpr int kSide = 22;  // vertices; 21 cells: no square of the tree is full
constexpr float kDistance = 0.012f;

// Compares at a pose and, where the cloth moves, over its way; and all distances with those in double.
std::size_t expect_exact(const TreeCase& cloth, float distance)
{
    SCOPED_TRACE(cloth.name);
    ThreadPool pool(1);
    FaceTree tree = cloth.tree();
    std::size_t count = 0;
    for (const Poses& poses : {cloth.still(), cloth.moving()}) {
        tree.refit(poses, {distance, Culling::none}, pool);
        tree.query(pool);
        const std::vector<FacePair> found = sorted_pairs(tree), expected = brute_force_pairs(tree);
        EXPECT_EQ(found.size(), expected.size());
        EXPECT_TRUE(found == expected);
        count += found.size();
    }
    return count;
}

// Every numbering and cutting of one cloth.
std::vector<TreeCase> forms_of(const TreeCase& cloth, std::uint32_t seed)
{
    const TreeCase other = cut_the_other_way(cloth), mixed = cut_at_random(cloth, seed);
    TreeCase mesh = mixed;
    mesh.sheets[0].columns = mesh.sheets[0].rows = 0;
    mesh.name += " as a mesh";
    return {cloth, in_random_order(cloth, seed), other, in_random_order(other, seed),
            mixed, in_random_order(mixed, seed), mesh,  in_random_order(mesh, seed)};
}

TEST(FaceTree, finds_the_pairs_of_brute_force_in_every_form_of_hard_poses)
{
    for (const TreeCase& cloth : hard_cases(kSide))
        for (const TreeCase& form : forms_of(cloth, 3)) expect_exact(form, kDistance);
}

TEST(FaceTree, finds_the_pairs_of_brute_force_over_a_fast_step)
{
    const std::vector<TreeCase> cases = hard_cases(kSide);
    for (std::size_t k = 0; k < cases.size(); ++k) {
        std::vector<glm::vec4> end = cases[(k + 1) % cases.size()].t0;
        for (glm::vec4& p : end) p += glm::vec4(3, -40, 7, 0);  // all together: takes no part
        for (const TreeCase& form : forms_of(moved_to(cases[k], shaken(end, 0.03f, 5)), 4))
            EXPECT_GT(expect_exact(form, kDistance), 0u);
    }
}

TEST(FaceTree, what_all_vertices_do_together_brings_no_pairs)
{
    ThreadPool pool(1);
    TreeCase cloth = as_grid("flat", flat_sheet(kSide), kSide, kSide);
    for (glm::vec4& p : cloth.t1) p += glm::vec4(1, 2, 4, 0);  // whole numbers, so that nothing is rounded away
    FaceTree tree = cloth.tree();
    tree.refit(cloth.still(), {kDistance, Culling::none}, pool);
    tree.query(pool);
    const std::size_t still = tree.pair_count();
    tree.refit(cloth.moving(), {kDistance, Culling::none}, pool);
    tree.query(pool);
    EXPECT_EQ(tree.pair_count(), still);
}

TEST(FaceTree, finds_pairs_between_sheets_of_every_kind)
{
    const TreeCase stack = as_mesh("stack", stacked_sheets(9, 4, 1));
    const TreeCase grid = as_grid("crumple", crumpled_sheet(17, 0.08f, 3), 17, 17);
    const TreeCase small = as_grid("small", flat_sheet(4), 4, 4);
    const TreeCase mixed = cut_at_random(as_grid("roll", rolled_sheet(12, 0.05f), 12, 12), 2);
    EXPECT_GT(expect_exact(together(together(small, grid), together(stack, mixed)), 0.03f), 0u);
    EXPECT_GT(expect_exact(together(grid, in_random_order(grid, 9)), 0.03f), 0u);
    EXPECT_GT(expect_exact(together(grid, small), 0.03f), 0u);
}

TEST(FaceTree, finds_the_pairs_of_grids_of_every_shape)
{
    for (const auto& [columns, rows] :
         {std::pair{2, 2}, {2, 3}, {3, 2}, {2, 200}, {190, 3}, {5, 5}, {66, 9}, {17, 65}, {131, 4}})
    {
        const TriangleMesh mesh = grid_mesh(columns, rows, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        Pose pose{mesh.positions, {}, mesh.faces};
        for (const glm::vec3& p : mesh.positions) pose.positions.emplace_back(0.2f * p.x, 0.2f * p.y, 0, 1);
        TreeCase cloth = as_grid(std::to_string(columns) + " x " + std::to_string(rows), pose, columns, rows);
        cloth = moved_to(cloth, shaken(pose.positions, 0.02f, 1));
        expect_exact(cloth, 0.01f);
        expect_exact(in_random_order(cloth, 1), 0.01f);
    }
}

TEST(FaceTree, finds_the_pairs_of_faces_at_random)
{
    for (const int count : {1, 2, 3, 5, 17, 300, 1500}) {
        const TreeCase soup = as_mesh("soup of " + std::to_string(count), face_soup(count, std::uint32_t(count)));
        expect_exact(moved_to(soup, shaken(soup.t0, 0.1f, 2)), 0.01f);
    }
}

TEST(FaceTree, takes_duplicated_vertices_and_faces_without_area)
{
    Pose pose = crumpled_sheet(kSide, 0.05f, 7);
    for (std::size_t v = 0; v + 1 < pose.positions.size(); v += 7) pose.positions[v] = pose.positions[v + 1];
    expect_exact(as_grid("duplicates", pose, kSide, kSide), kDistance);
    for (glm::vec4& p : pose.positions) p = {1, 2, 3, 0};
    const TreeCase point = as_grid("all in one point", pose, kSide, kSide);
    EXPECT_GT(expect_exact(point, kDistance), 0u);
    EXPECT_GT(expect_exact(point, 0.0f), 0u);
    const TreeCase points = in_random_order(as_mesh("all in one point", pose), 1);
    expect_exact(points, 0.0f);
}

// Far out, where a float holds half a millimetre, no pair within the distance gets lost.
TEST(FaceTree, loses_nothing_at_ten_kilometres)
{
    ThreadPool pool(1);
    const glm::vec4 far(1e4f, -1e4f, 9e3f, 0);
    TreeCase cloth = as_grid("crumple", crumpled_sheet(17, 0.1f, 5), 17, 17);
    for (auto* positions : {&cloth.t0, &cloth.t1})
        for (glm::vec4& p : *positions) p += far;
    cloth = moved_to(cloth, shaken(cloth.t0, 0.05f, 6));
    expect_exact(cloth, 0.004f);
    FaceTree tree = cloth.tree();
    tree.refit(cloth.still(), {0.004f, Culling::none}, pool);
    tree.query(pool);
    const std::vector<FacePair> found = sorted_pairs(tree);
    std::size_t near = 0, lost = 0;
    for (std::uint32_t a = 0; a < cloth.faces.size(); ++a)
        for (std::uint32_t b = a + 1; b < cloth.faces.size(); ++b) {
            if (share_vertex(cloth.faces[a], cloth.faces[b])) continue;
            if (face_distance(cloth, cloth.still(), {a, b}, 0) > 0.004) continue;
            ++near;
            lost += !std::binary_search(found.begin(), found.end(), FacePair{a, b});
        }
    EXPECT_GT(near, 100u);
    EXPECT_EQ(lost, 0u);
}

TEST(FaceTree, faces_that_share_a_vertex_never_come_up_and_a_flat_sheet_has_few_pairs)
{
    ThreadPool pool(1);
    const TreeCase cloth = as_grid("flat", flat_sheet(kSide), kSide, kSide);
    FaceTree tree = cloth.tree();
    tree.refit(cloth.still(), {1e-4f, Culling::none}, pool);
    tree.query(pool);
    for (const FacePair pair : sorted_pairs(tree)) EXPECT_FALSE(share_vertex(cloth.faces[pair.a], cloth.faces[pair.b]));
    EXPECT_LE(tree.pair_count(), 5u * 21 * 21);
}

// Sheets large enough for the work to be shared out.
TreeCase large_case()
{
    const TreeCase grid = as_grid("crumple", crumpled_sheet(72, 0.06f, 8), 72, 72);
    const TreeCase mesh = in_random_order(as_mesh("roll", rolled_sheet(40, 0.02f)), 8);
    const TreeCase both = together(grid, mesh);
    return moved_to(both, shaken(both.t0, 0.01f, 8));
}

std::vector<std::vector<FacePair>> parts_with(const TreeCase& cloth, int threads, int lanes, Culling culling)
{
    ThreadPool pool(threads);
    FaceTree tree = cloth.tree();
    tree.use_lanes(lanes);
    tree.refit(cloth.moving(), {0.01f, culling}, pool);
    tree.query(pool);
    std::vector<std::vector<FacePair>> parts;
    for (const std::span<const FacePair> part : tree.pairs()) parts.emplace_back(part.begin(), part.end());
    return parts;
}

TEST(FaceTreeThreads, pairs_and_their_order_do_not_depend_on_the_number_of_threads)
{
    const TreeCase cloth = large_case();
    for (const Culling culling : {Culling::none, Culling::seed, Culling::sound}) {
        const auto one = parts_with(cloth, 1, 16, culling);
        EXPECT_GT(one.size(), 8u);
        EXPECT_TRUE(parts_with(cloth, 2, 16, culling) == one);
        EXPECT_TRUE(parts_with(cloth, 3, 16, culling) == one);
    }
}

TEST(FaceTree, pairs_and_their_order_do_not_depend_on_the_width_of_vectors)
{
    const TreeCase cloth = large_case();
    for (const Culling culling : {Culling::none, Culling::seed, Culling::sound}) {
        const auto narrow = parts_with(cloth, 1, 4, culling);
        EXPECT_TRUE(parts_with(cloth, 1, 8, culling) == narrow);
        EXPECT_TRUE(parts_with(cloth, 1, 16, culling) == narrow);
    }
}

TEST(FaceTree, pairs_and_their_order_do_not_depend_on_what_was_asked_before)
{
    ThreadPool pool(1);
    const TreeCase cloth = large_case();
    FaceTree tree = cloth.tree();
    const auto parts = [&](const Poses& poses, float distance, Culling culling) {
        tree.refit(poses, {distance, culling}, pool);
        tree.query(pool);
        std::vector<std::vector<FacePair>> all;
        for (const std::span<const FacePair> part : tree.pairs()) all.emplace_back(part.begin(), part.end());
        return all;
    };
    const auto first = parts(cloth.moving(), 0.01f, Culling::none);
    parts(cloth.still(), 0.05f, Culling::sound);
    EXPECT_TRUE(parts(cloth.moving(), 0.01f, Culling::none) == first);
}

}  // namespace
}  // namespace nuno
