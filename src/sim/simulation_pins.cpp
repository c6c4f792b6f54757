// Vertices that are pinned and let go while the cloth moves.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "sim/simulation.h"
#include "solver/method_choice.h"
#include "solver/method_table.h"

namespace nuno {

// A state has no inverse mass where a vertex is pinned, so it tells its pins itself.
Simulation::Pins Simulation::pins_of(const ClothState& state) const
{
    Pins pins;
    for (const glm::vec4& position : state.positions) pins.pinned.push_back(position.w == 0);
    for (const HandlePin& pin : scene_pins_.handle_pins)
        if (pins.pinned[pin.vertex] != 0) pins.handle_pins.push_back(pin);
    return pins;
}

// The solver is then without a state.
void Simulation::use_pins(Pins pins)
{
    Pins before{model_->pinned, model_->handle_pins};
    if (pins == before) return;
    const auto set = [&](Pins&& now) {
        model_->pinned = std::move(now.pinned);
        model_->handle_pins = std::move(now.handle_pins);
    };
    set(std::move(pins));
    try {
        const SimParams params = resolve_params(*model_, bodies(), asked_);
        solver_ = make_solver(*model_, bodies(), params, *pool_);
        params_ = params;
    } catch (...) {
        set(std::move(before));
        throw;
    }
    stiffest_mode_.clear();
}

bool Simulation::is_as_placed() const
{
    return bodies_.shifts().empty() && scene_pins_ == Pins{model_->pinned, model_->handle_pins};
}

void Simulation::set_pinned(std::uint32_t vertex, bool pinned)
{
    if (pinned == is_pinned(vertex)) return;
    const auto of_vertex = [&](const HandlePin& pin) { return pin.vertex == vertex; };
    const auto& on_handles = scene_pins_.handle_pins;
    if (pinned && std::any_of(on_handles.begin(), on_handles.end(), of_vertex))
        throw Error(
            fmt::format("{}: vertex {} hung on a handle and was let go; restart to put it back", scene_.name, vertex));
    release_vertex();
    ClothState state = this->state();
    state.positions[vertex].w = pinned ? 0.0f : inverse_mass(*model_, vertex, params_.areal_density);
    if (pinned) state.velocities[vertex] = glm::vec4(0, 0, 0, state.velocities[vertex].w);
    use_pins(pins_of(state));
    state_ = std::move(state);
    solver_->upload(state_);
    positions_fresh_ = velocities_fresh_ = true;
    keeps_contacts_ = false;
    rest_watch_.wake();
}

}  // namespace nuno
