// The CPU against the GPU: stage times, their ratio, and how far the results agree.
#pragma once

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "sim/frame_stats.h"

namespace nuno {

inline constexpr std::array<int, 4> kComparedSizes{17, 64, 128, 256};  // vertices a side
inline constexpr std::array<int, 4> kComparedSubsteps{1, 10, 100, 1000};

struct BackendCost
{
    StageTimes stage_ms;                     // medians over the timed frames
    double frame_ms = 0;                     // median of solver and collision together
    double ns_per_particle_and_substep = 0;  // of the solver
};

// One scene at one size.
struct ComparePoint
{
    std::string scene;
    int size = 0;  // vertices along the longer side; 0: the mesh of the scene
    std::uint32_t particles = 0;
    Method method = Method::automatic;  // as resolved; xpbd sweeps in colours unless told otherwise
    int substeps = 0;                   // a frame; more than the scene's where its own would be unstable at this size
    int timed_frames = 0;
    BackendCost cpu, gpu;
    std::array<double, 4>
        largest_difference_m{};  // of a position, after kComparedSubsteps without contact; -1: not finite
    std::string failure;         // how the simulation went bad, after which the rest of the point is empty; else empty
    bool substep_hashes_agree = false;  // after all of them
    bool frame_hashes_agree = false;    // after the timed frames, with contact
    std::string_view method_name() const { return choice_names(Method{})[std::size_t(method)]; }
    double ratio() const { return cpu.frame_ms > 0 ? gpu.frame_ms / cpu.frame_ms : 0; }
};

// What is run at one point.
struct CompareCase
{
    const Scene* scene;  // must outlive it
    SimParams params;
    int size;                // vertices along the longer side; 0: the mesh of the scene
    double frames_ms;        // for the timed frames of both backends; four frames at least
    std::string id() const;  // "seed/verlet/33", with the method as asked for
};

// Each scene with its own method at each size. `runs` must outlive the cases.
std::vector<CompareCase> compare_cases(const std::vector<std::pair<Scene, SimParams>>& runs,
                                       std::span<const int> sizes);

// Each scene with each of some methods, and why any of these is left out.
struct MethodCases
{
    std::vector<CompareCase> cases;
    std::vector<std::string> left_out;  // "twist, xpbd, 33: ..."
};
// `methods`: those that are asked for; none: all that both backends have.
MethodCases method_cases(const std::vector<std::pair<Scene, SimParams>>& runs, std::span<const Method> methods,
                         std::span<const int> sizes);

// Runs one, on both backends. An OpenGL context must be current.
ComparePoint compare_point(const CompareCase& c);

// Called before each point; false ends the study with what is done.
using CompareProgress = std::function<bool(int done, int total, const std::string& what)>;

// An OpenGL context must be current. Runs of the two backends are interleaved. `sizes`: vertices along the longer side
// of grids.
std::vector<ComparePoint> compare_backends(const std::vector<std::pair<Scene, SimParams>>& runs,
                                           std::span<const int> sizes, const CompareProgress& progress);

// True where every point agrees as far as it must: bit for bit on a software renderer, to 1e-5 m after one substep
// elsewhere; and where every number is finite.
bool backends_agree(const std::vector<ComparePoint>& points, bool software_gl);

std::string compare_table(const std::vector<ComparePoint>& points, bool software_gl);
nlohmann::ordered_json compare_json(const std::vector<ComparePoint>& points);
// A point of compare_json.
ComparePoint compare_point_of(const nlohmann::ordered_json& point);

}  // namespace nuno
