// The pass over faces in a compute shader.
#include "solver/base/gpu_faces.h"

#include "gl/barriers.h"
#include "model/wind_field.h"
#include "shaders/shared/bindings.h"

namespace nuno {
namespace {

// A corner table as four slots a texel, texel (quad, vertex) at quad * vertex_count + vertex.
std::vector<std::int32_t> quads_of(const CornerTable& table)
{
    std::vector<std::int32_t> quads(table.corners.size());
    for (std::size_t i = 0; i < table.corners.size(); ++i) {
        const std::size_t slot = i / table.vertex_count, vertex = i % table.vertex_count;
        quads[((slot / 4) * table.vertex_count + vertex) * 4 + slot % 4] = static_cast<std::int32_t>(table.corners[i]);
    }
    return quads;
}

}  // namespace

GpuFaces::GpuFaces(const ClothModel& model)
    : face_count_(static_cast<std::int32_t>(model.faces.size())),
      corners_view_(GL_RGBA32I),
      faces_view_(GL_RGBA32I),
      rests_view_(GL_RGBA32F),
      forces_view_(GL_RGBA32F)
{
    const CornerTable table = make_corner_table(model);
    corner_quads_ = table.slot_count / 4;
    std::vector<glm::ivec4> faces;
    for (const glm::uvec3& face : model.faces) faces.emplace_back(face, 0);
    std::vector<glm::vec4> rests;
    for (const formulas::FaceRest& rest : face_rests(model)) {
        rests.emplace_back(rest.warp_1, rest.warp_2, rest.weft_1, rest.weft_2);
        rests.emplace_back(rest.area, 0, 0, 0);
    }
    const std::vector<glm::vec4> no_forces(3 * model.faces.size() + 1, glm::vec4(0));
    corners_ = make_buffer(quads_of(table), GL_STATIC_DRAW);
    faces_ = make_buffer(faces, GL_STATIC_DRAW);
    rests_ = make_buffer(rests, GL_STATIC_DRAW);
    forces_ = make_buffer(no_forces, GL_DYNAMIC_COPY);
    corners_view_.view(corners_.id(), corners_.size_bytes());
    faces_view_.view(faces_.id(), faces_.size_bytes());
    rests_view_.view(rests_.id(), rests_.size_bytes());
    forces_view_.view(forces_.id(), forces_.size_bytes());
}

void GpuFaces::refresh(const SimParams& params)
{
    const FaceForces wanted = face_forces(params);
    if (compiled_for_ == wanted) return;
    compiled_for_ = wanted;
    if (!wanted.any()) return;
    const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
    program_ =
        compute_program("sim/faces.comp",
                        {{"MEMBRANE", flag(wanted.membrane)}, {"AIR", flag(wanted.air)}, {"GUSTS", flag(wanted.gusts)}},
                        {{"generated/sim_params", glsl_fields(sim_param_table())}});
}

void GpuFaces::run(const SimParams& params, double time_s)
{
    const AirField field = air_field(params, time_s);
    program_.use();
    program_.set(LOCATION_FACE_COUNT, face_count_);
    program_.set(LOCATION_SUBSTEP, substep_s(params));
    program_.set(LOCATION_GUST, glm::vec4(field.offset, field.per_size));
    program_.set(LOCATION_GUST_SEED, field.seed);
    faces_view_.bind(UNIT_FACES);
    rests_view_.bind(UNIT_FACE_RESTS);
    forces_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_FACE_FORCES);
    glDispatchCompute(static_cast<GLuint>((face_count_ + GROUP_SIZE - 1) / GROUP_SIZE), 1, 1);
    barrier_compute_to_compute();
}

void GpuFaces::bind() const
{
    corners_view_.bind(UNIT_CORNERS);
    forces_view_.bind(UNIT_FACE_FORCES);
}

}  // namespace nuno
