// The rim of a flat mesh: whether it is one convex polygon.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nuno {

// Places of vertices in the plane, and faces that all turn counter-clockwise in it. Returns the largest angle [rad] of
// an edge of the rim to the edge of its convex hull above it, 0 where the rim is convex; nothing where the faces are no
// simple sheet (an edge of three faces, several rims, a rim that winds more than once) or the angle is above 1e-3.
std::optional<double> rim_roughness(std::span<const glm::dvec2> places, std::span<const glm::uvec3> faces);

}  // namespace nuno
