// The pass over faces in a compute shader.
#include "solver/base/gpu_faces.h"

#include "gl/barriers.h"
#include "model/wind_field.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"
#include "solver/base/slot_quads.h"

namespace nuno {

GpuFaces::GpuFaces(const ClothModel& model)
    : face_count_(static_cast<std::int32_t>(model.faces.size())),
      corners_(GL_RGBA32I),
      faces_(GL_RGBA32I),
      rests_(GL_RGBA32F),
      forces_(3 * model.faces.size() + 1)
{
    const CornerTable table = make_corner_table(model);
    corner_quads_ = table.slot_count / 4;
    std::vector<glm::ivec4> faces;
    for (const glm::uvec3& face : model.faces) faces.emplace_back(face, 0);
    std::vector<glm::vec4> rests;
    for (const formulas::FaceRest& rest : face_rests(model)) {
        rests.emplace_back(rest.warp_1, rest.warp_2, rest.weft_1, rest.weft_2);
        rests.emplace_back(rest.area, rest.mass_area, 0, 0);
    }
    corners_.upload(in_quads<std::int32_t>(table.corners, table.vertex_count));
    faces_.upload(faces);
    rests_.upload(rests);
    forces_.buffer.update(0, std::vector<glm::vec4>(3 * model.faces.size() + 1, glm::vec4(0)));
}

void GpuFaces::refresh(const SimParams& params)
{
    const FaceForces wanted = face_forces(params);
    if (compiled_for_ == wanted) return;
    compiled_for_ = wanted;
    if (!wanted.any()) return;
    const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
    const std::vector<Define> defines{
        {"MEMBRANE", flag(wanted.membrane)}, {"AIR", flag(wanted.air)}, {"GUSTS", flag(wanted.gusts)}};
    program_ = gpu_program("sim/faces.comp", {defines});
}

void GpuFaces::run(const SimParams& params, double time_s)
{
    const AirField field = air_field(params, time_s);
    program_.use();
    program_.set(LOCATION_FACE_COUNT, face_count_);
    program_.set(LOCATION_SUBSTEP, substep_s(params));
    program_.set(LOCATION_GUST, glm::vec4(field.offset, field.per_size));
    program_.set(LOCATION_GUST_SEED, field.seed);
    faces_.bind(UNIT_FACES);
    rests_.bind(UNIT_FACE_RESTS);
    forces_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_FACE_FORCES);
    glDispatchCompute(static_cast<GLuint>((face_count_ + GROUP_SIZE - 1) / GROUP_SIZE), 1, 1);
    barrier_compute_to_compute();
}

void GpuFaces::bind() const
{
    corners_.bind(UNIT_CORNERS);
    forces_.texture.bind(UNIT_FACE_FORCES);
}

}  // namespace nuno
