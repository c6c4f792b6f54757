// Where points of the scene are in the picture, and what is frontmost at a place of it.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.h"

namespace nuno {

// A picture in the window. Its places are in window coordinates from its top left corner.
struct PickView
{
    Camera camera;
    glm::vec2 size;
};

constexpr float kBehind = std::numeric_limits<float>::infinity();  // depth of what is behind the camera

// Place of a point in the picture, and its depth (larger is farther, at most 1 where it is seen); none where it is behind
// the camera.
std::optional<glm::vec3> project(const PickView& view, glm::vec3 point);
// The same, of depth kBehind there.
glm::vec3 project_or_behind(const PickView& view, glm::vec3 point);
// The point [m] that project() puts there.
glm::vec3 unproject(const PickView& view, const glm::vec3& place_and_depth);

struct FaceHit
{
    glm::uvec3 face;
    float depth;
};

// The frontmost face at `place`, of corners as project_or_behind() has them.
std::optional<FaceHit> frontmost_face(std::span<const glm::vec3> seen, std::span<const glm::uvec3> faces,
                                      glm::vec2 place);

}  // namespace nuno
