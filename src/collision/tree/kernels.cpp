// Compiles the loops once for each instruction set.
#include "collision/tree/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Wide values cross no call between instruction sets, so the note on their calling convention does not apply.
#pragma GCC diagnostic ignored "-Wpsabi"

// Sanitizers and clang get the narrow vectors alone, as every kernel of the program does.
#if defined(NUNO_SANITIZED) || defined(__clang__) || !defined(__x86_64__)
#define NUNO_TREE_ALL_LANES 0
#else
#define NUNO_TREE_ALL_LANES 1
#endif

namespace nuno {
namespace {

// Rows of floats (box_kernels.inc) and of whole numbers (there, and square_kernels.inc), and how far they may be read
// on.
constexpr int kRows = 48, kHalfRows = 12 + 6 * 13 + 1, kReadAhead = 48;

}  // namespace

void RowScratch::resize(int columns)
{
    stride_ = (columns + kReadAhead + 15) / 16 * 16;
    floats_.assign(std::size_t(kRows) * std::size_t(stride_), 0.0f);
    halves_.assign(std::size_t(kHalfRows) * std::size_t(stride_), 0);
}

#define NUNO_TREE_TABLE                                                                                               \
    {                                                                                                                 \
        vertex_extent, grid_boxes, cell_boxes, parent_boxes, visit, visit_self, visit_pair, edge_bounds, merge_edges, \
            prove_blocks, prove_cells, prove_part, prove_face                                                         \
    }

namespace lanes_4 {
#define NUNO_TREE_PART_BYTES 16
#include "collision/tree/lanes.inc"
//
#include "collision/tree/box_kernels.inc"
//
#include "collision/tree/square_kernels.inc"
//
#include "collision/tree/grid_kernels.inc"
//
#include "collision/tree/pair_kernels.inc"
//
#include "collision/tree/proof_kernels.inc"
//
#include "collision/tree/chart_kernels.inc"
#undef NUNO_TREE_PART_BYTES
constexpr TreeKernels kKernels = NUNO_TREE_TABLE;
}  // namespace lanes_4

#if NUNO_TREE_ALL_LANES
#pragma GCC push_options
#pragma GCC target("arch=x86-64-v3")
namespace lanes_8 {
#define NUNO_TREE_PART_BYTES 32
#include "collision/tree/lanes.inc"
//
#include "collision/tree/box_kernels.inc"
//
#include "collision/tree/square_kernels.inc"
//
#include "collision/tree/grid_kernels.inc"
//
#include "collision/tree/pair_kernels.inc"
//
#include "collision/tree/proof_kernels.inc"
//
#include "collision/tree/chart_kernels.inc"
#undef NUNO_TREE_PART_BYTES
constexpr TreeKernels kKernels = NUNO_TREE_TABLE;
}  // namespace lanes_8
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("arch=x86-64-v4")
namespace lanes_16 {
#define NUNO_TREE_PART_BYTES 64
#include "collision/tree/lanes.inc"
//
#include "collision/tree/box_kernels.inc"
//
#include "collision/tree/square_kernels.inc"
//
#include "collision/tree/grid_kernels.inc"
//
#include "collision/tree/pair_kernels.inc"
//
#include "collision/tree/proof_kernels.inc"
//
#include "collision/tree/chart_kernels.inc"
#undef NUNO_TREE_PART_BYTES
constexpr TreeKernels kKernels = NUNO_TREE_TABLE;
}  // namespace lanes_16
#pragma GCC pop_options
#endif

const TreeKernels& tree_kernels(int lanes)
{
#if NUNO_TREE_ALL_LANES
    if (lanes >= 16 && __builtin_cpu_supports("x86-64-v4")) return lanes_16::kKernels;
    if (lanes >= 8 && __builtin_cpu_supports("x86-64-v3")) return lanes_8::kKernels;
#endif
    (void)lanes;
    return lanes_4::kKernels;
}

const TreeKernels& machine_tree_kernels() { return tree_kernels(16); }

}  // namespace nuno
