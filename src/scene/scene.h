// A scene: sheets, bodies, parameters, and the check that it must pass at its end. Read from a .toml file
// (docs/scenes.md).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "model/body.h"
#include "model/cloth_model.h"
#include "model/sim_params.h"
#include "scene/end_check.h"

namespace nuno {

// Pinned vertices of a sheet, as the file names them.
struct PinSpec
{
    std::string where;                // file and line
    std::string handle;               // that carries them; empty: they do not move
    std::vector<std::string> places;  // top_left, top, left, top@0.25, ... of a grid; groups of a mesh file
    std::vector<std::uint32_t> vertices;
    std::filesystem::path file = {};  // with numbers of more vertices; empty: none
};

// A sheet as the file declares it: a grid, or a mesh file.
struct SheetSpec
{
    std::string name, where;                               // where: file and line, for messages
    int columns = 0, rows = 0;                             // vertices of a grid
    glm::vec3 origin{0}, across{1, 0, 0}, down{0, -1, 0};  // corner and sides of a grid [m]
    int pleats = 0;              // strips that the start is folded into, accordion-wise; 0: it starts flat
    float pleat_angle = 60;      // tilt of a strip [degrees]
    std::filesystem::path mesh;  // an OBJ file, where it is no grid
    std::vector<PinSpec> pins;
    std::filesystem::path texture;  // empty: none
};

// A parameter of the view, kept as text until the renderer's table reads it.
struct ViewSetting
{
    std::string name, text, where;
    bool quoted;  // a text in the file, not a number, true or false
};

struct Scene
{
    std::string name, title;
    std::filesystem::path path;
    std::string text;             // of the file; empty where there is none
    std::filesystem::path state;  // of the start, as sim/saved_state.h writes it; empty: the sheets say it
    SimParams params;
    std::vector<ViewSetting> view;
    std::vector<SheetSpec> sheets;
    Bodies bodies;
    EndCheck check;
};

// `name_or_path`: a name that scene_names lists, or the path of a .toml file. Error with file and line for everything
// that is wrong in it.
Scene load_scene(std::string_view name_or_path);

// Names of the scenes in assets/scenes, sorted.
std::vector<std::string> scene_names();

// The sheets with their meshes read or made, at params.resolution where that is not 0.
std::vector<SheetSource> make_sheets(const Scene& scene, const SimParams& params);

}  // namespace nuno
