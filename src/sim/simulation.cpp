// One scene in motion.
#include "sim/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/stopwatch.h"
#include "model/stability.h"
#include "sim/stability_advice.h"
#include "solver/method_choice.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

constexpr int kMostFramesAtOnce = 4;
constexpr double kHandMoveSeconds = 0.001;  // about how often a held vertex moves

// What a solver is made for, and what not every solver takes.
bool needs_new_solver(const SimParams& a, const SimParams& b)
{
    const auto key = [](const SimParams& p) {
        return std::tuple(p.method, p.backend, p.sweep, p.tethers, p.internal_model, p.strain_limit > 0,
                          p.stiffness_damping > 0, bends(p));
    };
    return key(a) != key(b);
}

}  // namespace

Simulation::Simulation(Scene scene, const SimParams& params) : scene_(std::move(scene)), bodies_(scene_.bodies)
{
    build(params);
}
Simulation::~Simulation() = default;

void Simulation::build(const SimParams& asked)
{
    check_collision_settings(asked);
    auto model = std::make_unique<ClothModel>(build_cloth_model(make_sheets(scene_, asked), asked.mass_lumping));
    const SimParams params = resolve_params(*model, bodies(), asked);
    std::optional<SavedState> start;
    if (!scene_.state.empty()) start = read_state(scene_.state, scene_.params, model->vertex_count());
    auto pool = std::make_unique<ThreadPool>(params.threads);
    auto solver = make_solver(*model, bodies(), params, *pool);
    solver_ = std::move(solver);
    collision_ = std::make_unique<SelfCollision>(model->rest_positions, model->faces, model->sheets, *pool);
    layers_.reset();
    pool_ = std::move(pool);
    model_ = std::move(model);
    scene_pins_ = {model_->pinned, model_->handle_pins};
    start_ = std::move(start);
    stiffest_mode_.clear();
    asked_ = asked;
    params_ = params;
    restart();
}

void Simulation::restart()
{
    if (start_) {
        try {
            resume(*start_);
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", scene_.state.string(), error.what()));
        }
        start_check_ = check_now(params_);
        return;
    }
    use_pins(scene_pins_);
    bodies_.set_shifts({});
    ClothState state = start_state(*model_, params_);
    start_check_ = check_start(*model_, params_, state.positions, *pool_);
    begin_at(std::move(state), 0, 0);
}

void Simulation::set_params(const SimParams& asked)
{
    for (const ParamInfo& info : sim_param_table())
        if (needs_restart(info.name) && param_value(info, &asked) != param_value(info, &asked_)) return build(asked);

    check_collision_settings(asked);
    const SimParams params = resolve_params(*model_, bodies(), asked);
    const bool new_pool = params.threads != params_.threads;
    const bool new_solver = new_pool || needs_new_solver(params, params_);
    if (new_solver || params.areal_density != params_.areal_density) {
        state();
        auto pool = new_pool ? std::make_unique<ThreadPool>(params.threads) : nullptr;
        if (new_solver) solver_ = make_solver(*model_, bodies(), params, pool ? *pool : *pool_);
        if (new_pool) {
            collision_ = std::make_unique<SelfCollision>(model_->rest_positions, model_->faces, model_->sheets, *pool);
            layers_.reset();
            pool_ = std::move(pool);
        }
        for (std::uint32_t v = 0; v < model_->vertex_count(); ++v)
            if (state_.positions[v].w > 0) state_.positions[v].w = inverse_mass(*model_, v, params.areal_density);
        solver_->upload(state_);
    }
    if (params.count_pass_through && !params_.count_pass_through) pass_positions_ = state().positions;
    if (sees_ahead(params.collision) && !sees_ahead(params_.collision)) start_check_ = check_now(params);
    asked_ = asked;
    params_ = params;
    rest_watch_.wake();
}

// Not to be untangled: the cloth is on its way.
StartCheck Simulation::check_now(SimParams params)
{
    params.untangle = false;
    std::vector<glm::vec4> positions = state().positions;
    return check_start(*model_, params, positions, *pool_);
}

// A membrane stiffens as it is stretched, so its automatic substeps follow.
void Simulation::follow_stretch()
{
    if (asked_.substeps > 0 || params_.internal_model != InternalModel::continuum || !is_explicit(params_.method))
        return;
    const double stretch = largest_face_stretch(*model_, state(), 1.0 / params_.frame_rate);
    params_.substeps = resolve_params(*model_, bodies(), asked_, stretch).substeps;
}

