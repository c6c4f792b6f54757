// Which vertex of the cloth the pointer is on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/camera.h"

namespace nuno {

// A picture in the window. Its places are in window coordinates from its top left corner.
struct PickView
{
    Camera camera;
    glm::vec2 size;
};

// Place of a point in the picture, and its depth (larger is farther); none where it is behind the camera.
std::optional<glm::vec3> project(const PickView& view, glm::vec3 point);

// The corner next to `place` of the frontmost face there; where there is no face, the vertex closest to
// `place` within `reach` of it, the frontmost of those about as close. None where the cloth is farther away.
std::optional<std::uint32_t> pick_vertex(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces,
                                         const PickView& view, glm::vec2 place, float reach);

}  // namespace nuno
