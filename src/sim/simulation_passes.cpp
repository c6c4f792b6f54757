// The passes of a frame: solver and collision in turn.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/stopwatch.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

// What vertices that may touch move relative to each other in a pass, or bodies at all, about [m], where passes are
// chosen; and how many that are at most.
constexpr double kMotionOfPass = 0.05;
constexpr int kMostChosenPasses = 16;

// Layers are about at rest where none that may touch moves further in a pass, relative to another, than this share of
// the thickness.
constexpr double kSlowApproach = 0.5;

// How far the fastest body goes between two times [m]; turning is not counted.
double largest_body_motion(const Bodies& bodies, double from_s, double to_s)
{
    double largest = 0;
    for (const PlacedBody& body : placed_bodies(bodies))
        if (body.motion->moves())
            largest = std::max(largest, glm::distance(pose_at(*body.motion, body.rest, from_s).position,
                                                      pose_at(*body.motion, body.rest, to_s).position));
    return largest;
}

bool follows_the_way(const SimParams& params) { return params.collision >= CollisionLevel::continuous; }

LayerSettings layer_settings(const SimParams& params)
{
    return {.thickness = params.thickness,
            .friction = params.friction,
            .static_friction = params.static_friction,
            .guaranteed = params.collision == CollisionLevel::guaranteed,
            .culling = params.culling,
            .budget_ms = params.collision_budget};
}

}  // namespace

int most_passes(const SimParams& params)
{
    if (params.collision == CollisionLevel::none) return 1;
    if (params.collision_passes > 0) return params.collision_passes;
    return sees_ahead(params.collision) ? kMostChosenPasses : 1;
}

FrameStats Simulation::advance_frame()
{
    FrameStats stats;
    bodies_.advance(time_s_, 1.0 / params_.frame_rate);
    if (!may_sleep(stats)) run_passes(stats);
    stats.frame = ++frame_;
    stats.time_s = time_s_ += 1.0 / params_.frame_rate;
    return stats;
}

// Whether the cloth is at rest, and stays so in the coming frame.
bool Simulation::may_sleep(FrameStats& stats)
{
    if (params_.sleep_motion <= 0) return false;
    if (held_ || surroundings_change(params_, bodies(), time_s_, time_s_ + 1.0 / params_.frame_rate)) {
        rest_watch_.wake();
        return false;
    }
    if (frame_ % RestWatch::kFramesBetween == 0 && !rest_watch_.is_at_rest()) {
        Stopwatch watch;
        if (!positions_fresh_) solver_->download_positions(state_.positions);
        positions_fresh_ = true;
        stats.stage_ms.readback += watch.lap_ms();
        rest_watch_.look(state_.positions, time_s_, params_.sleep_motion);
    }
    return rest_watch_.is_at_rest();
}

void Simulation::run_passes(FrameStats& stats)
{
    Stopwatch measuring;
    follow_stretch();
    stats.stage_ms.solve = measuring.lap_ms();
    stats.substeps = params_.substeps;
    last_level_ = params_.collision;
    const double h = double(substep_s(params_));
    const int substeps = params_.substeps, passes = sees_ahead(params_.collision)
                                                        ? foresee_frame(stats)
                                                        : std::min(most_passes(params_), params_.substeps);
    if (!sees_ahead(params_.collision)) {
        if (keeps_contacts_) hand_on_contacts(stats, {});
        start_positions_.clear();
    }
    for (int pass = 0; pass < passes; ++pass) {
        const int first = substeps * pass / passes, last = substeps * (pass + 1) / passes;
        const auto interval_s = static_cast<float>((last - first) * h);
        if (sees_ahead(params_.collision)) {
            if (pass > 0) hand_on_contacts(stats, foresee(stats, interval_s));
            start_positions_ = state_.positions;
            pass_s_ = interval_s;
        }
        Stopwatch watch;
        run_substeps(first, last);
        solver_->finish();
        stats.stage_ms.solve += watch.lap_ms();
        positions_fresh_ = velocities_fresh_ = false;
        const bool on_host = params_.collision != CollisionLevel::none || params_.count_pass_through;
        if (on_host) {
            solver_->download_positions(state_.positions);
            positions_fresh_ = true;
            stats.stage_ms.readback += watch.lap_ms();
        }
        check_not_lost(on_host ? first_lost(state_.positions) : solver_->first_lost(), first, last);
        if (follows_the_way(params_)) respond_to_impacts(stats, interval_s);
        if (on_host) collide(stats, interval_s);
    }
}

