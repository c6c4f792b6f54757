// A run written as a scene that goes on from there.
#pragma once

#include <filesystem>
#include <span>

#include "scene/scene.h"
#include "sim/simulation.h"

namespace nuno {

// Writes NAME.state beside `path`, which is NAME.toml, and then the scene itself: that of the run with its present
// parameters, with `view` for its picture and without its check. Nothing of the run changes. Error naming the path
// where either cannot be written, and where the scene came from no file.
void save_scene(const std::filesystem::path& path, Simulation& simulation, std::span<const ViewSetting> view);

// Error where save_scene certainly could not: for saying so before long work.
void check_can_save_scene(const std::filesystem::path& path);

}  // namespace nuno
