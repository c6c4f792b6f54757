// Where the key light's map lies, and the numbers of the fabric.
#include "render/fabric_block.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/view_block.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

// Half the side of the square around the camera's target that the picture shows there [m].
float seen_radius(const ViewParams& params, float aspect)
{
    const float half_height = params.camera_distance * std::tan(0.5f * glm::radians(params.field_of_view));
    return half_height * std::hypot(1.0f, aspect);
}

// From metres to the map's coordinates, all 0 .. 1, by what a texel is: so the map stays where it is in the world while
// the camera's target moves by less.
glm::mat4 key_map_matrix(glm::vec3 target, glm::vec3 towards_light, float side, int texels)
{
    const glm::vec3 aside = std::abs(towards_light.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(aside, towards_light)), up = glm::cross(towards_light, right);
    const float texel = side / static_cast<float>(texels);
    const auto snapped = [&](float at) { return std::floor(at / texel) * texel; };
    const float depth = KEY_DEPTH_SIDES * side;
    glm::mat4 matrix(1);
    for (int k = 0; k < 3; ++k) {
        matrix[k] = glm::vec4(right[k] / side, up[k] / side, -towards_light[k] / depth, 0);
        matrix[3][k] = 0.5f;
    }
    matrix[3][0] -= snapped(glm::dot(right, target)) / side;
    matrix[3][1] -= snapped(glm::dot(up, target)) / side;
    matrix[3][2] += glm::dot(towards_light, target) / depth;
    return matrix;
}

}  // namespace

FabricBlock make_fabric_block(const ViewParams& params, float aspect, int map_side, const glm::vec4& sheen_fit)
{
    const float side = 2 * seen_radius(params, aspect);
    const glm::vec3 target(params.camera_target_x, params.camera_target_y, params.camera_target_z);
    FabricBlock block;
    block.to_key_map = key_map_matrix(target, key_direction(params), side, map_side);
    block.key_map = {side, static_cast<float>(map_side), std::tan(0.5f * glm::radians(params.light_size)),
                     params.shadow ? 1.0f : 0.0f};
    block.fabric = {params.sheen, params.sheen_roughness, params.weave, 0};
    block.sheen_fit = sheen_fit;
    return block;
}

}  // namespace nuno
