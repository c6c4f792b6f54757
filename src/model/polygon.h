// Cuts polygons into triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace nuno {

// The triangles of a polygon, turning the way it does: of a quad the two beside its shorter diagonal that is
// inside, else ears, that with the shortest diagonal first (Meisters 1975). `corners` are numbers of `positions`, at least 3. Nothing
// where it has no area, crosses or touches itself, seen along its mean normal (Newell).
std::vector<glm::uvec3> cut_polygon(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners);

}  // namespace nuno
