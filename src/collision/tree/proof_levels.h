// What the proofs that nothing touches work on: bounds of edges and gradients, and flags.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace nuno {

// Of a block of 4 x 4 cells: where contacts of its cells with each other are not ruled out, and those with cells of the
// block beside it.
enum OpenBlock : std::uint8_t
{
    kOpenRight = 1,
    kOpenAbove = 2,
    kOpenAboveRight = 4,
    kOpenAboveLeft = 8,
    kOpenLeft = 16,
    kOpenSelf = 32
};

// What is known of a grid at one level: squares of nodes without contacts. Bits: 1 the node (x, y) itself, 2 with its
// neighbour at x + 1, 4 with that at y + 1, 8 all four.
struct ProofLevel
{
    const std::uint8_t* flags = nullptr;
    std::uint32_t width = 0;
};

// Bounds of the edges in square blocks of a grid: of the sides along the rows (u) and down the columns (v). 12 arrays:
// lo u.xyz, hi u.xyz, lo v.xyz, hi v.xyz, row after row, `stride` apart. After each row and after the last there is
// room for 17 floats, and one row more; outside the grid lie bounds of no edge.
struct EdgeLevel
{
    std::array<float*, 12> bound{};
    int width = 0, height = 0, stride = 0;
};

// Which cells are proven apart from themselves and the cells around them: bit i % 16 of number j cell_groups(columns) +
// i / 16 for cell (i, j).
inline int cell_groups(int columns) { return (columns + 15) / 16; }

// Slack for the rounding of edges and of all that is computed from them.
constexpr float kEdgeSlack = 1e-5f;

}  // namespace nuno
