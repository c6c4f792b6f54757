// Names intersections of a cloth, so that they can be found in an exported mesh.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "collision/tangle.h"
#include "collision/vertex_face.h"
#include "model/cloth_model.h"

namespace nuno {

// "edge 3 4 of sheet upper goes through face 17 of sheet lower at (0.1, 0.2, 0.3) m"; numbers are those of exported
// meshes, from 0.
std::string tangle_text(const ClothModel& model, const Tangle& tangle);

// The same of a vertex that went through a face.
std::string pass_through_text(const ClothModel& model, VertexFace pair, glm::vec3 place);

}  // namespace nuno
