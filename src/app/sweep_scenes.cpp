// Scenes of a sweep, to JSON and back.
#include "app/sweep_scenes.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "sim/run_recorder.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

Json scene_json(const SweepScene& s)
{
    return {
        {"source", s.source}, {"text", read_text(s.scene.path)}, {"params", params_json(sim_param_table(), &s.params)}};
}

// Presets come first, as they set others.
SimParams params_of(const Json& values)
{
    SimParams params;
    for (const bool presets : {true, false})
        for (const ParamInfo& info : sim_param_table()) {
            if ((info.on_set != nullptr) != presets || !values.contains(info.name)) continue;
            const Json& value = values[info.name];
            const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
            set_param_text(info, &params, text, "points.jsonl");
        }
    return params;
}

}  // namespace

void require_distinct(const std::vector<SweepScene>& scenes)
{
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (scenes[k].scene.name == scenes[i].scene.name)
                throw Error(fmt::format("{}: two scenes of that name; give each once", scenes[i].scene.name));
}

Json scenes_json(const std::vector<SweepScene>& scenes)
{
    Json json = Json::object();
    for (const SweepScene& scene : scenes) json[scene.scene.name] = scene_json(scene);
    return json;
}

std::vector<SweepScene> scenes_of(const Json& header)
{
    std::vector<SweepScene> scenes;
    const Json all = header.value("scenes", Json::object());
    for (const auto& [name, kept] : all.items()) {
        const std::string source = kept.value("source", "");
        SweepScene scene{source, load_scene(source), params_of(kept.value("params", Json::object()))};
        if (scene_json(scene) != kept)
            throw Error(
                fmt::format("{}: is another scene here than the one that was measured; bring its file back", source));
        scenes.push_back(std::move(scene));
    }
    if (scenes.empty()) throw Error("points.jsonl: names no scene; run the sweep anew");
    return scenes;
}

std::string sweep_version() { return fmt::format("{} ({})", kVersion, kCommit); }

void require_this_version(const Json& header)
{
    const std::string theirs = header.value("version", "unknown");
    if (theirs != sweep_version())
        throw Error(fmt::format("the points are of nuno {}, and this is {}; join them with the nuno that measured them",
                                theirs, sweep_version()));
}

}  // namespace nuno
