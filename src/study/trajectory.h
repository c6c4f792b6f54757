// Where a scene went, frame by frame, and how far two such ways are apart.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "sim/frame_stats.h"

namespace nuno {

// A run of some frames; frame 0 is the start.
struct Trajectory
{
    std::vector<std::vector<glm::vec3>> positions;  // [m] of every vertex in every frame
    std::vector<double> mechanical_j;               // kinetic, elastic and of gravity, in every frame
    std::vector<double> kinetic_j;
    double largest_strain = 0;     // of a thread in any frame
    std::vector<double> frame_ms;  // of solver and collision, of the frames after the start
    CollisionCounts count;
    int substeps = 0;     // a frame, as used
    std::string failure;  // how it went bad; what is there ends before
    bool too_slow = false;

    int frames() const { return static_cast<int>(positions.size()) - 1; }
    double ms() const;         // of all frames
    double median_ms() const;  // of a frame, of at least one
};

// Called after each frame of a run; what it throws ends the run.
using FrameWatch = std::function<void()>;

// What ends a run early; asked after each frame.
struct RunLimits
{
    std::optional<double> most_ms = {};    // a simulated second: `too_slow`
    std::optional<double> enough_ms = {};  // of all frames; no failure
    FrameWatch watch = {};
};

// Runs a scene. It ends early at a limit, or where it goes bad (`failure`). Error where scene or parameters do not work
// at all.
Trajectory run_trajectory(const Scene& scene, const SimParams& params, int frames, const RunLimits& limits = {});

// The least time [ms] of `frames` frames from the start, of up to `repeats` runs after a first frame that warms up, as
// many as fit into `most_ms` but one at least; nothing else is measured on the way. `watch`: as in RunLimits.
double least_frames_ms(const Scene& scene, const SimParams& params, int frames, int repeats, double most_ms,
                       const FrameWatch& watch = {});

struct TrajectoryError
{
    double rms_m = 0, largest_m = 0;  // distance of a vertex from where it should be, over all vertices and frames
    double energy_share = 0;  // largest difference of mechanical energy, of the largest change of it in the reference
};

// Of the frames 1 .. `frames`, which both must have, on one mesh.
TrajectoryError error_against(const Trajectory& run, const Trajectory& reference, int frames);

// The root of the mean square distance of the vertices of two poses [m].
double rms_distance(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b);

}  // namespace nuno
