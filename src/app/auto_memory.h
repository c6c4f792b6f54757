// What `nuno auto` remembers of a scene on this machine: where that is, and all that it depends on.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "study/scene_study.h"

namespace nuno {

// Program, machine, threads, scene with the meshes that it names, and parameters.
nlohmann::ordered_json memory_header(const SceneStudy& study);

// Of the points of this scene and these parameters, of any program and machine: below $XDG_CACHE_HOME, or ~/.cache.
std::filesystem::path memory_directory(const SceneStudy& study);

}  // namespace nuno
