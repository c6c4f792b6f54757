// `nuno view`: the window in which a scene moves and its parameters change while it does.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/sim_params.h"
#include "render/view_params.h"
#include "scene/scene.h"
#include "study/promise_keeper.h"

namespace nuno {

// A scene ready to be shown: what its file says, and the parameters to start with (the file's, then the command
// line's).
struct ViewerScene
{
    Scene scene;
    SimParams params;
    ViewParams view;
};

// Reads a scene by name or path, as the command line would. Error where it cannot be read.
using SceneLoader = std::function<ViewerScene(const std::string& name_or_path)>;

struct ViewerOptions
{
    ViewerScene start;
    SceneLoader load;                 // for the list of scenes and for files dropped on the window
    std::optional<AutoGoal> promise;  // to be kept by what is shown, as soon as a setting for it is known
    int width = 1280, height = 720;   // of the window, on a screen of content scale 1
    bool vsync = true;
    bool paused = false;         // starts at rest
    bool debug_context = false;  // asks the driver for its own checks
    bool quiet = false;          // no remarks on stderr
    bool hash = false;           // prints the hash of the state at the end
    bool log_actions = false;    // a line on stderr for each action and for the place of each control
    std::filesystem::path json;  // where the report of the session goes at its end; empty: none
};

// Shows the window until it is closed. The exit code of the program: 0, or 130 where Ctrl-C ended it.
// Error where there is no display or no OpenGL 4.3, or the scene does not work.
int run_viewer(const ViewerOptions& options);

}  // namespace nuno