// Contacts until the end of the first pass, and the number of passes. Where that is chosen, it is what the frame before
// would have needed, or more where layers near each other faster now.
int Simulation::foresee_frame(FrameStats& stats)
{
    const int substeps = params_.substeps, most = std::min(most_passes(params_), substeps);
    const auto pass_s = [&](int passes) {
        const int of_first = substeps / passes;
        return static_cast<float>(of_first * double(substep_s(params_)));
    };
    const bool chosen = params_.collision_passes == 0;
    int passes = chosen ? std::min(chosen_passes_, most) : most;
    const SpeculativeContacts* found = &foresee(stats, pass_s(passes));
    if (chosen) {
        const double of_bodies = largest_body_motion(bodies(), time_s_, time_s_ + 1.0 / params_.frame_rate);
        const double motion = std::max(double(found->largest_approach) * passes, of_bodies);
        chosen_passes_ = std::clamp(static_cast<int>(std::ceil(motion / kMotionOfPass)), 1, most);
        if (chosen_passes_ > passes) found = &foresee(stats, pass_s(passes = chosen_passes_));
    }
    hand_on_contacts(stats, *found);
    return passes;
}

// Vertices are taken to go on as they did in the last pass: how stiff threads shake them meanwhile leads nowhere.
const SpeculativeContacts& Simulation::foresee(FrameStats& stats, float interval_s)
{
    Stopwatch watch;
    if (!layers_) layers_ = std::make_unique<ContinuousCollision>(*model_, *pool_);
    if (!positions_fresh_) solver_->download_positions(state_.positions);
    positions_fresh_ = true;
    if (start_positions_.empty()) download();
    stats.stage_ms.readback += watch.lap_ms();
    std::vector<glm::vec4> velocities = state_.velocities;
    for (std::size_t v = 0; v < start_positions_.size(); ++v)
        velocities[v] = (state_.positions[v] - start_positions_[v]) / pass_s_;
    const SpeculativeContacts& found =
        layers_->foresee(state_.positions, velocities, interval_s, layer_settings(params_));
    stats.stage_ms.query += watch.lap_ms();
    return found;
}

void Simulation::hand_on_contacts(FrameStats& stats, const SpeculativeContacts& found)
{
    Stopwatch watch;
    const bool slow = double(found.largest_approach) <= kSlowApproach * double(params_.thickness);
    if (keeps_contacts_ || !found.contacts.empty())
        solver_->set_contacts(found.contacts, model_->vertex_count(),
                              slow ? ContactOrder::steady : ContactOrder::first_free);
    keeps_contacts_ = !found.contacts.empty();
    stats.stage_ms.upload += watch.lap_ms();
    const auto contact_count = static_cast<std::uint32_t>(found.contacts.size());
    stats.count.contacts += contact_count;
    stats.peak_contacts = std::max(stats.peak_contacts, contact_count);
}

void Simulation::respond_to_impacts(FrameStats& stats, float interval_s)
{
    Stopwatch watch;
    solver_->download_velocities(state_.velocities);
    velocities_fresh_ = true;
    stats.stage_ms.readback += watch.lap_ms();
    const CollisionCounts counts =
        layers_->respond({start_positions_, state_.positions, state_.velocities, interval_s}, layer_settings(params_));
    stats.stage_ms.respond += watch.lap_ms();
    if (held_) held_->set_position(glm::vec3(state_.positions[held_->vertex()]));
    if (counts.impacts > 0) {
        solver_->upload_positions(state_.positions);
        solver_->upload_velocities(state_.velocities);
        stats.stage_ms.upload += watch.lap_ms();
    }
    stats.count.add(counts);
}

void Simulation::collide(FrameStats& stats, float interval_s)
{
    const CollisionStep step{pass_positions_, state_.positions, state_.velocities, interval_s};
    Stopwatch watch;
    collision_->refit(step, collision_settings(params_));
    stats.stage_ms.refit += watch.lap_ms();
    const bool contacts = collision_->query(step);
    stats.stage_ms.query += watch.lap_ms();
    if (contacts) {
        solver_->download_velocities(state_.velocities);
        velocities_fresh_ = true;
        stats.stage_ms.readback += watch.lap_ms();
        collision_->respond(step);
        stats.stage_ms.respond += watch.lap_ms();
        solver_->upload_velocities(state_.velocities);
        stats.stage_ms.upload += watch.lap_ms();
    }
    if (params_.count_pass_through) {  // a measurement, in no stage
        collision_->count_pass_through(step);
        pass_positions_ = state_.positions;
    }
    stats.count.add(collision_->counts());
    stats.peak_contacts = std::max(stats.peak_contacts, collision_->counts().contacts);
}

}  // namespace nuno
