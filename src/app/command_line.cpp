// The flags that every command with a scene understands.
#include "app/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/text.h"

namespace nuno {
namespace {

// Parameters that change where or how fast a scene runs, but not what comes out.
constexpr std::array<std::string_view, 2> kNeutral{"backend", "threads"};

void apply(SceneRun& run, const std::string& name, const std::string& text, const std::string& where)
{
    if (const ParamInfo* info = find_param(sim_param_table(), name)) {
        const SimParams before = run.params;
        set_param_text(*info, &run.params, text, where);
        const bool changed = param_value(*info, &run.params) != param_value(*info, &before);
        if (changed && std::find(kNeutral.begin(), kNeutral.end(), name) == kNeutral.end()) run.check_applies = false;
        return;
    }
    if (const ParamInfo* info = find_param(view_param_table(), name))
        return set_param_text(*info, &run.view, text, where);
    const ParamTable tables[] = {sim_param_table(), view_param_table()};
    throw_unknown_param(name, tables, where);
}

void apply_set(SceneRun& run, const std::string& set)
{
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos) throw Error(fmt::format("--set {}: has no value; write --set NAME=VALUE", set));
    apply(run, set.substr(0, equals), set.substr(equals + 1), "--set");
}

}  // namespace

void add_common_flags(CLI::App& command, CommonFlags& flags)
{
    command.add_option("--set", flags.sets, "Set a parameter: NAME=VALUE, repeatable (nuno params lists them)")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    command.add_option("--method", flags.method, "Time integration")->take_last();
    command.add_option("--backend", flags.backend, "cpu or gpu")->take_last();
    command.add_option("--collision", flags.collision, "Level of self-collision")->take_last();
    command.add_option("--threads", flags.threads, "CPU threads, 0 for one a core")->take_last();
    command.add_option("--seed", flags.seed, "Random seed of the start; 0 starts exactly as the scene says")
        ->take_last();
    command.add_flag("--untangle", flags.untangle, "Take layers apart that cross at the start; short for --set");
    command.add_option("--json", flags.json, "Write the report to FILE")->take_last();
    command.add_flag("--hash", flags.hash, "Print the hash of the final state as the last line");
    command.add_flag("--quiet", flags.quiet, "No progress and no remarks");
}

SceneRun prepare_run(const CommonFlags& flags, const std::string& scene_name)
{
    SceneRun run{load_scene(scene_name), {}, {}};
    run.params = run.scene.params;
    for (const ViewSetting& setting : run.scene.view) {
        const ParamInfo* info = find_param(view_param_table(), setting.name);
        const ParamTable table = view_param_table();
        if (!info) throw_unknown_param(setting.name, std::span(&table, 1), setting.where);
        if (setting.quoted != (info->type == ParamType::choice))
            throw Error(fmt::format("{}: {} must be {}", setting.where, info->name, param_range_text(*info)));
        set_param_text(*info, &run.view, setting.text, setting.where);
    }
    for (const std::string& set : flags.sets) apply_set(run, set);
    const std::pair<const char*, const std::string&> named[] = {{"method", flags.method},
                                                                {"backend", flags.backend},
                                                                {"collision", flags.collision},
                                                                {"threads", flags.threads},
                                                                {"seed", flags.seed}};
    for (const auto& [name, text] : named)
        if (!text.empty()) apply(run, name, text, std::string("--") + name);
    if (flags.untangle) apply(run, "untangle", "true", "--untangle");
    return run;
}

std::vector<ViewSetting> view_settings(const ViewParams& view)
{
    std::vector<ViewSetting> settings;
    for (const ParamInfo& info : view_param_table())
        settings.push_back({.name = std::string(info.name),
                            .text = param_text(info, param_value(info, &view)),
                            .where = {},
                            .quoted = info.type == ParamType::choice});
    return settings;
}

bool sets(const CommonFlags& flags, std::string_view name)
{
    const std::pair<std::string_view, const std::string*> named[] = {{"method", &flags.method},
                                                                     {"backend", &flags.backend},
                                                                     {"collision", &flags.collision},
                                                                     {"threads", &flags.threads},
                                                                     {"seed", &flags.seed}};
    for (const auto& [flag, value] : named)
        if (flag == name && !value->empty()) return true;
    return std::any_of(flags.sets.begin(), flags.sets.end(),
                       [&](const std::string& set) { return set.substr(0, set.find('=')) == name; });
}

void refuse_set(const CommonFlags& flags, std::initializer_list<std::string_view> names, std::string_view reason)
{
    for (const std::string_view name : names)
        if (sets(flags, name)) throw Error(fmt::format("{} is set, but {}; leave it out", name, reason));
}

void apply_size(const std::string& size, ViewParams& view)
{
    if (size.empty()) return;
    const std::size_t x = size.find('x');
    const auto width = parse_number(std::string_view(size).substr(0, x));
    const auto height = x == size.npos ? std::nullopt : parse_number(std::string_view(size).substr(x + 1));
    if (!width || !height) throw Error(fmt::format("--size {}: write WIDTHxHEIGHT in pixels, such as 1280x720", size));
    set_param(*find_param(view_param_table(), "width"), &view, *width, "--size");
    set_param(*find_param(view_param_table(), "height"), &view, *height, "--size");
}

}  // namespace nuno
