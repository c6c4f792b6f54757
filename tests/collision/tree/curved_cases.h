// Meshes that are curved at rest, or flat with notches and holes, and ways to bend them.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/tree/tree_cases.h"

namespace nuno {

// About n vertices a metre; all are about one metre large and at rest.
TreeCase sleeve(int n);                // a tube
TreeCase bag(int n);                   // a sphere with an opening
TreeCase saddle(int n);                // z = 0.4 (x^2 - y^2)
TreeCase l_shape(int n);               // flat, a quarter missing
TreeCase plate_with_hole(int n);       // flat, a round hole
TreeCase notched(int n, float depth);  // flat, one side pressed in to a wedge of that depth

std::vector<TreeCase> curved_cases(int n);

// What becomes of a place at rest.
typedef glm::vec3 (*Bend)(glm::vec3 rest, float amount);
glm::vec3 waved(glm::vec3 rest, float amount);     // sideways, in waves of 0.4 m
glm::vec3 crumpled(glm::vec3 rest, float amount);  // pressed together and thrown about
glm::vec3 folded(glm::vec3 rest, float amount);    // by 180 degrees around x = 0.1, `amount` between the layers
glm::vec3 rolled(glm::vec3 rest, float amount);    // up along x, each turn `amount` above the one before

std::vector<glm::vec4> bent(const TreeCase& cloth, Bend bend, float amount);

}  // namespace nuno
