// The tree of boxes holds every face once, every vertex once, and all that lies below a node.
#include "collision/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "collision/pair_query.h"
#include "collision/poses.h"

namespace nuno {
namespace {

constexpr int kFaceCounts[] = {1, 2, 3, 4, 5, 15, 16, 17, 64, 65, 300};

// Depth of every block below `index`, found by walking down.
void walk(const BoxTree& tree, std::uint32_t index, int depth, std::vector<std::uint32_t>& faces,
          std::vector<int>& depths)
{
    const BoxTree::Node& node = tree.node(index);
    const std::size_t before = faces.size();
    for (const std::uint32_t child : node.child) {
        if (child == BoxTree::kNoChild) continue;
        if (tree.is_block(index))
            faces.push_back(child);
        else
            walk(tree, child, depth + 1, faces, depths);
    }
    if (tree.is_block(index)) depths.push_back(depth);
    EXPECT_EQ(faces.size() - before, node.face_count) << "node " << index;
}

TEST(BoxTree, has_every_face_in_one_leaf_and_all_leaves_at_one_depth)
{
    for (const int count : kFaceCounts) {
        const Pose soup = face_soup(count, 1);
        const BoxTree tree(soup.rest, soup.faces);
        std::vector<std::uint32_t> faces;
        std::vector<int> depths;
        walk(tree, 0, 0, faces, depths);
        std::sort(faces.begin(), faces.end());
        ASSERT_EQ(faces.size(), static_cast<std::size_t>(count));
        for (int face = 0; face < count; ++face) EXPECT_EQ(faces[face], static_cast<std::uint32_t>(face));
        EXPECT_EQ(*std::min_element(depths.begin(), depths.end()), *std::max_element(depths.begin(), depths.end()));
    }
}

TEST(BoxTree, gives_every_vertex_to_one_block_with_a_face_that_has_it_as_a_corner)
{
    const Pose soup = face_soup(300, 2);
    const BoxTree tree(soup.rest, soup.faces);
    std::vector<int> owners(soup.rest.size());
    for (std::uint32_t index = 0; index < tree.node(0).end; ++index) {
        if (!tree.is_block(index)) continue;
        for (const std::uint32_t vertex : tree.vertices(index)) {
            ++owners[vertex];
            const auto& faces = tree.node(index).child;
            EXPECT_TRUE(std::any_of(faces.begin(), faces.end(), [&](std::uint32_t face) {
                if (face == BoxTree::kNoChild) return false;
                const glm::uvec3 corners = soup.faces[face];
                return corners.x == vertex || corners.y == vertex || corners.z == vertex;
            }));
        }
    }
    for (std::size_t vertex = 0; vertex < owners.size(); ++vertex) EXPECT_EQ(owners[vertex], 1) << vertex;
}

TEST(BoxTree, is_the_same_however_often_it_is_built)
{
    const Pose pose = flat_sheet(20);
    const BoxTree first(pose.rest, pose.faces), second(pose.rest, pose.faces);
    ASSERT_EQ(first.node(0).end, second.node(0).end);
    for (std::uint32_t index = 0; index < first.node(0).end; ++index)
        EXPECT_EQ(first.node(index).child, second.node(index).child);
}

// A large and a small mesh, after a refit at two poses.
TEST(BoxTree, boxes_hold_the_corners_of_their_faces_at_both_ends_of_a_sweep)
{
    ThreadPool pool(2);
    for (const int n : {10, 50}) {
        const Pose pose = crumpled_sheet(n, 0.1f, 3);
        const std::vector<glm::vec4> moved = shaken(pose.positions, 0.1f, 4);
        BoxTree tree(pose.rest, pose.faces);
        tree.refit_swept(pose.positions, moved, {0, 0.01f}, pool);
        for (std::uint32_t index = 0; index < tree.node(0).end; ++index) {
            const BoxTree::Node& node = tree.node(index);
            for (int slot = 0; tree.is_block(index) && slot < 4 && node.child[slot] != BoxTree::kNoChild; ++slot) {
                const glm::uvec3 face = pose.faces[node.child[slot]];
                for (int corner = 0; corner < 3; ++corner)
                    for (const glm::vec4& p : {pose.positions[face[corner]], moved[face[corner]]})
                        for (int axis = 0; axis < 3; ++axis) {
                            EXPECT_LE(node.lo[axis][slot] + 0.0099f, p[axis]);
                            EXPECT_GE(node.hi[axis][slot] - 0.0099f, p[axis]);
                        }
            }
        }
    }
}

TEST(BoxTree, query_pairs_every_block_with_itself_and_finds_no_pair_twice)
{
    ThreadPool pool(1);
    const Pose pose = crumpled_sheet(20, 0.1f, 5);
    BoxTree tree(pose.rest, pose.faces);
    tree.refit(pose.positions, {0.05f, 0.005f}, pool);
    TreeQuery query;
    query.open.push_back(tree.root());
    tree.query(query, Culling::none);

    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    int with_itself = 0, blocks = 0;
    for (const NodePair pair : query.found) {
        found.emplace_back(std::min(pair.a, pair.b), std::max(pair.a, pair.b));
        with_itself += pair.a == pair.b;
        EXPECT_TRUE(tree.is_block(pair.a) && tree.is_block(pair.b));
    }
    for (std::uint32_t index = 0; index < tree.node(0).end; ++index) blocks += tree.is_block(index);
    EXPECT_EQ(with_itself, blocks);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
}

}  // namespace
}  // namespace nuno
