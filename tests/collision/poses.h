// Cloths in hard poses, for the tests and the benchmark of collision.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/cloth_model.h"

namespace nuno {

struct Pose
{
    std::vector<glm::vec3> rest;       // [m]
    std::vector<glm::vec4> positions;  // xyz [m], w = 1
    std::vector<glm::uvec3> faces;
    std::vector<Sheet> sheets{};  // grids; none: one mesh
};

// A flat grid of n x n vertices, one metre a side, in the plane z = 0.
Pose flat_sheet(int n);
// The same, pressed together and thrown into random folds that go through each other. Larger amplitude, more contacts.
Pose crumpled_sheet(int n, float amplitude, std::uint32_t seed);
// Folded by 180 degrees around a half cylinder, the two halves `gap` apart.
Pose folded_sheet(int n, float gap);
// Rolled up around an axis, each turn `gap` above the one before.
Pose rolled_sheet(int n, float gap);
// `count` flat sheets, a random small distance apart, each turned a little.
Pose stacked_sheets(int n, int count, std::uint32_t seed);
// Faces of random corners and sizes, some of them without area; every vertex is a corner of some face.
Pose face_soup(int face_count, std::uint32_t seed);
// A ring cut open, its ends one above the other, `rise` apart: all normals nearly alike.
Pose flat_c(int n, float rise);
// A ramp of two turns around an axis, `rise` a turn: all normals nearly alike.
Pose spiral_ramp(int n, float rise);

// Adds the sheets of `more`, where they are.
void add_sheets(Pose& pose, const Pose& more);

// Moves every vertex by up to `distance` along each axis.
std::vector<glm::vec4> shaken(std::span<const glm::vec4> positions, float distance, std::uint32_t seed);

}  // namespace nuno
