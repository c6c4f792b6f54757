// What a scene is like for a study of errors: how far ahead its motion can be foretold at all, whether layers meet, and
// where it should go.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/error.h"
#include "study/trajectory.h"

namespace nuno {

// How long positions can be compared. A start shifted by a millionth of a metre, about what single precision makes of
// any run, leads elsewhere; once that is this share of the size of the cloth and more, the errors of settings are lost
// in it, and only statistics of ensembles say something.
inline constexpr double kMostDoubt = 1e-3;
inline constexpr double kLongestHorizon = 1.5, kShortestHorizon = 0.2;  // [s]

struct SceneClass
{
    double size_m = 0;  // the longest side of a sheet at rest: errors are shares of it
    std::uint32_t particles = 0;
    int frames = 0;                // the horizon
    double doubt_share = 0;        // what the shift leads to within the horizon, of the size
    bool is_tethered = false;      // xpbd and vbd would tie it to its pins
    bool is_chaotic = false;       // the horizon ends there, not because it is long enough
    int first_contact = 0;         // the first frame in which layers come near; 0: none does within the horizon
    double reference_error_m = 0;  // rms, between the reference and itself with a tenth of its tolerance
};

// One scene with the parameters that its points change. What it holds is computed when first asked for.
class SceneStudy
{
  public:
    // On the cpu backend; `params` as the scene and the user have them. What `watch` throws ends what is being measured,
    // and leaves the study of no use.
    SceneStudy(Scene scene, const SimParams& params, FrameWatch watch = {});

    const Scene& scene() const { return scene_; }
    const std::string& name() const { return scene_.name; }
    // The base of all points: collision is none where layers do not come near within the horizon.
    const SimParams& params();
    const SimParams& asked_params() const { return params_; }
    const FrameWatch& watch() const { return watch_; }
    void ask_watch() const
    {
        if (watch_) watch_();
    }
    // Error where a run that it needs goes bad, as often as it is asked.
    const SceneClass& scene_class();
    // Converged, on the mesh of the scene.
    const Trajectory& reference();

  private:
    void classify();
    void find_horizon();
    // Runs it; its parameters. Error where it goes bad, and a finer one as well.
    SimParams find_reference();

    Scene scene_;
    SimParams params_, base_;
    FrameWatch watch_;
    std::optional<SceneClass> class_;
    std::optional<Error> failure_;  // of the reference; it is not tried twice
    Trajectory reference_;
};

// Frames of the whole scene: up to its end check, or some seconds.
int long_frames(const SceneStudy& study);

// Whether layers come near each other in these frames, as a quick run foresees it; the first such frame, or 0. Where that
// goes bad another with method and substeps of nuno's choice is made; where that does too, the frame counts as one.
int layers_meet(const Scene& scene, SimParams params, int frames, const FrameWatch& watch = {});

// The longest side of a sheet at rest [m].
double cloth_size(const ClothModel& model);

// The parameters of a converged run of the same model.
SimParams reference_params(SimParams params);

nlohmann::ordered_json class_json(const SceneClass& scene_class, const SimParams& base);

}  // namespace nuno
