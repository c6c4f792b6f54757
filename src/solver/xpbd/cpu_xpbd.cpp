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
    : HostSolver(pool), model_(model), bodies_(bodies, model), tethers_(model), positions_(model.vertex_count())
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
            parts_.push_back(std::make_unique<MeshSheet>(model, sheet, params.sweep != Sweep::coloured, lanes));
    }
}

void CpuXpbd::upload(const ClothState& state)
{
    for (const auto& part : parts_) part->upload(state);
    tethers_.upload(state);
}

void CpuXpbd::upload_positions(std::span<const glm::vec4> positions)
{
    for (const auto& part : parts_) part->upload_positions(positions);
}

void CpuXpbd::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (const auto& part : parts_) part->upload_velocities(velocities);
}

void CpuXpbd::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    for (const auto& part : parts_) part->set_vertex(vertex, position);
    tethers_.set_vertex(vertex, position);
}

void CpuXpbd::move_vertices(std::span<const VertexMove> moves)
{
    for (const auto& part : parts_) part->move_vertices(moves);
}

void CpuXpbd::carry(Archive& archive, const SimParams& params)
{
    for (const auto& part : parts_) part->carry(archive, params);
}

void CpuXpbd::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    const bool weights_changed = !weights_for_ || spring_weights_differ(*weights_for_, input.params);
    if (weights_changed) weights_ = spring_weights(model_, input.params);
    weights_for_ = input.params;
    bodies_.plan(input);
    XpbdStep step{.input = input,
                  .first_substep = 0,
                  .substep_count = input.substep_count,
                  .pool = pool_,
                  .bodies = bodies_,
                  .weights = weights_,
                  .tethers = {},
                  .weights_changed = weights_changed,
                  .tethers_changed = tethers_.refresh(input.params),
                  .accelerations = {}};
    step.tethers = tethers_.tethers();
    if (!face_forces(input.params).air) return step_parts(step);
    // The air's force depends on the velocity so strongly that it must be taken in every substep.
    for (int k = 0; k < input.substep_count; ++k) {
        blow(input.params, input.start_time_s + k * double(substep_s(input.params)));
        step.accelerations = accelerations_;
        step.first_substep = k;
        step.substep_count = 1;
        step_parts(step);
        step.weights_changed = step.tethers_changed = false;
    }
}

void CpuXpbd::blow(const SimParams& params, double time_s)
{
    if (!air_) air_.emplace(model_);
    velocities_.resize(positions_.size());
    accelerations_.resize(positions_.size());
    download_positions(positions_);
    download_velocities(velocities_);
    const auto motion_of = [&](std::uint32_t vertex) {
        return formulas::motion(glm::vec3(positions_[vertex]), glm::vec3(velocities_[vertex]));
    };
    const auto take = [&](std::uint32_t vertex, glm::vec3 force) {
        accelerations_[vertex] = positions_[vertex].w * force;
    };
    run_team(pool_, team_size(pool_, model_.vertex_count()),
             [&](const Team& team) { air_->run(params, time_s, team, motion_of, take); });
}

void CpuXpbd::step_parts(const XpbdStep& step)
{
    for (const auto& part : parts_) part->step(step);
}

void CpuXpbd::download_positions(std::span<glm::vec4> positions)
{
    for (const auto& part : parts_) part->download_positions(positions);
}

void CpuXpbd::download_velocities(std::span<glm::vec4> velocities)
{
    for (const auto& part : parts_) part->download_velocities(velocities);
}

std::optional<std::uint32_t> CpuXpbd::first_lost()
{
    download_positions(positions_);
    const std::optional<std::uint32_t> bad = nuno::first_lost(positions_);
    download_velocities(positions_);
    const std::optional<std::uint32_t> bad_velocity = nuno::first_lost(positions_);
    if (bad && bad_velocity) return std::min(*bad, *bad_velocity);
    return bad ? bad : bad_velocity;
}

}  // namespace nuno
