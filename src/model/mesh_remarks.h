// What a user should know of the meshes of a scene.
#pragma once

#include <string>
#include <vector>

#include "model/cloth_model.h"

namespace nuno {

// A line for each sheet with edges where more than two faces meet, and one where two faces run along their edge the
// same way: how many, and the first with its vertices and faces, counted from 0 in the sheet.
std::vector<std::string> mesh_remarks(const ClothModel& model);

}  // namespace nuno
