// Runs of scenes, recorded.
#include "study/trajectory.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/quantile.h"
#include "core/stopwatch.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

void record(Simulation& simulation, Trajectory& run)
{
    const Diagnostics now = simulation.diagnostics();
    std::vector<glm::vec3>& positions = run.positions.emplace_back();
    for (const glm::vec4& position : simulation.state().positions) positions.emplace_back(position);
    run.kinetic_j.push_back(now.kinetic_j);
    run.mechanical_j.push_back(now.kinetic_j + now.gravity_j + now.elastic_j);
    run.largest_strain = std::max(run.largest_strain, now.max_strain);
}

double square_sum(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b, double* largest = nullptr)
{
    assert(a.size() == b.size());
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
        const glm::dvec3 apart = glm::dvec3(a[v]) - glm::dvec3(b[v]);
        const double square = glm::dot(apart, apart);
        sum += square;
        if (largest != nullptr) *largest = std::max(*largest, square);
    }
    return sum;
}

}  // namespace

double Trajectory::ms() const { return std::accumulate(frame_ms.begin(), frame_ms.end(), 0.0); }

double Trajectory::median_ms() const { return median(frame_ms); }

Trajectory run_trajectory(const Scene& scene, const SimParams& params, int frames, const RunLimits& limits)
{
    Simulation simulation(scene, params);
    Trajectory run;
    run.substeps = simulation.params().substeps;
    record(simulation, run);
    try {
        for (int frame = 1; frame <= frames; ++frame) {
            const FrameStats stats = simulation.advance_frame();
            run.frame_ms.push_back(simulation_ms(stats.stage_ms));
            run.count.add(stats.count);
            record(simulation, run);
            run.too_slow = limits.most_ms && run.ms() > *limits.most_ms * stats.time_s;
            if (run.too_slow || (limits.enough_ms && run.ms() > *limits.enough_ms)) break;
            if (limits.watch) limits.watch();
        }
    } catch (const Error& error) {
        if (error.code() != ExitCode::went_bad) throw;
        run.failure = error.what();
    }
    return run;
}

double least_frames_ms(const Scene& scene, const SimParams& params, int frames, int repeats, double most_ms,
                       const FrameWatch& watch)
{
    Simulation simulation(scene, params);
    simulation.advance_frame();
    if (watch) watch();
    double least = std::numeric_limits<double>::infinity();
    Stopwatch stopwatch;
    for (int run = 0; run < repeats && (run == 0 || stopwatch.elapsed_ms() < most_ms); ++run) {
        simulation.restart();
        double ms = 0;
        for (int frame = 0; frame < frames; ++frame) {
            ms += simulation_ms(simulation.advance_frame().stage_ms);
            if (watch) watch();
        }
        least = std::min(least, ms);
    }
    return least;
}

TrajectoryError error_against(const Trajectory& run, const Trajectory& reference, int frames)
{
    assert(run.frames() >= frames && reference.frames() >= frames && frames > 0);
    TrajectoryError error;
    double sum = 0, largest = 0, energy = 0, change = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        const auto f = static_cast<std::size_t>(frame);
        sum += square_sum(run.positions[f], reference.positions[f], &largest);
        energy = std::max(energy, std::abs(run.mechanical_j[f] - reference.mechanical_j[f]));
        change = std::max(
            change, std::max(std::abs(reference.mechanical_j[f] - reference.mechanical_j[0]), reference.kinetic_j[f]));
    }
    error.rms_m = std::sqrt(sum / (double(frames) * double(run.positions[0].size())));
    error.largest_m = std::sqrt(largest);
    error.energy_share = change > 0 ? energy / change : 0;
    return error;
}

double rms_distance(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    return std::sqrt(square_sum(a, b) / double(a.size()));
}

}  // namespace nuno
