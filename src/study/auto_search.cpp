// Which settings are measured, and how far.
#include "study/auto_search.h"

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "study/auto_cost.h"
#include "study/trade_settings.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Frames that tell what a setting costs at the start, and runs of them.
constexpr int kProbeFrames = 3, kProbeRuns = 3;
constexpr double kProbeMs = 200;
// A setting slower than this a simulated second is given up.
constexpr double kMostMs = 20000;

// Over the horizon, as share of the size of the cloth; a failure where the run did not get to its end.
Json measure_error(SceneStudy& study, const Setting& setting)
{
    const int frames = study.scene_class().frames;
    const Trajectory run = run_trajectory(study.scene(), with_setting(study.params(), setting), frames,
                                          {.most_ms = kMostMs, .watch = study.watch()});
    if (run.frames() < frames) return {{"failure", run.too_slow ? "too slow" : run.failure}};
    return {{"substeps", run.substeps},
            {"error_share", error_against(run, study.reference(), frames).rms_m / study.scene_class().size_m}};
}

Json measure_cost(const SceneStudy& study, const Setting& setting, CollisionLevel level, double limit_ms)
{
    SimParams params = with_setting(study.asked_params(), setting);
    params.collision = level;
    const SceneCost cost = scene_cost(study.scene(), params, long_frames(study), limit_ms, study.watch());
    if (!cost.failure.empty()) return {{"failure", cost.failure}};
    if (cost.is_dearer) return {{"over_ms", limit_ms}, {"about_ms", cost.ms_per_frame}};
    return {{"ms_per_frame", cost.ms_per_frame}, {"largest_strain", cost.largest_strain}};
}

}  // namespace

const Json& stored(PointStore& store, const std::string& id, const std::function<Json()>& measure)
{
    if (!store.holds(id)) store.add(id, measure());
    return store.results().at(id);
}

Search::Search(SceneStudy& study, PointStore& store, CollisionLevel level, const SweepProgress& progress)
    : study_(study), store_(store), level_(level), progress_(progress)
{
    find_candidates();
}

void Search::find_candidates()
{
    const SimParams& asked = study_.asked_params();
    SimParams bare = asked;
    bare.collision = CollisionLevel::none;
    const ClothModel model = build_cloth_model(make_sheets(study_.scene(), asked), asked.mass_lumping);
    for (Setting& setting : settings_in_time(model, study_.scene().bodies, asked)) {
        const Json& probe = stored(store_, "probe/" + setting_text(setting), [&]() -> Json {
            try {
                const SimParams params = with_setting(bare, setting);
                const double ms =
                    least_frames_ms(study_.scene(), params, kProbeFrames, kProbeRuns, kProbeMs, study_.watch());
                return {{"ms", ms / kProbeFrames}};
            } catch (const Error& error) {
                if (error.code() != ExitCode::went_bad) throw;
                return {{"failure", error.what()}};
            }
        });
        if (!probe.contains("ms")) continue;
        const int substeps = with_setting(bare, setting).substeps;
        const int passes = level_ == CollisionLevel::none ? 0 : std::min(substeps, most_passes(asked));
        candidates_.push_back({std::move(setting), probe["ms"], passes});
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.probe_ms < b.probe_ms; });
}

const Json& Search::result(const std::string& id, const Candidate& candidate, bool is_known,
                           const std::function<Json()>& measure)
{
    asked_.insert(setting_text(candidate.set));
    if (is_known) return store_.results().at(id);
    measured_.insert(setting_text(candidate.set));
    store_.add(id, measure());
    return store_.results().at(id);
}

std::optional<Search::Known> Search::error_of(const Candidate& candidate)
{
    const auto same = [&](const Known& known) { return known.candidate == &candidate; };
    if (const auto at = std::find_if(known_.begin(), known_.end(), same); at != known_.end()) return *at;
    const std::string id = "error/" + setting_text(candidate.set);
    const Json& found = result(id, candidate, store_.holds(id), [&] { return measure_error(study_, candidate.set); });
    if (!found.contains("error_share")) return std::nullopt;
    return known_.emplace_back(Known{&candidate, found["substeps"], found["error_share"]});
}

