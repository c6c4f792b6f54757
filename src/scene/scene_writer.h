// Writes a scene anew, for a run that is to go on from a saved state.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/scene.h"

namespace nuno {

// What takes the place of what the scene's file says.
struct SceneChanges
{
    const SimParams& params;            // all of them are written
    std::span<const ViewSetting> view;  // likewise
    std::string state;                  // path of the state's file, relative to the new scene's
};

// The text of a scene at `path` like this one, bodies and sheets as its file has them, without the check. Paths in it
// name the files that they named. Error where the scene came from no file.
std::string saved_scene_text(const Scene& scene, const SceneChanges& changes, const std::filesystem::path& path);

}  // namespace nuno
