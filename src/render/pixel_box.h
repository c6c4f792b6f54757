// The part of a picture that a part of the world can cover.
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// A box along the axes of the world [m].
struct Bounds
{
    glm::vec3 low, high;
};

// One of its eight, by the three lowest bits of `number`.
glm::vec3 corner_of(const Bounds& box, int number);

// Of positions [m] (xyz used), not empty.
Bounds bounds_of(std::span<const glm::vec4> positions);

// Pixels from `low` to before `high`, counted from the lower left corner; none where they are equal.
struct PixelBox
{
    glm::ivec2 low{0}, high{0};
};

// Every pixel that something within the boxes can touch, of a picture of `size` pixels: all of them where a box reaches
// behind the eye or has no finite corners.
PixelBox pixels_of(std::span<const Bounds> boxes, const glm::mat4& view_projection, glm::ivec2 size);

}  // namespace nuno
