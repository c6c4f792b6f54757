// Springs, and the table that both backends gather them from: for each vertex its neighbours in a fixed order of slots.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace nuno {

// Of a grid: weft along a row, warp along a column, shear along the diagonals of a cell, bend over two cells. Of any
// other mesh: its edges, and hinges between the corners that face each other across an edge.
enum class SpringKind : std::uint8_t
{
    weft,
    warp,
    edge,
    shear,
    bend_weft,
    bend_warp,
    hinge
};

// Threads (weft, warp, edge), diagonals (shear), and those that reach over a cell or an edge.
constexpr int kSpringGroupCount = 3;
int spring_group(SpringKind kind);
inline bool is_thread(SpringKind kind) { return spring_group(kind) == 0; }

struct Spring
{
    std::uint32_t a, b;  // vertices
    float rest_length;   // [m]
    SpringKind kind;
    float share = 1;  // of the cloth around it: on a grid 1/2 at the rim, else 1; of an edge the faces' area / length^2
    float warp_share = 0;  // of an edge: squared cosine of its angle to the warp
    float cell_ratio = 1;  // of a grid: height of a cell (along the warp) over its width
    glm::vec3 plate{0};    // [1/m2]: resists bending with the linear stiffness dot(plate, (D warp, D weft, twist))
};

// ELLPACK: entry (slot, vertex) is at slot * vertex_count + vertex. The slots of a group are [first_slot[group],
// first_slot[group + 1]), a multiple of 4, so that a kernel reads four at once. A slot without a spring names the
// vertex itself.
struct SpringTable
{
    static constexpr std::uint32_t kNoSpring = ~0u;

    std::uint32_t vertex_count = 0;
    std::array<int, kSpringGroupCount + 1> first_slot{};
    std::vector<std::uint32_t> neighbours;
    std::vector<std::uint32_t> springs;  // index into the model's, or kNoSpring

    int slot_count() const { return first_slot[kSpringGroupCount]; }
};

// Slots are chosen so that neighbouring vertices have neighbouring entries in one slot, where the numbering of the mesh
// allows it. Error where a vertex needs more than 256 slots.
SpringTable make_spring_table(std::span<const Spring> springs, std::uint32_t vertex_count);

}  // namespace nuno
