// Intersections of a start, counted and untangled.
#include "sim/start_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "collision/untangle.h"
#include "model/cloth_state.h"
#include "sim/tangle_text.h"

namespace nuno {
namespace {

constexpr std::size_t kPlacesTold = 4;

std::string counts_text(const TangleCounts& counts)
{
    if (counts.touching == 0) return fmt::format("{} pairs of faces cross", counts.crossing);
    if (counts.crossing == 0) return fmt::format("{} pairs of faces touch", counts.touching);
    return fmt::format("{} pairs of faces cross and {} touch", counts.crossing, counts.touching);
}

// What the level makes of it, and what to do.
std::string advice(const StartCheck& check, const SimParams& params)
{
    const std::string level = param_text(*find_param(sim_param_table(), "collision"), double(params.collision));
    const std::string_view effect = check.tangled.crossing > 0
                                        ? "keeps layers on the side where they are, crossed or not"
                                        : "lets pairs be that touch at the start";
    const std::string_view other = check.tangled.crossing > 0 ? "choose collision none, spheres or discrete"
                                                              : "merge vertices that lie in one place";
    return fmt::format("{} {}: {} or {}", level, effect,
                       params.untangle ? "move them apart in the scene" : "take them apart with --untangle", other);
}

}  // namespace

StartCheck check_start(const ClothModel& model, const SimParams& params, std::vector<glm::vec4>& positions,
                       ThreadPool& pool)
{
    StartCheck check;
    if ((params.collision < CollisionLevel::speculative && !params.untangle) || first_lost(positions)) return check;
    check.looked = true;
    TangleSearch search(model);
    std::vector<Tangle> tangles = search.find(positions, pool);
    if (params.untangle && !tangles.empty()) {
        UntangleResult result = untangle(search, positions, pool);
        check.untangling = {result.before, result.steps, result.largest_move};
        positions = std::move(result.positions);
        tangles = search.find(positions, pool);
    }
    check.tangled = count_of(tangles);
    // Crossings first: they are what matters.
    std::stable_partition(tangles.begin(), tangles.end(),
                          [](const Tangle& tangle) { return tangle.meeting.kind == Meeting::crossing; });
    for (std::size_t i = 0; i < std::min(kPlacesTold, tangles.size()); ++i)
        check.places.push_back(tangle_text(model, tangles[i]));
    return check;
}

std::vector<std::string> start_remarks(const StartCheck& check, const SimParams& params)
{
    std::vector<std::string> lines;
    if (const auto& done = check.untangling)
        lines.push_back(fmt::format("untangled {} of {} pairs of faces in {} steps, largest move {:.3g} m",
                                    done->before.all() - std::min(check.tangled.all(), done->before.all()),
                                    done->before.all(), done->steps, done->largest_move));
    const std::uint64_t all = check.tangled.all();
    if (all == 0 || params.collision < CollisionLevel::speculative) return lines;
    lines.push_back(fmt::format("at the start {}; {}", counts_text(check.tangled), advice(check, params)));
    for (const std::string& place : check.places) lines.push_back("  " + place);
    if (all > check.places.size()) lines.push_back(fmt::format("  and {} more", all - check.places.size()));
    return lines;
}

}  // namespace nuno