// Nothing where it goes bad or costs more than the limit.
std::optional<Rung> Search::cost_of(const Known& known, double limit_ms)
{
    const Candidate& candidate = *known.candidate;
    limit_ms = std::min(limit_ms, kMostMs / study_.asked_params().frame_rate);
    const std::string id = "cost/" + setting_text(candidate.set);
    const bool is_known = store_.holds(id) && store_.results().at(id).value("over_ms", limit_ms) >= limit_ms;
    const Json& found =
        result(id, candidate, is_known, [&] { return measure_cost(study_, candidate.set, level_, limit_ms); });
    if (found.contains("failure")) return std::nullopt;
    const bool is_whole = found.contains("ms_per_frame");
    const double ms = found[is_whole ? "ms_per_frame" : "about_ms"];
    collisions_.push_back({candidate.passes, ms - candidate.probe_ms});
    if (!is_whole || ms >= limit_ms) return std::nullopt;
    return Rung{candidate.set, known.substeps, known.error_share, ms, found["largest_strain"]};
}

// With the self-collision of the cheapest that was measured with about as many passes.
double Search::foretold_ms(const Candidate& candidate) const
{
    const Collision* nearest = nullptr;
    for (const Collision& other : collisions_) {
        if (other.passes > candidate.passes) continue;
        const bool is_nearer = nearest == nullptr || other.passes > nearest->passes ||
                               (other.passes == nearest->passes && other.ms < nearest->ms);
        if (is_nearer) nearest = &other;
    }
    return candidate.probe_ms + (nearest != nullptr && candidate.passes > 0 ? std::max(0.0, nearest->ms) : 0);
}

std::optional<Rung> Search::cheapest_within(double most_error)
{
    std::optional<Rung> best;
    std::vector<Known> others;
    double most_ms = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates_) {
        if (candidate.probe_ms > kForecastTrust * most_ms || !goes_on()) break;
        if (foretold_ms(candidate) > kForecastTrust * most_ms) continue;
        const std::optional<Known> known = error_of(candidate);
        if (!known) continue;
        if (known->error_share > most_error) {
            others.push_back(*known);
        } else if (std::optional<Rung> rung = cost_of(*known, most_ms)) {
            most_ms = rung->ms_per_frame;
            best = std::move(rung);
        }
    }
    std::stable_sort(others.begin(), others.end(),
                     [](const Known& a, const Known& b) { return a.error_share < b.error_share; });
    for (std::size_t i = 0; i < others.size() && !best; ++i) best = cost_of(others[i], most_ms);
    return best;
}

std::optional<Rung> Search::most_exact_within(double most_ms)
{
    std::vector<Known> exact;
    for (const Candidate& candidate : candidates_) {
        if ((!exact.empty() && candidate.probe_ms > kForecastTrust * most_ms) || !goes_on()) break;
        if (const std::optional<Known> known = error_of(candidate)) exact.push_back(*known);
    }
    const std::vector<Known> cheap = exact;
    std::stable_sort(exact.begin(), exact.end(),
                     [](const Known& a, const Known& b) { return a.error_share < b.error_share; });
    for (const Known& known : exact) {
        if (foretold_ms(*known.candidate) > kForecastTrust * most_ms) continue;
        if (std::optional<Rung> rung = cost_of(known, most_ms)) return rung;
    }
    std::optional<Rung> best;
    double limit_ms = std::numeric_limits<double>::infinity();
    for (const Known& known : cheap) {
        if (foretold_ms(*known.candidate) > kForecastTrust * limit_ms) continue;
        if (std::optional<Rung> rung = cost_of(known, limit_ms)) {
            limit_ms = rung->ms_per_frame;
            best = std::move(rung);
        }
    }
    return best;
}

std::vector<Rung> Search::rungs(double most_ms, const Setting& chosen)
{
    for (const Candidate& candidate : candidates_)
        if (candidate.set == chosen) error_of(candidate);
    std::vector<std::pair<double, Known>> by_cost;
    for (const Known& known : known_) by_cost.emplace_back(foretold_ms(*known.candidate), known);
    std::stable_sort(by_cost.begin(), by_cost.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Rung> found;
    double error = std::numeric_limits<double>::infinity();
    for (const auto& [ms, known] : by_cost) {
        const bool is_chosen = known.candidate->set == chosen;
        if (!is_chosen && (ms > most_ms || known.error_share >= kRungShare * error)) continue;
        std::optional<Rung> rung = cost_of(known, std::numeric_limits<double>::infinity());
        if (!rung) continue;
        error = std::min(error, known.error_share);
        found.push_back(std::move(*rung));
    }
    return found;
}

}  // namespace nuno
