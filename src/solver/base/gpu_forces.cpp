// Uploads the forces of a model.
#include "solver/base/gpu_forces.h"

#include <string>

#include "shaders/shared/bindings.h"
#include "solver/base/slot_quads.h"

namespace nuno {

GpuForces::GpuForces(const ClothModel& model, SpringRule rule)
    : model_(model),
      rule_(rule),
      neighbours_(GL_RGBA32I),
      stiffness_(GL_RGBA32F),
      tension_(GL_RGBA32F),
      axial_(GL_RGBA32F)
{
}

bool GpuForces::refresh(const SimParams& params)
{
    const bool first = !made_for_, damped = params.stiffness_damping > 0;
    const int quads_before = quad_count_;
    if (rule_.weights && (first || rule_.differ(*made_for_, params)))
        upload_springs(spring_entries(model_, rule_.weights(model_, params)));
    const FaceForces wanted = face_forces(params);
    if (wanted.membrane) membrane_constants(params);
    if (wanted.any() && !faces_) faces_.emplace(model_);
    if (faces_) faces_->refresh(params);
    const bool changed =
        first || quad_count_ != quads_before || damped != damped_ || wanted.any() != face_forces_.any();
    face_forces_ = wanted;
    made_for_ = params;
    damped_ = damped;
    return changed;
}

void GpuForces::upload_springs(const SpringEntries& entries)
{
    neighbours_.upload(in_quads<std::int32_t>(entries.neighbours, entries.vertex_count));
    stiffness_.upload(in_quads<float>(entries.stiffness, entries.vertex_count));
    tension_.upload(in_quads<float>(entries.tension, entries.vertex_count));
    axial_.upload(in_quads<float>(entries.axial, entries.vertex_count));
    quad_count_ = entries.slot_count / 4;
}

std::vector<Define> GpuForces::defines() const
{
    return {{"SPRING_QUADS", std::to_string(quad_count_)},
            {"DAMPED_SPRINGS", damped_ ? "1" : "0"},
            {"CORNER_QUADS", std::to_string(face_forces_.any() ? faces_->corner_quads() : 0)}};
}

void GpuForces::bind() const
{
    if (rule_.weights) {
        neighbours_.bind(UNIT_NEIGHBOURS);
        stiffness_.bind(UNIT_STIFFNESS);
        tension_.bind(UNIT_TENSION);
        axial_.bind(UNIT_AXIAL);
    }
    if (face_forces_.any()) faces_->bind();
}

void GpuForces::run_face_pass(double time_s)
{
    if (face_forces_.any()) faces_->run(*made_for_, time_s);
}

}  // namespace nuno