std::vector<FrameStats> Simulation::advance(double elapsed_s, const std::function<void(const FrameStats&)>& after_frame)
{
    std::vector<FrameStats> frames;
    const double frame_s = 1.0 / params_.frame_rate;
    pending_s_ = std::min(pending_s_ + elapsed_s, kMostFramesAtOnce * frame_s);
    for (; pending_s_ >= frame_s; pending_s_ -= frame_s) {
        frames.push_back(advance_frame());
        if (after_frame) after_frame(frames.back());
    }
    return frames;
}

void Simulation::download()
{
    if (!positions_fresh_) solver_->download_positions(state_.positions);
    if (!velocities_fresh_) solver_->download_velocities(state_.velocities);
    positions_fresh_ = velocities_fresh_ = true;
}

const ClothState& Simulation::state()
{
    download();
    return state_;
}

bool Simulation::hold_vertex(std::uint32_t vertex, glm::vec3 target)
{
    const auto on_handle = [&](const HandlePin& pin) { return pin.vertex == vertex; };
    if (std::any_of(model_->handle_pins.begin(), model_->handle_pins.end(), on_handle)) return false;
    if (held_ && held_->vertex() != vertex) release_vertex();
    if (!held_) held_.emplace(*model_, params_, vertex, glm::vec3(state().positions[vertex]));
    held_->set_target(target);
    return true;
}

void Simulation::release_vertex()
{
    if (!held_) return;
    const std::uint32_t v = held_->vertex();
    const float w = model_->pinned[v] ? 0.0f : inverse_mass(*model_, v, params_.areal_density);
    solver_->set_vertex(v, glm::vec4(held_->position(), w));
    positions_fresh_ = velocities_fresh_ = false;
    held_.reset();
}

void Simulation::run_substeps(int first, int last)
{
    const double h = double(substep_s(params_));
    if (!held_ && !keeps_contacts_) return solver_->step({params_, time_s_ + first * h, last - first});
    // The hand moves a little every few substeps, so that the cloth can follow.
    const int move = keeps_contacts_ ? 1 : std::max(1, static_cast<int>(kHandMoveSeconds / h));
    for (int begin = first; begin < last; begin += move) {
        const int end = std::min(last, begin + move);
        if (held_) {
            solver_->download_positions(state_.positions);
            move_held_vertex(static_cast<float>((end - begin) * h));
        }
        solver_->step({params_, time_s_ + begin * h, end - begin});
        if (keeps_contacts_) solver_->keep_contacts(params_);
    }
}

void Simulation::move_held_vertex(float duration_s)
{
    held_->advance(*model_, state_.positions, duration_s);
    solver_->set_vertex(held_->vertex(), glm::vec4(held_->position(), 0));
}

void Simulation::hold_body(std::size_t body, const glm::dvec3& way)
{
    if (params_.tethers == Tethers::contacts)
        throw Error(fmt::format(
            "{}: tethers: contacts ties cloth to where bodies are; choose pins or none to move them", scene_.name));
    bodies_.hold(body, way);
}

std::optional<PresentStability> Simulation::stability()
{
    const ClothState& now = state();
    if (first_lost(now.positions) || first_lost(now.velocities)) return std::nullopt;
    return present_stability(*model_, params_, now, stiffest_mode_);
}

std::optional<std::string> Simulation::stability_warning() const { return nuno::stability_warning(*model_, params_); }

std::optional<std::string> Simulation::present_warning()
{
    const std::optional<PresentStability> now = stability();
    return now ? nuno::present_warning(*model_, params_, *now) : std::nullopt;
}

void Simulation::check_not_lost(std::optional<std::uint32_t> vertex, int first_substep, int last_substep) const
{
    if (!vertex) return;
    throw Error(
        fmt::format("{}: frame {}, substeps {} to {}: vertex {} is no longer finite, or beyond 1e6 m or m/s; {}",
                    scene_.name, frame_ + 1, first_substep + 1, last_substep, *vertex,
                    advice_after_blow_up(*model_, params_)),
        ExitCode::went_bad);
}

}  // namespace nuno
