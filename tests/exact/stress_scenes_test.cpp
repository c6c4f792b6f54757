// Every stress scene, small and from a jittered start: at `guaranteed` no frame intersects itself (the exact checker).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/program_run.h"

namespace nuno {
namespace {

struct Stress
{
    std::string name, scene;
    int frames;
    std::vector<std::string> settings;
};

std::ostream& operator<<(std::ostream& out, const Stress& stress) { return out << stress.name; }

std::vector<std::string> frames_of(const Stress& stress, const std::string& level, const std::filesystem::path& folder)
{
    std::vector<std::string> words{"render",  stress.scene,    "--frames", std::to_string(stress.frames),
                                   "--quiet", "--backend",     "cpu",      "--collision",
                                   level,     "--seed",        "1",        "--no-images",
                                   "--mesh",  "ply",           "--out",    folder.string(),
                                   "--set",   "jitter=0.0005", "--set",    "count_pass_through=true"};
    for (const std::string& setting : stress.settings) words.insert(words.end(), {"--set", setting});
    const ProgramResult run = run_program(words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    std::vector<std::string> meshes;
    for (const auto& file : std::filesystem::directory_iterator(folder)) meshes.push_back(file.path().string());
    std::sort(meshes.begin(), meshes.end());
    EXPECT_EQ(meshes.size(), std::size_t(stress.frames));
    return meshes;
}

ProgramResult intersections(std::vector<std::string> meshes)
{
    meshes.insert(meshes.begin(), NUNO_MESH_INTERSECTIONS);
    return run_words(meshes);
}

class StressScene : public testing::TestWithParam<Stress>
{};

TEST_P(StressScene, has_no_frame_that_intersects_itself)
{
    const TemporaryDirectory folder;
    const ProgramResult checked = intersections(frames_of(GetParam(), "guaranteed", folder.path()));
    EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

INSTANTIATE_TEST_SUITE_P(
    Guaranteed, StressScene,
    testing::Values(Stress{"gale_at_20", "gale", 90, {"wind_strength=20", "collision_passes=0", "culling=sound"}},
                    Stress{"gale_at_40_fine",
                           "gale",
                           60,
                           {"resolution=33", "wind_strength=40", "collision_passes=0", "culling=sound"}},
                    Stress{"gale_at_60", "gale", 90, {"wind_strength=60", "collision_passes=0", "culling=sound"}},
                    Stress{"twist", "twist", 170, {"resolution=33"}}, Stress{"fold", "fold", 216, {"resolution=21"}},
                    Stress{"stack", "stack", 70, {"resolution=9"}}, Stress{"roll", "roll", 150, {"resolution=31"}},
                    Stress{"squeeze", "squeeze", 120, {"resolution=25"}}, Stress{"bag", "bag", 150, {"resolution=25"}},
                    Stress{"fast_collider", "fast_collider", 60, {"resolution=21"}}),
    [](const auto& test) { return test.param.name; });

// The same run without contact intersects itself: the checker would have seen it.
TEST(StressScene, intersects_itself_where_layers_pass_through)
{
    const TemporaryDirectory folder;
    const Stress fold{"fold", "fold", 90, {"resolution=21"}};
    const ProgramResult checked = intersections(frames_of(fold, "none", folder.path()));
    EXPECT_EQ(checked.exit_code, 1) << checked.err;
}

}  // namespace
}  // namespace nuno
