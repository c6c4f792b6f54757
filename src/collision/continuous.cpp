// A pass of the continuous levels.
#include "collision/continuous.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "collision/rollback.h"
#include "collision/sheet_numbers.h"
#include "core/task_share.h"

namespace nuno {
namespace {

constexpr int kRounds = 5;
// The share of the thickness that impacts leave.
constexpr double kImpactGap = 0.5;
// Of the way to an impact that rollback keeps, and the rounds after which it keeps none: then it ends, for the start is
// free.
constexpr double kKeptWay = 0.9;
constexpr int kPatientRounds = 30;
// After so many rounds all of the cloth goes back to where it was.
constexpr int kMostRounds = 60;

bool is_late(const LayerSettings& settings, const Stopwatch& watch)
{
    return settings.budget_ms > 0 && watch.elapsed_ms() > double(settings.budget_ms);
}

glm::vec4 with_w(const glm::dvec3& position, float w) { return glm::vec4(glm::vec3(position), w); }

}  // namespace

ContinuousCollision::ContinuousCollision(const ClothModel& model, ThreadPool& pool)
    : model_(model),
      pool_(pool),
      query_(model.rest_positions, model.faces, model.sheets),
      sheet_numbers_(sheet_numbers(model.sheets, model.vertex_count())),
      dirty_(model.vertex_count())
{
}

const SpeculativeContacts& ContinuousCollision::foresee(std::span<const glm::vec4> positions,
                                                        std::span<const glm::vec4> velocities, float duration,
                                                        const LayerSettings& settings)
{
    std::vector<glm::vec4> ways(positions.size()), ends(positions.size());
    for (std::size_t v = 0; v < ends.size(); ++v) {
        ways[v] = glm::vec4(glm::vec3(velocities[v]) * duration, 0);
        ends[v] = positions[v] + ways[v];
    }
    const LayerRest rest{model_.rest_positions, sheet_numbers_, settings.thickness};
    const int tasks = query_.begin({positions, ends}, speculative_query(settings.thickness, settings.culling), pool_);
    foreseen_of_task_.resize(std::max(foreseen_of_task_.size(), std::size_t(tasks)));
    share_tasks(pool_, tasks, [&](int task, int) {
        SpeculativeContacts& found = foreseen_of_task_[std::size_t(task)];
        found.contacts.clear();
        found.largest_approach = 0;
        PairBatches batches([&](PairKind kind, std::span<const ElementPair> pairs) {
            append_speculative(kind, pairs, {positions, ways}, rest, found);
        });
        query_.run(task, [&](const ElementPair& pair) { batches.add(pair); });
        batches.finish();
    });
    foreseen_.contacts.clear();
    foreseen_.largest_approach = 0;
    for (int task = 0; task < tasks; ++task) {
        const SpeculativeContacts& more = foreseen_of_task_[std::size_t(task)];
        foreseen_.contacts.insert(foreseen_.contacts.end(), more.contacts.begin(), more.contacts.end());
        foreseen_.largest_approach = std::max(foreseen_.largest_approach, more.largest_approach);
    }
    return foreseen_;
}

std::vector<Impact> ContinuousCollision::find_impacts(const LayerPass& pass, Culling culling, CollisionCounts& counts)
{
    const int tasks = query_.begin({pass.start, pass.end}, {static_cast<float>(kLeastGap), culling}, pool_);
    ways_.resize(pass.start.size());
    for (std::size_t v = 0; v < ways_.size() && tasks > 0; ++v) ways_[v] = pass.end[v] - pass.start[v];
    impacts_of_task_.resize(std::max(impacts_of_task_.size(), std::size_t(tasks)));
    pairs_of_task_.assign(std::size_t(tasks), 0);
    share_tasks(pool_, tasks, [&](int task, int) {
        std::vector<Impact>& found = impacts_of_task_[std::size_t(task)];
        found.clear();
        PairBatches batches([&](PairKind kind, std::span<const ElementPair> pairs) {
            pairs_of_task_[std::size_t(task)] += pairs.size();
            append_impacts(kind, pairs, {pass.start, ways_, pass.end}, found);
        });
        query_.run(task, [&](const ElementPair& pair) {
            const glm::uvec4& v = pair.vertices;
            if (dirty_[v.x] | dirty_[v.y] | dirty_[v.z] | dirty_[v.w]) batches.add(pair);
        });
        batches.finish();
    });
    std::vector<Impact> impacts;
    std::uint32_t touching = 0;
    for (int task = 0; task < tasks; ++task) {
        for (const Impact& impact : impacts_of_task_[std::size_t(task)])
            if (impact.time == 0 && touches(impact.pair, pass.start))
                ++touching;
            else
                impacts.push_back(impact);
        counts.pairs_tested += pairs_of_task_[std::size_t(task)];
    }
    counts.touching = std::max(counts.touching, touching);
    return impacts;
}

void ContinuousCollision::mark(const std::vector<Impact>& impacts)
{
    for (const Impact& impact : impacts)
        for (int i = 0; i < 4; ++i) dirty_[impact.pair.vertices[i]] = 1;
}

bool ContinuousCollision::push_apart(const LayerPass& pass, const LayerSettings& settings, const Stopwatch& watch,
                                     CollisionCounts& counts)
{
    const LayerRest rest{model_.rest_positions, sheet_numbers_, settings.thickness};
    std::vector<glm::dvec3> start, positions;
    std::vector<double> inverse_masses;
    impacts_.clear();
    std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{1});
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Impact> impacts = find_impacts(pass, settings.culling, counts);
        if (round == 0) counts.impacts = static_cast<std::uint32_t>(impacts.size());
        if (impacts.empty()) return true;
        if (is_late(settings, watch)) return false;
        if (start.empty())
            for (std::size_t v = 0; v < pass.start.size(); ++v) {
                start.emplace_back(pass.start[v]);
                inverse_masses.push_back(double(pass.end[v].w));
            }
        positions.assign(pass.end.begin(), pass.end.end());
        for (Impact& impact : impacts)
            impact.target = std::min(kImpactGap * double(settings.thickness), double(kept_distance(impact.pair, rest)));
        impacts_.insert(impacts_.end(), impacts.begin(), impacts.end());
        answer_impacts(impacts_, start, {double(settings.friction), double(settings.static_friction), inverse_masses},
                       positions);

