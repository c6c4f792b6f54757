// XPBD on CPU threads, sheet by sheet.
#include "solver/xpbd/cpu_xpbd.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "solver/xpbd/by_lanes.h"
#include "solver/xpbd/mesh_sheet.h"
#include "solver/xpbd/strip_sheet.h"

namespace nuno {

CpuXpbd::CpuXpbd(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool, int lanes)
    : model_(model), pool_(pool), bodies_(bodies, model), positions_(model.vertex_count())
{
    if (lanes == 0) lanes = machine_lanes();
    for (const Sheet& sheet : model.sheets) {
        const bool strips = params.sweep != Sweep::coloured && sheet.is_grid() && suits_strips(model, sheet);
        if (params.sweep == Sweep::rows && !strips)
            throw Error(fmt::format(
                "sweep: rows needs a sheet of equal cells, which {} is not; choose coloured or auto", sheet.name));
        if (params.tethers == Tethers::contacts && !strips)
            throw Error(fmt::format(
                "tethers: contacts needs a sheet of equal cells, which {} is not; choose pins or none", sheet.name));
        if (strips)
            parts_.push_back(std::make_unique<StripSheet>(model, sheet, lanes));
        else
            parts_.push_back(std::make_unique<MeshSheet>(model, sheet, lanes));
    }
}

void CpuXpbd::upload(const ClothState& state)
{
    for (const auto& part : parts_) part->upload(state);
}

void CpuXpbd::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (const auto& part : parts_) part->upload_velocities(velocities);
}

void CpuXpbd::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    for (const auto& part : parts_) part->set_vertex(vertex, position);
}

void CpuXpbd::step(const StepInput& input)
{
    const bool changed = !weights_for_ || spring_weights_differ(*weights_for_, input.params);
    if (changed) weights_ = spring_weights(model_, input.params);
    weights_for_ = input.params;
    bodies_.plan(input);
    const auto step_parts = [&](int first, int count, bool weights_changed) {
        for (const auto& part : parts_)
            part->step({input, first, count, pool_, bodies_, weights_, weights_changed, accelerations_});
    };
    if (!face_forces(input.params).air) {
        accelerations_ = {};
        return step_parts(0, input.substep_count, changed);
    }
    // The air's force depends on the velocity so strongly that it must be taken in every substep.
    if (!air_) air_.emplace(model_);
    velocities_.resize(positions_.size());
    for (int k = 0; k < input.substep_count; ++k) {
        download_positions(positions_);
        download_velocities(velocities_);
        const double time_s = input.start_time_s + k * double(substep_s(input.params));
        accelerations_ = air_->accelerations(positions_, velocities_, input.params, time_s, pool_);
        step_parts(k, 1, changed && k == 0);
    }
}

void CpuXpbd::download_positions(std::span<glm::vec4> positions)
{
    for (const auto& part : parts_) part->download_positions(positions);
}

void CpuXpbd::download_velocities(std::span<glm::vec4> velocities)
{
    for (const auto& part : parts_) part->download_velocities(velocities);
}

std::optional<std::uint32_t> CpuXpbd::first_not_finite()
{
    download_positions(positions_);
    const std::optional<std::uint32_t> bad = nuno::first_not_finite(positions_);
    download_velocities(positions_);
    const std::optional<std::uint32_t> bad_velocity = nuno::first_not_finite(positions_);
    if (bad && bad_velocity) return std::min(*bad, *bad_velocity);
    return bad ? bad : bad_velocity;
}

}  // namespace nuno
