// State first, scene last, so that a scene that is there has its state.
#include "sim/saved_scene.h"

#include "core/error.h"
#include "core/files.h"
#include "scene/scene_writer.h"

namespace nuno {
namespace {

std::filesystem::path state_path(std::filesystem::path path) { return path.replace_extension(".state"); }

}  // namespace

void save_scene(const std::filesystem::path& path, Simulation& simulation, std::span<const ViewSetting> view)
{
    check_can_save_scene(path);
    const std::filesystem::path state = state_path(path);
    const std::string text =
        saved_scene_text(simulation.scene(), {simulation.asked_params(), view, state.filename().string()}, path);
    write_state(state, simulation.save());
    write_whole(path, text);
}

void check_can_save_scene(const std::filesystem::path& path)
{
    if (path.extension() != ".toml")
        throw Error(path.string() + ": is no name of a scene; give one that ends in .toml");
    check_can_write(path);
    check_can_write(state_path(path));
}

}  // namespace nuno