        std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
        mark(impacts);
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const glm::vec4 end = with_w(positions[v], pass.end[v].w);
            if (end == pass.end[v]) continue;
            pass.end[v] = end;
            dirty_[v] = 1;
        }
    }
    return false;
}

void ContinuousCollision::roll_back_until_clean(const LayerPass& pass, const LayerSettings& settings,
                                                const Stopwatch& watch, CollisionCounts& counts)
{
    for (int round = 0;; ++round) {
        const std::vector<Impact> impacts = find_impacts(pass, settings.culling, counts);
        if (impacts.empty()) return;
        ++counts.rollbacks;
        if (round == kMostRounds) {
            std::copy(pass.start.begin(), pass.start.end(), pass.end.begin());
            counts.standstills = 1;
            return;
        }
        std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
        const bool patient = round < kPatientRounds && !is_late(settings, watch);
        const Clusters clusters = roll_back(impacts, patient ? kKeptWay : 0.0, pass.start, pass.end, dirty_);
        counts.zones = std::max(counts.zones, clusters.count);
        counts.largest_zone = std::max(counts.largest_zone, clusters.largest);
        counts.held_back = std::max(counts.held_back, clusters.held_back);
    }
}

CollisionCounts ContinuousCollision::respond(const LayerPass& pass, const LayerSettings& settings)
{
    const Stopwatch watch;
    CollisionCounts counts;
    const std::vector<glm::vec4> asked(pass.end.begin(), pass.end.end());
    if (!push_apart(pass, settings, watch, counts)) {
        if (settings.guaranteed)
            roll_back_until_clean(pass, settings, watch, counts);
        else
            counts.unresolved = static_cast<std::uint32_t>(find_impacts(pass, settings.culling, counts).size());
    }
    if (counts.impacts == 0) return counts;
    for (std::size_t v = 0; v < asked.size(); ++v) {
        if (asked[v] == pass.end[v]) continue;
        const glm::vec3 change = glm::vec3(pass.end[v]) - glm::vec3(asked[v]);
        pass.velocities[v] += glm::vec4(change / pass.duration, 0);
        counts.lost_m += double(glm::length(change));
    }
    return counts;
}

}  // namespace nuno
