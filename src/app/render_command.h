// `nuno render`: frames of a scene without a display, as pictures and mesh files.
#pragma once

#include <CLI/CLI.hpp>

#include "app/auto_command.h"
#include "app/command_line.h"

namespace nuno {

struct RenderFlags
{
    CommonFlags common;
    PromiseFlags promise;
    int frames = 240;
    int every = 1;
    int check = 0;  // looks at the pose of every so many frames; 0: at none
    std::string out;
    std::string mesh = "none";
    std::string pc2, gltf, video, csv, save;
    std::string size;
    bool no_images = false;
};

void add_render_flags(CLI::App& command, RenderFlags& flags);

// Exit code of the command. Frame 0 is the start state, frame k the state after k frames of simulation.
int run_render(const RenderFlags& flags);

}  // namespace nuno
