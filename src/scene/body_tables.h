// The bodies and handles of a scene file.
#pragma once

#include <filesystem>
#include <string>

#include "model/body.h"
#include "scene/toml_table.h"

namespace nuno {

// Reads [[plane]], [[sphere]], [[capsule]], [[box]], [[body_mesh]] and [[handle]] with their keyframes. Error with file
// and line for everything that is wrong in them.
Bodies read_bodies(TomlTable& file, const std::string& file_name, const std::filesystem::path& scene_path);

}  // namespace nuno
