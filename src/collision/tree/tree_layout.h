// The topology of the tree of faces: which cell and which node lies where. Built once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "collision/tree/grid_patch.h"
#include "collision/tree/tree_node.h"
#include "model/cloth_model.h"

namespace nuno {

// Level-0 nodes begin .. end - 1.
struct NodeRun
{
    std::uint32_t begin, end;
};

// All sheets in one tree of complete levels. A grid is cut into squares of at most 64 x 64 cells; within a square,
// nodes are numbered as a quadtree. Any other sheet is a balanced tree over its cells.
struct TreeLayout
{
    std::vector<GridPatch> grids;
    std::vector<Cell> cells;                    // four a level-0 node
    std::vector<std::vector<TreeNode>> levels;  // 0: parents of cells; the last has one node
    // Nodes whose cells are met in the tree with their neighbours too: those of all sheets but regular grids.
    std::vector<NodeRun> mesh_nodes;
    std::vector<NodeRun> meshes;  // of each sheet that is no grid
};

TreeLayout make_tree_layout(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                            std::span<const Sheet> sheets);

}  // namespace nuno
