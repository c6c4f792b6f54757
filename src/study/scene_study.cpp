// The horizon and the reference of a scene.
#include "study/scene_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/simulation.h"
#include "solver/method_choice.h"

namespace nuno {
namespace {

constexpr float kShift = 1e-6f;  // [m] along each axis, of the other start
// Of reference runs, and of the runs that they are held against; and substeps where layers meet, which are answered in
// each.
constexpr float kReferenceTolerance = 1e-3f, kFinerShare = 0.1f;
constexpr int kContactSubsteps = 128;

// How long a scene without an end check is followed.
constexpr int kLongSeconds = 4;

// xpbd takes springs without dampers.
bool takes_xpbd(const SimParams& params)
{
    return params.internal_model != InternalModel::continuum && params.stiffness_damping <= 0;
}

SimParams finer(SimParams params)
{
    params.tolerance *= kFinerShare;
    params.substeps *= 2;
    return params;
}

// Another start, each vertex up to kShift along each axis from where it is.
SimParams shifted(SimParams params)
{
    params.jitter = params.seed == 0 ? kShift : params.jitter + kShift;
    if (params.seed == 0) params.seed = 1;
    return params;
}

int frames_of(double seconds, const SimParams& params)
{
    return std::max(1, static_cast<int>(std::lround(seconds * params.frame_rate)));
}

}  // namespace

int long_frames(const SceneStudy& study)
{
    const int checked = study.scene().check.frames;
    return checked > 0 ? checked : kLongSeconds * study.asked_params().frame_rate;
}

int layers_meet(const Scene& scene, SimParams params, int frames, const FrameWatch& watch)
{
    params.collision = std::max(params.collision, CollisionLevel::speculative);
    params.culling = Culling::sound;
    SimParams automatic = params;
    automatic.method = Method::automatic;
    automatic.substeps = automatic.iterations = 0;
    int frame = 0;
    for (const SimParams& tried : {params, automatic}) {
        Simulation simulation(scene, tried);
        try {
            for (frame = 1; frame <= frames; ++frame) {
                if (simulation.advance_frame().count.contacts > 0) return frame;
                if (watch) watch();
            }
            return 0;
        } catch (const Error& error) {
            if (error.code() != ExitCode::went_bad) throw;
        }
    }
    return frame;
}

double cloth_size(const ClothModel& model)
{
    double size = 0;
    for (const Sheet& sheet : model.sheets) {
        glm::dvec3 lo(1e30), hi(-1e30);
        for (std::uint32_t v = sheet.first_vertex; v < sheet.first_vertex + sheet.vertex_count; ++v) {
            lo = glm::min(lo, glm::dvec3(model.rest_positions[v]));
            hi = glm::max(hi, glm::dvec3(model.rest_positions[v]));
        }
        const glm::dvec3 sides = hi - lo;
        size = std::max({size, sides.x, sides.y, sides.z});
    }
    return size;
}

SimParams reference_params(SimParams params)
{
    params.method = Method::reference;
    params.tethers = Tethers::none;
    params.iterations = 0;
    params.tolerance = kReferenceTolerance;
    params.substeps = params.collision == CollisionLevel::none ? 0 : kContactSubsteps;
    return params;
}

SceneStudy::SceneStudy(Scene scene, const SimParams& params, FrameWatch watch)
    : scene_(std::move(scene)), params_(params), base_(params), watch_(std::move(watch))
{
    params_.backend = base_.backend = Backend::cpu;
    params_.count_pass_through = base_.count_pass_through = 0;
    params_.sleep_motion = base_.sleep_motion = 0;  // costs are those of cloth in motion
}

const SimParams& SceneStudy::params()
{
    scene_class();
    return base_;
}

const Trajectory& SceneStudy::reference()
{
    scene_class();
    return reference_;
}

const SceneClass& SceneStudy::scene_class()
{
    if (failure_) throw *failure_;
    if (class_) return *class_;
    try {
        classify();
    } catch (const Error& error) {
        class_.reset();
        failure_ = error;
        throw;
    }
    return *class_;
}

void SceneStudy::classify()
{
    class_.emplace();
    const ClothModel model = build_cloth_model(make_sheets(scene_, params_), params_.mass_lumping);
    class_->size_m = cloth_size(model);
    class_->particles = model.vertex_count();
    class_->frames = frames_of(kLongestHorizon, params_);
    class_->first_contact = layers_meet(scene_, params_, class_->frames, watch_);
    SimParams swept = params_;
    swept.method = Method::xpbd;
    class_->is_tethered = takes_xpbd(params_) && resolve_params(model, scene_.bodies, swept).tethers != Tethers::none;
    find_horizon();
}

SimParams SceneStudy::find_reference()
{
    const int frames = class_->frames;
    const SimParams exact = reference_params(base_);
    reference_ = run_trajectory(scene_, exact, frames, {.watch = watch_});
    if (reference_.failure.empty()) return exact;
    const SimParams closer = finer(exact);
    reference_ = run_trajectory(scene_, closer, frames, {.watch = watch_});
    if (reference_.failure.empty()) return closer;
    throw Error(fmt::format("{} (the converged run that errors are held against, also with a tenth of its tolerance: "
                            "without it no error can be told; softer springs, less load or a smaller frame would give "
                            "one)",
                            reference_.failure),
                ExitCode::went_bad);
}

void SceneStudy::find_horizon()
{
    const int shortest = frames_of(kShortestHorizon, params_);
    SceneClass& found = *class_;
    // Layers that meet later than the shortest horizon end it: each level answers them its own way.
    if (params_.collision != CollisionLevel::none && found.first_contact > shortest)
        found.frames = std::min(found.frames, found.first_contact - 1);
    const bool meets = found.first_contact > 0 && found.first_contact <= found.frames;
    if (!meets) base_.collision = CollisionLevel::none;
    if (params_.collision == CollisionLevel::none) found.first_contact = 0;

    const SimParams exact = find_reference();
    const Trajectory other = run_trajectory(scene_, shifted(exact), found.frames, {.watch = watch_});
    int frame = 1;
    for (; frame <= std::min(found.frames, other.frames()); ++frame) {
        const auto f = static_cast<std::size_t>(frame);
        const double doubt = rms_distance(reference_.positions[f], other.positions[f]) / found.size_m;
        found.is_chaotic = frame > shortest && doubt > kMostDoubt;
        if (found.is_chaotic) break;
        found.doubt_share = std::max(found.doubt_share, doubt);
    }
    found.frames = frame - 1;
    if (found.frames < 1) throw Error(other.failure + " (a shifted start of the study)", ExitCode::went_bad);

    const Trajectory check = run_trajectory(scene_, finer(exact), found.frames, {.watch = watch_});
    if (check.frames() < found.frames)
        throw Error(check.failure + " (the check of the reference of the study)", ExitCode::went_bad);
    found.reference_error_m = error_against(reference_, check, found.frames).rms_m;
}

nlohmann::ordered_json class_json(const SceneClass& c, const SimParams& base)
{
    return {{"size_m", c.size_m},
            {"particles", c.particles},
            {"frames", c.frames},
            {"frame_rate", base.frame_rate},
            {"doubt_share", c.doubt_share},
            {"tethered", c.is_tethered},
            {"chaotic", c.is_chaotic},
            {"first_contact_frame", c.first_contact},
            {"collision", choice_names(CollisionLevel{})[std::size_t(base.collision)]},
            {"reference_error_m", c.reference_error_m}};
}

}  // namespace nuno
