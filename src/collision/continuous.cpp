// A pass of the continuous levels.
#include "collision/continuous.h"

#include <algorithm>

#include "collision/rollback.h"
#include "collision/task_loop.h"

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

std::vector<std::uint32_t> sheet_numbers(const ClothModel& model)
{
    std::vector<std::uint32_t> numbers(model.vertex_count());
    for (std::uint32_t sheet = 0; sheet < model.sheets.size(); ++sheet)
        std::fill_n(numbers.begin() + model.sheets[sheet].first_vertex, model.sheets[sheet].vertex_count, sheet);
    return numbers;
}

glm::vec4 with_w(const glm::dvec3& position, float w) { return glm::vec4(glm::vec3(position), w); }

}  // namespace

ContinuousCollision::ContinuousCollision(const ClothModel& model, ThreadPool& pool)
    : model_(model),
      pool_(pool),
      query_(model.rest_positions, model.faces),
      sheet_numbers_(sheet_numbers(model)),
      dirty_(model.vertex_count())
{
}

std::span<const LayerContact> ContinuousCollision::foresee(std::span<const glm::vec4> positions,
                                                           std::span<const glm::vec4> velocities, float duration,
                                                           const LayerSettings& settings)
{
    const std::vector<glm::vec4> foreseen = nuno::foresee(positions, velocities, duration);
    const LayerRest rest{model_.rest_positions, sheet_numbers_, settings.thickness};
    const int tasks = query_.begin(positions, foreseen, speculative_margin(settings.thickness), pool_);
    contacts_of_task_.resize(std::max(contacts_of_task_.size(), std::size_t(tasks)));
    run_tasks(pool_, tasks, [&](int task) {
        std::vector<LayerContact>& contacts = contacts_of_task_[std::size_t(task)];
        contacts.clear();
        query_.run(task, [&](const ElementPair& pair) {
            append_speculative(pair, {positions, foreseen}, rest, contacts);
        });
    });
    contacts_.clear();
    for (int task = 0; task < tasks; ++task) {
        const std::vector<LayerContact>& more = contacts_of_task_[std::size_t(task)];
        contacts_.insert(contacts_.end(), more.begin(), more.end());
    }
    return contacts_;
}

std::vector<Impact> ContinuousCollision::find_impacts(const LayerPass& pass, LayerCounts& counts)
{
    const int tasks = query_.begin(pass.start, pass.end, static_cast<float>(kLeastGap), pool_);
    impacts_of_task_.resize(std::max(impacts_of_task_.size(), std::size_t(tasks)));
    pairs_of_task_.assign(std::size_t(tasks), 0);
    run_tasks(pool_, tasks, [&](int task) {
        std::vector<Impact>& found = impacts_of_task_[std::size_t(task)];
        std::uint64_t pairs = 0;
        found.clear();
        query_.run(task, [&](const ElementPair& pair) {
            const glm::uvec4& v = pair.vertices;
            if (!(dirty_[v.x] | dirty_[v.y] | dirty_[v.z] | dirty_[v.w])) return;
            ++pairs;
            if (const std::optional<Impact> impact = find_impact(pair, {pass.start, pass.end}))
                found.push_back(*impact);
        });
        pairs_of_task_[std::size_t(task)] = pairs;
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

bool ContinuousCollision::push_apart(const LayerPass& pass, const LayerSettings& settings, LayerCounts& counts)
{
    const LayerRest rest{model_.rest_positions, sheet_numbers_, settings.thickness};
    std::vector<Impact> all;
    std::vector<glm::dvec3> start, positions;
    std::vector<double> inverse_masses;
    std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{1});
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Impact> impacts = find_impacts(pass, counts);
        if (round == 0) counts.impacts = static_cast<std::uint32_t>(impacts.size());
        if (impacts.empty()) return true;
        if (start.empty())
            for (std::size_t v = 0; v < pass.start.size(); ++v) {
                start.emplace_back(pass.start[v]);
                inverse_masses.push_back(double(pass.end[v].w));
            }
        positions.assign(pass.end.begin(), pass.end.end());
        for (Impact& impact : impacts)
            impact.target = std::min(kImpactGap * double(settings.thickness), double(kept_distance(impact.pair, rest)));
        all.insert(all.end(), impacts.begin(), impacts.end());
        answer_impacts(all, start, {double(settings.friction), inverse_masses}, positions);

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

void ContinuousCollision::roll_back_until_clean(const LayerPass& pass, LayerCounts& counts)
{
    for (int round = 0;; ++round) {
        const std::vector<Impact> impacts = find_impacts(pass, counts);
        if (impacts.empty()) return;
        ++counts.rollbacks;
        if (round == kMostRounds) {
            std::copy(pass.start.begin(), pass.start.end(), pass.end.begin());
            counts.standstill = true;
            return;
        }
        std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
        const std::uint32_t clusters =
            roll_back(impacts, round < kPatientRounds ? kKeptWay : 0.0, pass.start, pass.end, dirty_);
        counts.zones = std::max(counts.zones, clusters);
    }
}

LayerCounts ContinuousCollision::respond(const LayerPass& pass, const LayerSettings& settings)
{
    LayerCounts counts;
    const std::vector<glm::vec4> asked(pass.end.begin(), pass.end.end());
    if (!push_apart(pass, settings, counts)) {
        if (settings.guaranteed)
            roll_back_until_clean(pass, counts);
        else
            counts.unresolved = static_cast<std::uint32_t>(find_impacts(pass, counts).size());
    }
    if (counts.impacts == 0) return counts;
    counts.changed = true;
    for (std::size_t v = 0; v < asked.size(); ++v) {
        if (asked[v] == pass.end[v]) continue;
        const glm::vec3 change = glm::vec3(pass.end[v]) - glm::vec3(asked[v]);
        pass.velocities[v] += glm::vec4(change / pass.duration, 0);
    }
    return counts;
}

}  // namespace nuno
