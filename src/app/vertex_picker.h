// Which vertex of the cloth the pointer is on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec4.hpp>

#include "app/pick_view.h"

namespace nuno {

// The corner next to `place` of the frontmost face there; where there is no face, the vertex closest to
// `place` within `reach` of it, the frontmost of those about as close. None where the cloth is farther away.
// `hidden_from`: depth of what lies at `place` otherwise, which hides faces behind it, and has no reach around it.
std::optional<std::uint32_t> pick_vertex(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces,
                                         const PickView& view, glm::vec2 place, float reach,
                                         float hidden_from = kBehind);

}  // namespace nuno
