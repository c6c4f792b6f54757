// One scene in motion: owns the cloth, its solver and its collision, and runs them frame by frame.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision/continuous.h"
#include "core/thread_pool.h"
#include "model/cloth_state.h"
#include "model/diagnostics.h"
#include "model/stability.h"
#include "scene/scene.h"
#include "sim/frame_stats.h"
#include "sim/held_vertex.h"
#include "sim/last_pass.h"
#include "sim/movable_bodies.h"
#include "sim/rest_watch.h"
#include "sim/saved_state.h"
#include "sim/start_check.h"
#include "solver/base/cloth_solver.h"

namespace nuno {

// Passes of self-collision a frame, at most, were there substeps enough.
int most_passes(const SimParams& params);

class Simulation
{
  public:
    // On the gpu backend a context must be current, and stay so. Error where the scene or the parameters do not work.
    Simulation(Scene scene, const SimParams& params);
    ~Simulation();

    const Scene& scene() const { return scene_; }
    // As asked for, and as used: with method, substeps and tethers chosen where they were left to nuno.
    const SimParams& asked_params() const { return asked_; }
    const SimParams& params() const { return params_; }
    const ClothModel& model() const { return *model_; }
    const Bodies& bodies() const { return bodies_.bodies(); }  // the scene's, where a hand has moved them
    std::string_view solver_name() const { return solver_->name(); }
    int frame() const { return frame_; }
    double time_s() const { return time_s_; }
    int thread_count() const { return pool_->thread_count(); }
    // Of the last start, or of when the level of collision was last raised to one that needs it.
    const StartCheck& start_check() const { return start_check_; }

    // Acts from the next frame on: forces at once, method, backend and threads with the state carried over; one of the
    // start (needs_restart) starts again. Error (nothing changed) where they do not work.
    void set_params(const SimParams& asked);
    // From the start, or from the state that the scene names.
    void restart();

    // The run as it is. Nothing of it changes by that; a vertex that is held is saved as let go.
    SavedState save();
    // Goes on from there, with the same bits where scene and parameters are those of then; with other parameters as
    // after set_params. Error where the number of vertices is another.
    void resume(const SavedState& saved);

    // Simulates one frame of 1 / frame_rate seconds. Error with ExitCode::went_bad, naming scene, frame, substeps,
    // vertex and a setting that would hold, where a vertex is lost.
    // Cloth at rest, with nothing around it that changes, sleeps: its frames have no substeps.
    FrameStats advance_frame();
    // Simulates the whole frames that `elapsed_s` of wall time ask for, but no more than a few: a machine that cannot
    // keep up slows the cloth down. The statistics are those of the frames that ran; `after_frame` gets each before
    // the next one.
    std::vector<FrameStats> advance(double elapsed_s, const std::function<void(const FrameStats&)>& after_frame = {});

    // The state now; copied from the device when first asked for after a frame.
    const ClothState& state();
    // Looking at these changes nothing of the run.
    LastPass last_pass() const;
    bool is_asleep() const { return rest_watch_.is_at_rest(); }
    Diagnostics diagnostics() { return measure(*model_, state(), params_); }
    // OpenGL name of the positions, 0 on the cpu backend.
    std::uint32_t position_buffer() const { return solver_->position_buffer(); }

    // Drags a vertex towards `target` [m] until it is released, no faster than a hand and no further than its threads
    // can stretch. A pinned vertex stays pinned where it is left; one on a handle of the scene goes with that:
    // false.
    bool hold_vertex(std::uint32_t vertex, glm::vec3 target);
    void release_vertex();
    // As MovableBodies::hold; it stays where it is left until the next restart. Error where cloth is tied to bodies.
    void hold_body(std::size_t body, const glm::dvec3& way);
    void release_body() { bodies_.release(); }

    // Whether pins and bodies are where the scene has them.
    bool is_as_placed() const;
    bool is_pinned(std::uint32_t vertex) const { return model_->pinned[vertex] != 0; }
    // Pins a vertex where it is now, or lets it go; until the next restart, after which the scene's own pins hold. The
    // solver is made anew, with the state carried over, as for another method. One that the scene puts on a handle can
    // only be let go: Error where it is to be pinned again.
    void set_pinned(std::uint32_t vertex, bool pinned);

    // How stable the parameters are where the cloth is now; the frequency is found anew each time, from where it was
    // found last. Nothing where a vertex is lost.
    std::optional<PresentStability> stability();
    // As in sim/stability_advice.h; the second looks at the cloth where it is now.
    std::optional<std::string> stability_warning() const;
    std::optional<std::string> present_warning();

  private:
    void build(const SimParams& asked);
    StartCheck check_now(SimParams params);
    void begin_at(ClothState state, int frame, double time_s);
    void carry(Archive& archive);
    // Which vertices do not move by themselves.
    struct Pins
    {
        std::vector<std::uint8_t> pinned;    // one a vertex
        std::vector<HandlePin> handle_pins;  // in order of their vertices
        bool operator==(const Pins&) const = default;
    };
    Pins pins_of(const ClothState& state) const;
    void use_pins(Pins pins);
    void download();
    void follow_stretch();
    bool may_sleep(FrameStats& stats);
    void run_passes(FrameStats& stats);
    void run_substeps(int first, int last);
    void move_held_vertex(float duration_s);
    void collide(FrameStats& stats, float interval_s);
    int foresee_frame(FrameStats& stats);
    const SpeculativeContacts& foresee(FrameStats& stats, float interval_s);
    void hand_on_contacts(FrameStats& stats, const SpeculativeContacts& found);
    void respond_to_impacts(FrameStats& stats, float interval_s);
    void check_not_lost(std::optional<std::uint32_t> vertex, int first_substep, int last_substep) const;

    Scene scene_;
    MovableBodies bodies_;
    std::optional<SavedState> start_;  // where the scene names one
    SimParams asked_, params_;
    std::unique_ptr<ThreadPool> pool_;
    std::unique_ptr<ClothModel> model_;
    Pins scene_pins_;
    std::unique_ptr<ClothSolver> solver_;
    std::unique_ptr<SelfCollision> collision_;
    std::unique_ptr<ContinuousCollision> layers_;  // made where the level needs it
    bool keeps_contacts_ = false;                  // the solver has some
    ClothState state_;                             // on the host; as fresh as the two flags say
    bool positions_fresh_ = false, velocities_fresh_ = false;
    std::vector<glm::vec4> start_positions_;  // of the last pass, where the level sees ahead; none: there was none
    float pass_s_ = 0;                        // how long that was
    CollisionLevel last_level_ = CollisionLevel::none;  // of the last pass; none: there was none since the start
    int chosen_passes_ = 1;                             // for the next frame, where passes are chosen
    std::vector<glm::vec4> pass_positions_;             // at the last pass, for counting what went through since
    StartCheck start_check_;
    RestWatch rest_watch_;
    std::optional<HeldVertex> held_;
    std::vector<glm::dvec3> stiffest_mode_;  // of stability()
    int frame_ = 0;
    double time_s_ = 0;
    double pending_s_ = 0;
};

}  // namespace nuno
