// The loops of the tree of faces, for each width of vectors that machines have.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/tree/chart_window.h"
#include "collision/tree/grid_patch.h"
#include "collision/tree/proof_levels.h"
#include "collision/tree/tree_node.h"

namespace nuno {

// How the boxes of one refit are made from positions. Of t1 the `shift` is taken away. A box grows by `growth` on every
// side; a coordinate x becomes the whole number (x - centre) scale, towards zero, within the range of a node's box:
// a monotone map, so that boxes that overlap still do.
struct BoxFrame
{
    const glm::vec4 *t0 = nullptr, *t1 = nullptr;  // t1 is null where there is one pose
    std::array<float, 4> shift{}, centre{}, scale{};
    float growth = 0;
};

// Rows of a band of a grid, kept from one to the next.
class RowScratch
{
  public:
    void resize(int columns);
    int stride() const { return stride_; }
    float* row(int number) { return floats_.data() + std::size_t(number) * std::size_t(stride_); }
    std::int16_t* half_row(int number) { return halves_.data() + std::size_t(number) * std::size_t(stride_); }

  private:
    int stride_ = 0;
    std::vector<float> floats_;
    std::vector<std::int16_t> halves_;
};

// Cell rows first_row .. end_row - 1 of a grid, first_row a multiple of 4.
struct GridBand
{
    const GridPatch* grid;
    int first_row, end_row;
    bool with_neighbours;  // whether pairs of neighbouring cells are looked for
    // OpenBlock bits of each block, `open_stride` a row, 4 more at the end; null: all of them for all blocks.
    const std::uint8_t* open_blocks;
    int open_stride;
    const std::uint16_t* apart_cells;  // as of GridProof, where open_blocks are
};

// What a band has found: pairs of faces of neighbouring cells, and neighbouring nodes of level 0 that are to be
// visited.
struct BandFound
{
    PairList faces;
    NodePairs nodes;
};

constexpr int kMostLevels = 17;

// What is known of meshes: the largest proven window that holds all of a node, kNoWindow without one; and the nodes of
// level 1 that each window holds besides, in order.
struct WindowLevels
{
    std::array<const std::uint32_t*, kMostLevels> of_node{};
    const std::span<const std::uint32_t>* around = nullptr;
};

// The self-query as a task sees it.
struct QueryFrame
{
    BoxFrame box;
    const Cell* cells;
    std::array<const TreeNode*, kMostLevels> levels;
    const ProofLevel* proofs;     // of grid g, level l: [g kMostLevels + l]; null: none
    const WindowLevels* windows;  // null: none
    bool masks_neighbours;        // leaves neighbouring cells and level-0 nodes of a grid out
    bool compares_vertices;       // leaves out faces with a common vertex
};

// Node pairs still to be visited, by level, and what they led to.
struct QueryScratch
{
    static constexpr int kVisits = 32, kRoom = 16 * kVisits + 16;
    std::uint32_t first[kMostLevels][kRoom], second[kMostLevels][kRoom];
    std::uint64_t visits = 0;
};

struct NodeList
{
    const std::uint32_t *first, *second;
    int count;
};

// xyz [m]; w means nothing.
struct VertexExtent
{
    glm::vec4 lo, hi, motion_lo, motion_hi;
};

struct TreeKernels
{
    // Of t0, and of t1 - t0 where there is motion (else zeros), over at least one vertex.
    VertexExtent (*vertex_extent)(const BoxFrame&, std::uint32_t begin, std::uint32_t end);
    // Boxes of the level-0 nodes of a band, and what its neighbours have to do with each other.
    void (*grid_boxes)(const BoxFrame&, const GridBand&, TreeNode* nodes, BandFound&, RowScratch&);
    // Boxes of the level-0 nodes of a run, from their cells.
    void (*cell_boxes)(const BoxFrame&, const Cell* cells, TreeNode* nodes, std::uint32_t begin, std::uint32_t end);
    // Boxes of the nodes begin .. end - 1 of a level from those of the level below.
    void (*parent_boxes)(const TreeNode* below, TreeNode* nodes, std::uint32_t begin, std::uint32_t end);
    // All pairs below these pairs of nodes of a level.
    void (*visit)(const QueryFrame&, int level, NodeList nodes, QueryScratch&, PairList&);
    // The pairs of different children of a node, at most 6, with space for 16 after them.
    int (*visit_self)(const TreeNode& node, std::uint32_t number, std::uint32_t* first, std::uint32_t* second);
    // The pairs of children of two nodes, at most 16; of neighbours in a grid, if it is asked for, only those that are
    // no neighbours themselves.
    int (*visit_pair)(const TreeNode* nodes, std::uint32_t a, std::uint32_t b, bool masks_neighbours,
                      std::uint32_t* first, std::uint32_t* second);
    // Adds the edges of a band at these positions to the bounds of blocks of 4 x 4 cells.
    void (*edge_bounds)(const glm::vec4* positions, const GridBand&, const EdgeLevel&, RowScratch&);
    // Bounds of blocks from those of the four below each.
    void (*merge_edges)(const EdgeLevel& below, const EdgeLevel& blocks);
    // The flags of ProofLevel of all blocks, row by row: whether lambda > need, lambda less by `slack` times the size
    // of the edges.
    void (*prove_blocks)(const EdgeLevel& blocks, float need, float slack, std::uint8_t* flags);
    // Which cells of a band are proven apart from those around them, as prove_blocks has it, on the frame's way; written
    // where the band's cells are in the whole grid's numbers (proof_levels.h).
    void (*prove_cells)(const BoxFrame&, const GridBand&, float need, float slack, RowScratch&, std::uint16_t* apart);
    // What is asked of a window's part, or of one of its faces, at these positions.
    ChartAnswer (*prove_part)(const glm::vec4* positions, const ChartPart&, const ChartTest&);
    bool (*prove_face)(const glm::vec4* positions, const ChartFace&, const ChartTest&);
};

// For 16, 8 or 4 floats a vector; narrower ones where the machine or the build has no others. All give the same bits.
const TreeKernels& tree_kernels(int lanes);
const TreeKernels& machine_tree_kernels();

}  // namespace nuno
