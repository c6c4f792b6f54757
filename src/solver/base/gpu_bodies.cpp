// Uploads poses, grids of distances and pins.
#include "solver/base/gpu_bodies.h"

#include <string>

#include "shaders/shared/bindings.h"

namespace nuno {

static_assert(sizeof(BodyStep) == BODY_TEXELS * sizeof(glm::vec4));
static_assert(sizeof(PinStep) == 2 * sizeof(glm::vec4));
static_assert(BodySteps::kGridHeader == GRID_HEADER);

GpuBodies::GpuBodies(const Bodies& bodies, const ClothModel& model)
    : bodies_(bodies),
      steps_(bodies, model),
      body_steps_(GL_RGBA32F),
      distances_(GL_R32F),
      pin_vertices_(GL_R32I),
      pin_steps_(GL_RGBA32F)
{
    distances_.upload(steps_.grid_numbers());
    if (!moves_pins()) return;
    std::vector<std::int32_t> vertices;
    for (const HandlePin& pin : steps_.pins()) vertices.push_back(static_cast<std::int32_t>(pin.vertex));
    pin_vertices_.upload(vertices);
    place_pins_ = compute_program("sim/place_pins.comp");
    place_pins_.set(LOCATION_PIN_COUNT, static_cast<std::int32_t>(vertices.size()));
}

std::vector<Define> GpuBodies::defines() const
{
    return {{"PLANE_COUNT", std::to_string(bodies_.planes.size())},
            {"SPHERE_COUNT", std::to_string(bodies_.spheres.size())},
            {"CAPSULE_COUNT", std::to_string(bodies_.capsules.size())},
            {"BOX_COUNT", std::to_string(bodies_.boxes.size())},
            {"MESH_COUNT", std::to_string(bodies_.meshes.size())}};
}

void GpuBodies::plan(const StepInput& input)
{
    steps_.plan(input.start_time_s, double(substep_s(input.params)), input.substep_count);
    body_steps_.upload(std::as_bytes(std::span(steps_.all_bodies())));
    pin_steps_.upload(std::as_bytes(std::span(steps_.all_pins())));
    if (bodies_.shape_count() > 0) body_steps_.bind(UNIT_BODIES);
    if (!bodies_.meshes.empty()) distances_.bind(UNIT_DISTANCES);
    if (!moves_pins()) return;
    pin_vertices_.bind(UNIT_PIN_VERTICES);
    pin_steps_.bind(UNIT_PIN_STEPS);
}

void GpuBodies::set_substep(const Program& program, int substep) const
{
    if (bodies_.shape_count() > 0)
        program.set(LOCATION_FIRST_BODY, static_cast<std::int32_t>(steps_.first_body(substep)));
}

void GpuBodies::place_pins(int substep) const
{
    const auto count = static_cast<GLuint>(steps_.pins().size());
    if (count == 0) return;
    place_pins_.use();
    place_pins_.set(LOCATION_FIRST_PIN, static_cast<std::int32_t>(steps_.first_pin(substep)));
    glDispatchCompute((count + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1);
}

}  // namespace nuno
