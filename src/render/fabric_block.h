// What the look `cloth` adds to the block View, as the uniform block Fabric of shaders/render/fabric_block.glsl.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/view_params.h"

namespace nuno {

// Only matrices and vec4, so that the layout is std140's; the fields are explained in the GLSL file.
struct FabricBlock
{
    glm::mat4 to_key_map;
    glm::vec4 key_map, fabric, sheen_fit;
};

// `aspect`: width / height of the picture. `map_side`: texels of the key light's map. `sheen_fit`: of
// params.sheen_roughness, by fit_sheen_albedo.
FabricBlock make_fabric_block(const ViewParams& params, float aspect, int map_side, const glm::vec4& sheen_fit);

}  // namespace nuno
