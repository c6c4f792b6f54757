// The view of a simulation: its cloth with the textures that the scene names.
#pragma once

#include "render/scene_view.h"
#include "sim/simulation.h"

namespace nuno {

// An OpenGL context must be current, and stay so. Error where a texture cannot be read.
SceneView make_scene_view(const Simulation& simulation);

}  // namespace nuno
