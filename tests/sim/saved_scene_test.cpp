// A run written as a scene: what is in it, and that it goes on.
#include "sim/saved_scene.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/run_recorder.h"
#include "sim/saved_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

TEST(SavedScene, goes_on_in_another_folder_with_the_same_bits_and_parameters)
{
    const SavedSceneFolder files;
    const fs::path folder = files.path();
    const Scene scene = files.scene();
    SimParams params = scene.params;
    params.wind_mean = 0.1f;
    params.method = Method::xpbd;
    params.substeps = 7;
    Simulation simulation(scene, params);
    advance_frames(simulation, 20);
    fs::create_directories(folder / "later");
    save_scene(folder / "later/half.toml", simulation, std::vector<ViewSetting>{{"look", "phong", "", true}});
    const Scene half = load_scene((folder / "later/half.toml").string());
    EXPECT_TRUE(same_params(half.params, params));
    EXPECT_EQ(half.title, scene.title);
    EXPECT_EQ(half.check.frames, 0);
    ASSERT_EQ(half.view.size(), 1u);
    EXPECT_EQ(half.view[0].text, "phong");
    EXPECT_EQ(half.state, folder / "later/half.state");
    Simulation resumed(half, half.params);
    EXPECT_EQ(resumed.frame(), 20);
    EXPECT_EQ(hash_text(resumed.state()), hash_text(simulation.state()));
    advance_frames(simulation, 10);
    advance_frames(resumed, 10);
    EXPECT_EQ(hash_text(resumed.state()), hash_text(simulation.state()));
    resumed.restart();
    EXPECT_EQ(resumed.frame(), 20) << "its start is the state that was saved";
}

TEST(SavedScene, a_scene_saved_again_and_from_itself_stays_whole)
{
    const SavedSceneFolder files;
    const fs::path folder = files.path();
    const Scene scene = files.scene();
    Simulation simulation(scene, scene.params);
    advance_frames(simulation, 5);
    const fs::path file = folder / "half.toml";
    save_scene(file, simulation, {});
    const Scene half = load_scene(file.string());
    Simulation resumed(half, half.params);
    advance_frames(resumed, 5);
    save_scene(file, resumed, {});
    const Scene later = load_scene(file.string());
    Simulation last(later, later.params);
    EXPECT_EQ(last.frame(), 10);
    EXPECT_EQ(hash_text(last.state()), hash_text(resumed.state()));
}

TEST(SavedScene, paths_of_meshes_and_textures_name_the_same_files_from_its_folder)
{
    const SavedSceneFolder files;
    const fs::path folder = files.path();
    write_whole(folder / "start/cloth.obj", std::string_view("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\n"));
    write_whole(folder / "pins.txt", std::string_view("0 1\n"));
    write_whole(folder / "start/cloth.toml",
                std::string_view("[[sheet]]\nmesh = \"cloth.obj\"\npin_file = \"../pins.txt\"\n"
                                 "texture = \"no such.png\"\n"));
    const Scene scene = load_scene((folder / "start/cloth.toml").string());
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    Simulation simulation(scene, params);
    advance_frames(simulation, 2);
    fs::create_directories(folder / "a/b");
    save_scene(folder / "a/b/c.toml", simulation, {});
    const Scene saved = load_scene((folder / "a/b/c.toml").string());
    EXPECT_EQ(fs::weakly_canonical(saved.sheets[0].mesh), fs::weakly_canonical(folder / "start/cloth.obj"));
    EXPECT_EQ(fs::weakly_canonical(saved.sheets[0].texture), fs::weakly_canonical(folder / "start/no such.png"));
    EXPECT_EQ(fs::weakly_canonical(saved.sheets[0].pins[0].file), fs::weakly_canonical(folder / "pins.txt"));
    EXPECT_NO_THROW(Simulation(saved, saved.params));
}

TEST(SavedScene, what_cannot_be_saved_or_gone_on_from_is_one_clear_message)
{
    const SavedSceneFolder files;
    const fs::path folder = files.path();
    const Scene scene = files.scene();
    Simulation simulation(scene, scene.params);
    EXPECT_THROW(save_scene(folder / "half.txt", simulation, {}), Error);
    EXPECT_THROW(save_scene(folder / "none/half.toml", simulation, {}), Error);
    save_scene(folder / "half.toml", simulation, {});
    const Scene half = load_scene((folder / "half.toml").string());
    SimParams finer = half.params;
    finer.resolution = 20;
    const auto message = [&](const SimParams& params) -> std::string {
        try {
            const Simulation resumed(half, params);
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_NE(message(finer).find("half.state: holds a cloth of 145 vertices"), std::string::npos) << message(finer);
    fs::remove(folder / "half.state");
    EXPECT_NE(message(half.params).find("half.state: cannot be read"), std::string::npos);
    Scene made = scene;
    made.text.clear();
    Simulation of_no_file(made, made.params);
    EXPECT_THROW(save_scene(folder / "made.toml", of_no_file, {}), Error);
    EXPECT_FALSE(fs::exists(folder / "made.toml"));
    EXPECT_FALSE(fs::exists(folder / "made.state"));
}

}  // namespace
}  // namespace nuno
