// Keeps a promise while a scene runs: goes up and down a ladder of settings, each dearer and more exact than the one
// before (docs/auto.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/thread_pool.h"
#include "sim/simulation.h"
#include "study/setting.h"

namespace nuno {

// One of the two is asked for.
struct AutoGoal
{
    std::optional<double> error_share;  // at most, of the size of the cloth, as nuno trade measures it
    std::optional<double> budget_ms;    // at most, of a frame

    bool is_kept_by(double error_share_measured, double ms_per_frame) const;
};

// A setting as it was measured.
struct Rung
{
    Setting set;
    int substeps = 0;           // a frame, as used
    double error_share = 0;     // over the horizon of the scene
    double ms_per_frame = 0;    // median, with self-collision
    double largest_strain = 0;  // of a thread
    double doubling_m = 0;      // root mean square of doubling_error_m over the horizon; 0: not measured
};

struct RungChange
{
    int frame;  // after which it was changed
    std::size_t from, to;
    std::string reason;
};

// A promise of an error is judged by simulated quantities alone, so that a run repeats to the bit; one of a budget by
// measured times, so that it need not.
class PromiseKeeper
{
  public:
    // `ladder`: by rising cost and falling error, one rung at least; the run is on rung `chosen`, and `base` are its
    // parameters without a rung's. `horizon_frames`: a promise of an error that is broken after these is not held against
    // the run, as its positions cannot be foretold; 0: at any time it is.
    PromiseKeeper(const AutoGoal& goal, std::vector<Rung> ladder, std::size_t chosen, const SimParams& base,
                  int horizon_frames);

    // After a frame. Moves the run to another rung where the promise asks for it. One line for each thing to tell.
    std::vector<std::string> look(Simulation& simulation, const FrameStats& frame);
    // The run starts again, on the rung that it is on.
    void restart();

    const std::vector<Rung>& ladder() const { return ladder_; }
    std::size_t rung() const { return rung_; }
    // The latest estimate of the error, as a share, or the latest time of a frame [ms]; none before the first.
    std::optional<double> latest() const;
    const std::vector<RungChange>& changes() const { return changes_; }
    bool is_kept() const;
    // One sentence where it is not; else empty.
    std::string verdict() const;
    // The object `promise` of docs/report.md.
    nlohmann::ordered_json report() const;

  private:
    std::vector<std::string> look_at_error(Simulation& simulation, int frame);
    std::vector<std::string> look_at_cost(Simulation& simulation, const FrameStats& frame);
    std::vector<std::string> move(Simulation& simulation, std::size_t to, const std::string& reason, int frame);
    std::vector<std::string> cannot(const std::string& reason, bool counts);
    std::optional<std::size_t> rung_for_layers(const SimParams& params) const;
    double predicted(std::size_t rung) const;
    std::ptrdiff_t looks_over() const;

    AutoGoal goal_;
    std::vector<Rung> ladder_;
    std::size_t rung_;
    SimParams base_;
    int horizon_frames_;
    std::vector<RungChange> changes_;
    std::deque<double> recent_;      // on this rung: estimates [m] or times [ms]
    std::vector<double> estimates_;  // of all rungs: errors as shares, or times [ms]
    std::uint64_t unresolved_ = 0;   // since the last sample
    int calm_ = 0, patience_ = 0;    // looks in a row that would allow the other way, and how many that takes
    bool is_too_hard_ = false;       // from the start
    bool is_broken_ = false, told_ = false, told_of_layers_ = false;
    int next_sample_ = 0;
    std::unique_ptr<ThreadPool> pool_;  // for estimates
};

// Whether a parameter is among those that rungs set.
bool is_chosen_by_auto(std::string_view name);

// Parameters with another rung: what `auto` chooses is as in `base`, but for the words of the rung.
SimParams on_rung(SimParams params, const SimParams& base, const Setting& set);

}  // namespace nuno
