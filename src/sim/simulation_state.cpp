// The run as it is, taken out and put back.
#include <fmt/format.h>

#include <utility>

#include "core/error.h"
#include "sim/simulation.h"

namespace nuno {

void Simulation::begin_at(ClothState state, int frame, double time_s)
{
    state_ = std::move(state);
    solver_->upload(state_);
    positions_fresh_ = velocities_fresh_ = true;
    pass_positions_ = state_.positions;
    held_.reset();
    frame_ = frame;
    time_s_ = time_s;
    pending_s_ = 0;
    start_positions_.clear();
    layers_.reset();  // a query may go through the pairs of the one before
    chosen_passes_ = 1;
    last_level_ = CollisionLevel::none;
    rest_watch_.wake();
}

// All that a frame takes from those before it but the cloth and the time.
void Simulation::carry(Archive& archive)
{
    archive.value(params_.substeps);  // where it follows the stretch
    archive.list(start_positions_);
    archive.value(pass_s_);
    archive.value(chosen_passes_);
    rest_watch_.carry(archive);
    if (params_.count_pass_through) archive.list(pass_positions_);
    bool sees_layers = layers_ != nullptr;
    archive.value(sees_layers);
    if (sees_layers && !layers_) layers_ = std::make_unique<ContinuousCollision>(*model_, *pool_);
    if (sees_layers) layers_->carry(archive);
    collision_->carry(archive);
    solver_->carry(archive, params_);
    archive.finish();
}

SavedState Simulation::save()
{
    SavedState saved{.frame = frame_,
                     .time_s = time_s_,
                     .asked = asked_,
                     .cloth = state(),
                     .shifts = bodies_.shifts(),
                     .past_kind = past_kind(solver_->name(), params_),
                     .past = {}};
    Archive archive;
    carry(archive);
    saved.past = archive.bytes();
    if (held_) {
        const std::uint32_t v = held_->vertex();
        saved.cloth.positions[v].w = model_->pinned[v] ? 0.0f : inverse_mass(*model_, v, params_.areal_density);
        saved.cloth.velocities[v] = glm::vec4(0, 0, 0, saved.cloth.velocities[v].w);
    }
    return saved;
}

void Simulation::resume(const SavedState& saved)
{
    if (saved.cloth.positions.size() != model_->vertex_count())
        throw Error(
            fmt::format("{}: the state is of a cloth of {} vertices, not of {}; set resolution back, or restart",
                        scene_.name, saved.cloth.positions.size(), model_->vertex_count()));
    bodies_.set_shifts(saved.shifts);
    use_pins(pins_of(saved.cloth));
    ClothState cloth = saved.cloth;
    if (saved.asked.areal_density != params_.areal_density)
        for (std::uint32_t v = 0; v < model_->vertex_count(); ++v)
            if (cloth.positions[v].w > 0) cloth.positions[v].w = inverse_mass(*model_, v, params_.areal_density);
    begin_at(std::move(cloth), saved.frame, saved.time_s);
    if (saved.past_kind != past_kind(solver_->name(), params_)) return;
    Archive archive(saved.past);
    carry(archive);
    if (!same_params(saved.asked, asked_)) rest_watch_.wake();
}

}  // namespace nuno
