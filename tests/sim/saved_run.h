// A small scene with all that moves cloth: wind, a moving body, a handle, two sheets that meet.
#pragma once

#include <filesystem>
#include <string>

#include "core/files.h"
#include "scene/scene.h"
#include "sim/simulation.h"
#include "support/program_run.h"

namespace nuno {

inline constexpr const char* kSavedSceneText = R"(
title = "Two sheets on a ball"
[params]
backend = "cpu"
threads = 2
wind_strength = 1.0
thickness = 0.02
damping = 0.3
tolerance = 0.3
[view]
camera_distance = 2.5
[[sheet]]
name = "upper"
columns = 9
origin = [-0.3, 0.33, -0.3]
across = [0.6, 0.0, 0.0]
down = [0.0, 0.0, 0.6]
handles = [{ name = "bar", pins = ["top_left"] }]
[[sheet]]
name = "lower"
columns = 8
origin = [-0.25, 0.27, -0.25]
across = [0.5, 0.0, 0.0]
down = [0.0, 0.0, 0.5]
pins = ["bottom_right"]
[[sphere]]
radius = 0.2
keyframes = [{ time = 0 }, { time = 1.0, move = [0.1, 0.05, 0.0] }]
[[box]]
centre = [0.0, -0.6, 0.0]
axis = [1.0, 2.0, 0.5]
angle = 33.3
[[handle]]
name = "bar"
keyframes = [{ time = 0 }, { time = 1.0, move = [0.0, 0.1, 0.1], axis = [1, 0, 0], angle = 20.0 }]
[check]
frames = 5
contacts = [1, inf]
)";

// A folder of its own with that scene in it, as start/ball.toml.
class SavedSceneFolder
{
  public:
    SavedSceneFolder()
    {
        std::filesystem::create_directories(path() / "start");
        write_whole(path() / "start/ball.toml", std::string_view(kSavedSceneText));
    }
    std::filesystem::path path() const { return directory_.path(); }
    Scene scene() const { return load_scene((path() / "start/ball.toml").string()); }

  private:
    TemporaryDirectory directory_;
};

inline void advance_frames(Simulation& simulation, int count)
{
    for (int frame = 0; frame < count; ++frame) simulation.advance_frame();
}

}  // namespace nuno
