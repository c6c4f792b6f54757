// What lies across each side of the faces of a mesh, and how its rim goes on.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace nuno {

constexpr std::uint32_t kNoFace = 0xffffffffu;   // across a side on the rim
constexpr std::uint32_t kOddSide = 0xfffffffeu;  // a side of more than two faces, or of two that turn different ways
constexpr std::uint32_t kNoVertex = 0xffffffffu;

struct MeshSides
{
    // The face across side k of each face, from its corner k to the next; or one of the above.
    std::vector<std::array<std::uint32_t, 3>> across;
    // Of each vertex the next one along the rim, the mesh on the left; kNoVertex off the rim, and where rims meet.
    std::vector<std::uint32_t> rim_next;
};

MeshSides sides_of(std::span<const glm::uvec3> faces, std::uint32_t vertex_count);

}  // namespace nuno
