// The tree of boxes around the faces of a cloth (seed paper, 2.5.1.1, fig 2.2): four children a node, one face a leaf.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/float4.h"
#include "core/thread_pool.h"
#include "model/sim_params.h"

namespace nuno {

// By how much the box of a face grows on every side: relative * (its own extent along that axis) + absolute [m].
struct BoxMargin
{
    float relative = 0, absolute = 0;
};

// Two nodes whose boxes overlap, or the same node twice.
struct NodePair
{
    std::uint32_t a, b;
};

// Where a self-query stands.
struct TreeQuery
{
    std::vector<NodePair> open;      // to be visited, the last one first
    std::vector<NodePair> found;     // pairs of blocks
    std::uint64_t pairs_culled = 0;  // vertices * faces of the nodes that were skipped for their normals
    std::uint64_t visits = 0;
};

class BoxTree
{
  public:
    // A node; the boxes of its four children lie side by side, so that one comparison meets all four. Children are
    // nodes, or all of them faces: then it is a block. All blocks lie at the same depth, so only nodes of one depth
    // ever meet.
    struct alignas(64) Node
    {
        std::array<Float4, 3> lo, hi;            // along x, y, z; an absent child has an empty box
        std::array<std::uint32_t, 4> child;      // nodes, or the faces of a block; kNoChild
        std::uint32_t end;                       // nodes are numbered in preorder: this one and all below are [it, end)
        std::uint32_t face_count;                // below
        std::uint32_t first_vertex, end_vertex;  // in `vertices_`: what the blocks below own
    };
    static constexpr std::uint32_t kNoChild = ~std::uint32_t{0};

    // The topology is built here, by median splits of the rest positions [m], and depends on nothing else.
    // Boxes are empty until the first refit.
    BoxTree(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces);

    std::span<const glm::uvec3> faces() const { return faces_; }
    const Node& node(std::uint32_t index) const { return nodes_[index]; }
    bool is_block(std::uint32_t index) const { return nodes_[index].end == index + 1; }

    // The vertices that the blocks of a node own. Every vertex is owned by one block, the first with a face that it is
    // a corner of, so that what is done for all blocks is done once for each vertex.
    std::span<const std::uint32_t> vertices(std::uint32_t index) const
    {
        return {vertices_.data() + nodes_[index].first_vertex, vertices_.data() + nodes_[index].end_vertex};
    }

    // Boxes of the faces at `positions` (xyz [m]).
    void refit(std::span<const glm::vec4> positions, BoxMargin margin, ThreadPool& pool);
    // Boxes of what the faces sweep while every vertex goes straight from t0 to t1.
    void refit_swept(std::span<const glm::vec4> positions_t0, std::span<const glm::vec4> positions_t1, BoxMargin margin,
                     ThreadPool& pool);
    // Finds the nodes that Culling::seed skips at `positions`: needed before a query with it, after every refit.
    void bound_normals(std::span<const glm::vec4> positions, ThreadPool& pool);

    // The self-query finds all pairs of blocks whose boxes overlap, each with itself too, once, in an order that
    // depends on the boxes alone; less what Culling::seed loses. It begins with `open` holding root() and ends when
    // nothing is open.
    NodePair root() const { return {0, 0}; }
    void query(TreeQuery& state, Culling culling) const;
    // Visits one pair.
    void visit(NodePair pair, TreeQuery& state, Culling culling) const;

    // Whether sharing the work among threads pays; a property of the mesh.
    bool is_large() const { return !subtrees_.empty(); }

  private:
    struct Builder;
    void share_out();
    // Calls body(node) for every node after all of its children.
    void bottom_up(ThreadPool& pool, const std::function<void(std::uint32_t node)>& body) const;
    template <class FaceBox>
    void refit_nodes(ThreadPool& pool, BoxMargin margin, const FaceBox& face_box);

    std::vector<glm::uvec3> faces_;
    std::vector<std::uint32_t> vertices_;
    std::vector<Node> nodes_;
    std::vector<Bounds> boxes_;             // of every node
    std::vector<std::uint32_t> subtrees_;   // roots of the subtrees refitted by one thread each; none in a small tree
    std::vector<std::uint32_t> top_nodes_;  // the nodes above them, in preorder
    std::vector<Bounds> normal_bounds_;     // of every node: the box of its faces' unit normals
    std::vector<std::uint8_t> culled_;      // of every node: Culling::seed does not look for contacts within it
};

// The children of `node` whose boxes overlap `box`, one bit each.
inline unsigned overlapping_children(const BoxTree::Node& node, const Bounds& box)
{
    Int4 lanes = (node.lo[0] <= all_lanes(box.hi[0])) & (node.hi[0] >= all_lanes(box.lo[0]));
    lanes &= (node.lo[1] <= all_lanes(box.hi[1])) & (node.hi[1] >= all_lanes(box.lo[1]));
    lanes &= (node.lo[2] <= all_lanes(box.hi[2])) & (node.hi[2] >= all_lanes(box.lo[2]));
    return lane_bits(lanes);
}

}  // namespace nuno
