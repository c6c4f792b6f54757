// The search for a setting among all that a scene can take: which are measured, and how far.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/promise_keeper.h"
#include "study/scene_study.h"
#include "study/sweep.h"

namespace nuno {

// The result of a point, measured where the store lacks it.
const nlohmann::ordered_json& stored(PointStore& store, const std::string& id,
                                     const std::function<nlohmann::ordered_json()>& measure);

// What is foretold to cost more than this many times the best is not looked at: forecasts are a little uncertain.
inline constexpr double kForecastTrust = 1.3;
// A rung of a ladder has at most this share of the error of the one before.
inline constexpr double kRungShare = 0.8;

// Errors are measured over the horizon, costs over the whole scene with self-collision of `level`; both are in the store
// and not measured again.
class Search
{
  public:
    Search(SceneStudy& study, PointStore& store, CollisionLevel level, const SweepProgress& progress);

    // The cheapest with an error of at most `most_error`, or the nearest to that.
    std::optional<Rung> cheapest_within(double most_error);
    // The most exact with a cost of at most `most_ms`, or the cheapest.
    std::optional<Rung> most_exact_within(double most_ms);
    // With their whole cost: those that are likely to be both cheaper and more exact than others, of all whose error is
    // known and that may cost up to `most_ms`.
    std::vector<Rung> rungs(double most_ms, const Setting& chosen);

    int tried() const { return int(measured_.size()); }
    int known() const { return int(asked_.size() - measured_.size()); }

  private:
    struct Candidate
    {
        Setting set;
        double probe_ms;  // of a frame at the start, without self-collision
        int passes;       // of self-collision a frame, at most; 0 without
    };
    struct Known
    {
        const Candidate* candidate;
        int substeps;
        double error_share;
    };
    struct Collision
    {
        int passes;
        double ms;
    };

    void find_candidates();
    bool goes_on() { return progress_(asked_.size(), candidates_.size()); }
    std::optional<Known> error_of(const Candidate& candidate);
    std::optional<Rung> cost_of(const Known& known, double limit_ms);
    double foretold_ms(const Candidate& candidate) const;
    const nlohmann::ordered_json& result(const std::string& id, const Candidate& candidate, bool is_known,
                                         const std::function<nlohmann::ordered_json()>& measure);

    SceneStudy& study_;
    PointStore& store_;
    CollisionLevel level_;
    const SweepProgress& progress_;
    std::vector<Candidate> candidates_;       // by rising cost of their probes
    std::vector<Known> known_;                // of which errors were asked for, in that order
    std::vector<Collision> collisions_;       // of those of which costs were asked for
    std::set<std::string> asked_, measured_;  // settings
};

}  // namespace nuno
