// Closed meshes that several tests start from.
#pragma once

#include <glm/vec3.hpp>

#include "model/triangle_mesh.h"

namespace nuno {

// A box around the origin, twelve faces that look outwards.
TriangleMesh box_mesh(glm::vec3 size);

// The same with a pyramid, as deep as `depth`, pressed into its top.
TriangleMesh dented_box_mesh(glm::vec3 size, float depth);

}  // namespace nuno
