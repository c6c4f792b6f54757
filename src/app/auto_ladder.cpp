// Ladders in the memory of `nuno auto`.
#include "app/auto_ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/auto_memory.h"
#include "core/error.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Of the point that holds a ladder.
std::string ladder_id(const AutoGoal& goal)
{
    return goal.error_share ? fmt::format("ladder/error={}", *goal.error_share)
                            : fmt::format("ladder/budget={}", *goal.budget_ms);
}

Json ladder_json(const MeasuredLadder& ladder)
{
    Json rungs = Json::array();
    for (const Rung& rung : ladder.rungs)
        rungs.push_back({{"set", setting_json(rung.set)},
                         {"substeps", rung.substeps},
                         {"error_share", rung.error_share},
                         {"ms_per_frame", rung.ms_per_frame},
                         {"largest_strain", rung.largest_strain},
                         {"doubling_m", rung.doubling_m}});
    return {{"rungs", rungs},
            {"chosen", ladder.chosen},
            {"kept", ladder.is_kept},
            {"foretold_frames", ladder.foretold_frames},
            {"given_up", ladder.given_up}};
}

MeasuredLadder ladder_from(const Json& json, const SimParams& base, const AutoGoal& goal)
{
    MeasuredLadder ladder{goal, base, {}, json.at("chosen"), json.at("kept"), json.at("foretold_frames"), {}};
    ladder.given_up = json.at("given_up").get<std::vector<std::string>>();
    for (const Json& stored : json.at("rungs")) {
        Setting set;
        for (const auto& [name, value] : stored.at("set").items()) set.emplace_back(name, value.get<std::string>());
        ladder.rungs.push_back({std::move(set), stored.at("substeps"), stored.at("error_share"),
                                stored.at("ms_per_frame"), stored.at("largest_strain"), stored.at("doubling_m")});
    }
    return ladder;
}

}  // namespace

MeasuredLadder measure_ladder(SceneStudy& study, const SimParams& base, const AutoGoal& goal, const AutoChoice& choice,
                              PointStore& store, const SweepProgress& progress)
{
    MeasuredLadder ladder{goal, base, ladder_around(study, goal, choice, store, progress), 0, choice.is_kept, 0, {}};
    study.ask_watch();
    const auto own = std::find_if(ladder.rungs.begin(), ladder.rungs.end(),
                                  [&](const Rung& rung) { return rung.set == choice.rung; });
    if (own != ladder.rungs.end()) ladder.chosen = static_cast<std::size_t>(own - ladder.rungs.begin());
    const SceneClass& horizon = choice.horizon;
    if (horizon.is_chaotic || horizon.first_contact > 0) ladder.foretold_frames = horizon.frames;
    ladder.given_up = choice.given_up;
    store.add(ladder_id(goal), ladder_json(ladder));
    return ladder;
}

std::optional<MeasuredLadder> remembered_ladder(const Scene& scene, const SimParams& base, const AutoGoal& goal)
{
    try {
        const SceneStudy study(scene, base);
        const std::filesystem::path directory = memory_directory(study);
        // The header takes a look at the whole program and all meshes.
        if (!std::filesystem::exists(directory)) return std::nullopt;
        const StoredPoints stored = read_points(directory);
        const auto found = stored.results.find(ladder_id(goal));
        if (found == stored.results.end() || stored.header != memory_header(study)) return std::nullopt;
        return ladder_from(found->second, base, goal);
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

}  // namespace nuno
