// The command line (docs/cli.md): what every command that takes a scene understands.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "model/sim_params.h"
#include "render/view_params.h"
#include "scene/scene.h"

namespace nuno {

// The words as given.
struct CommonFlags
{
    std::string scene = "seed";
    std::vector<std::string> sets;                          // NAME=VALUE
    std::string method, backend, collision, threads, seed;  // empty: not given
    std::string json;
    bool hash = false, quiet = false, untangle = false;
};

void add_common_flags(CLI::App& command, CommonFlags& flags);

// A scene ready to run: defaults, then what the scene sets, then the flags.
struct SceneRun
{
    Scene scene;
    SimParams params;
    ViewParams view;
    // False where a flag changed what the scene's end check was written for; then it is not applied.
    bool check_applies = true;
};

// Error naming the flag, or file and line, where a name or a value is wrong.
SceneRun prepare_run(const CommonFlags& flags, const std::string& scene_name);

// The parameters of a picture as a scene file has them.
std::vector<ViewSetting> view_settings(const ViewParams& view);

// Whether a parameter is set on the command line, by its flag or by --set.
bool sets(const CommonFlags& flags, std::string_view name);

// Error where one of these parameters is; `reason` says what takes its place.
void refuse_set(const CommonFlags& flags, std::initializer_list<std::string_view> names, std::string_view reason);

// Stores a size given as WIDTHxHEIGHT pixels; an empty text changes nothing. Error where it is none.
void apply_size(const std::string& size, ViewParams& view);

}  // namespace nuno
