// Springs, and the table that both backends gather them from: for each vertex its neighbours in a fixed order of slots.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "shaders/shared/bindings.h"

namespace nuno {

enum class SpringKind : std::uint8_t
{
    structural,
    shear,
    bend
};
constexpr int kSpringKindCount = 3;

struct Spring
{
    std::uint32_t a, b;  // vertices
    float rest_length;   // [m]
    SpringKind kind;
};

// ELLPACK: entry (slot, vertex) is at slot * vertex_count + vertex. The slots of a kind are [first_slot[kind],
// first_slot[kind + 1]), a multiple of 4, so that a kernel knows the kind of a slot beforehand and reads four at once.
// A slot without a spring names the vertex itself and has a negative rest length.
struct SpringTable
{
    std::uint32_t vertex_count = 0;
    std::array<int, kSpringKindCount + 1> first_slot{};
    std::vector<std::uint32_t> neighbours;
    std::vector<float> rest_lengths;

    int slot_count() const { return first_slot[kSpringKindCount]; }
};

constexpr float kNoSpring = NO_SPRING;

// Slots are chosen so that neighbouring vertices have neighbouring entries in one slot, where the numbering of the mesh
// allows it. Error where a vertex needs more than 256 slots.
SpringTable make_spring_table(std::span<const Spring> springs, std::uint32_t vertex_count);

// The seed's neighbourhood (fig 2.1) of a grid whose vertex (i, j) is first + j columns + i: structural to the 4
// neighbours, shear to the 4 diagonal ones, bend to the 4 two cells away; rest lengths from `positions` (indexed by
// whole vertex number).
void append_grid_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions, std::uint32_t first,
                         int columns, int rows);

// Structural springs along every edge of the faces, bend springs between the corners that face each other across an
// inner edge.
void append_mesh_springs(std::vector<Spring>& springs, std::span<const glm::vec3> positions,
                         std::span<const glm::uvec3> faces);

}  // namespace nuno
