// nuno auto: the choice is the cheapest that keeps the promise, as a full sweep finds it; what is remembered is not
// measured again.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "study/auto_choice.h"
#include "study/auto_cost.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

SceneStudy small_study(const char* name, int frames)
{
    Scene scene = load_scene(name);
    SimParams params = scene.params;
    params.resolution = 9;
    params.threads = 1;
    scene.check.frames = frames;
    return SceneStudy(std::move(scene), params);
}

bool go_on(std::size_t, std::size_t) { return true; }

TEST(Auto, a_goal_is_one_number_that_can_be_kept)
{
    EXPECT_DOUBLE_EQ(*auto_goal(3.0, {}).error_share, 0.03);
    EXPECT_DOUBLE_EQ(*auto_goal({}, 4.0).budget_ms, 4);
    EXPECT_THAT([] { auto_goal({}, {}); }, ThrowsMessage<Error>(HasSubstr("--budget-ms")));
    EXPECT_THAT([] { auto_goal(1.0, 1.0); }, ThrowsMessage<Error>(HasSubstr("one of")));
    for (const double wrong : {0.0, -1.0, 101.0, std::nan("")}) {
        EXPECT_THAT([&] { auto_goal(wrong, {}); }, ThrowsMessage<Error>(HasSubstr("--error"))) << wrong;
        if (wrong != 101.0) {
            EXPECT_THAT([&] { auto_goal({}, wrong); }, ThrowsMessage<Error>(HasSubstr("--budget-ms"))) << wrong;
        }
    }
}

// The error of the choice, measured anew and apart from the search.
TEST(Auto, keeps_the_error_that_is_asked_for)
{
    const TemporaryDirectory directory;
    for (const double percent : {10.0, 1.0, 0.3}) {
        SceneStudy study = small_study("seed", 20);
        PointStore store(directory.path(), {{"study", "auto"}});
        const AutoChoice choice = choose_setting(study, auto_goal(percent, {}), store, go_on);
        EXPECT_TRUE(choice.is_kept);
        const Trajectory run =
            run_trajectory(study.scene(), with_setting(study.params(), choice.set), study.scene_class().frames);
        const double error = error_against(run, study.reference(), study.scene_class().frames).rms_m;
        EXPECT_LE(error / study.scene_class().size_m, percent / 100);
        EXPECT_NEAR(error / study.scene_class().size_m, choice.error_share, 1e-9);
    }
}

TEST(Auto, measures_nothing_twice)
{
    const TemporaryDirectory directory;
    SceneStudy study = small_study("seed", 20);
    PointStore store(directory.path(), {{"study", "auto"}});
    const AutoChoice first = choose_setting(study, auto_goal(1.0, {}), store, go_on);
    EXPECT_GT(first.tried, 0);
    SceneStudy again = small_study("seed", 20);
    const AutoChoice second = choose_setting(again, auto_goal(1.0, {}), store, go_on);
    EXPECT_EQ(second.tried, 0);
    EXPECT_EQ(second.known, first.tried);
    EXPECT_EQ(second.set, first.set);
    EXPECT_EQ(second.error_share, first.error_share);
}

TEST(Auto, says_where_a_promise_cannot_be_kept_and_what_comes_nearest)
{
    const TemporaryDirectory directory;
    SceneStudy study = small_study("seed", 20);
    PointStore store(directory.path(), {{"study", "auto"}});
    const AutoChoice choice = choose_setting(study, auto_goal({}, 1e-6), store, go_on);
    EXPECT_FALSE(choice.is_kept);
    EXPECT_FALSE(choice.set.empty());
    EXPECT_GT(choice.ms_per_frame, 1e-6);
}

// Nothing touches in so few frames, so that self-collision is left out, and said to be.
TEST(Auto, leaves_out_self_collision_where_layers_do_not_meet)
{
    const TemporaryDirectory directory;
    SceneStudy study = small_study("seed", 20);
    ASSERT_NE(study.asked_params().collision, CollisionLevel::none);
    PointStore store(directory.path(), {{"study", "auto"}});
    const AutoChoice choice = choose_setting(study, auto_goal(10.0, {}), store, go_on);
    EXPECT_THAT(choice.set, testing::Contains(std::pair<std::string, std::string>("collision", "none")));
    EXPECT_THAT(choice.given_up, testing::Contains(HasSubstr("self-collision, discrete")));
}

// No frame takes no time, and none an hour; so half of the frames say that it is dearer.
TEST(SceneCost, is_of_all_frames_unless_half_of_them_are_dearer)
{
    Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.resolution = 9;
    params.threads = 1;
    params.backend = Backend::cpu;
    const SceneCost whole = scene_cost(scene, params, 21);
    EXPECT_FALSE(whole.is_dearer);
    EXPECT_GT(whole.ms_per_frame, 0);
    const SceneCost within = scene_cost(scene, params, 21, 3.6e6);
    EXPECT_FALSE(within.is_dearer);
    EXPECT_EQ(within.largest_strain, whole.largest_strain) << "over the same frames";
    const SceneCost over = scene_cost(scene, params, 21, 0);
    EXPECT_TRUE(over.is_dearer);
    EXPECT_GT(over.ms_per_frame, 0);
    EXPECT_EQ(over.largest_strain, scene_cost(scene, params, 11).largest_strain) << "it ends with the eleventh";
    EXPECT_LT(over.largest_strain, whole.largest_strain);
}

// Layers of the seed's cloth meet long after its horizon.
TEST(Auto, costs_are_of_the_whole_scene_with_the_frames_in_which_layers_meet)
{
    const TemporaryDirectory directory;
    SceneStudy study = small_study("fold", 90);
    PointStore store(directory.path(), {{"study", "auto"}});
    const AutoChoice choice = choose_setting(study, auto_goal(10.0, {}), store, go_on);
    EXPECT_TRUE(choice.is_kept);
    ASSERT_GT(layers_meet(study.scene(), study.asked_params(), 90), choice.horizon.frames);
    for (const auto& [name, value] : choice.set) EXPECT_NE(name, "collision");
    SimParams params = with_setting(study.asked_params(), choice.rung);
    EXPECT_EQ(store.results().at("cost/" + setting_text(choice.rung)).at("largest_strain").get<double>(),
              scene_cost(study.scene(), params, 90).largest_strain);
}

// What a scene asks for may not hold; what is chosen does.
TEST(Auto, looks_at_a_scene_that_goes_bad_with_its_own_setting)
{
    const TemporaryDirectory directory;
    Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.resolution = 9;
    params.threads = 1;
    params.method = Method::symplectic_euler;
    params.substeps = 1;
    scene.check.frames = 60;
    SceneStudy study(scene, params);
    ASSERT_NE(scene_cost(scene, study.asked_params(), 60).failure, "");
    PointStore store(directory.path(), {{"study", "auto"}});
    const AutoChoice choice = choose_setting(study, auto_goal(10.0, {}), store, go_on);
    EXPECT_TRUE(choice.is_kept);
    EXPECT_EQ(scene_cost(scene, with_setting(study.asked_params(), choice.rung), 60).failure, "");
}

TEST(Auto, says_what_to_change_where_no_converged_run_is_finite)
{
    const TemporaryDirectory directory;
    const auto scene = directory.write("lost.toml",
                                       "[params]\ncollision = \"none\"\n[[handle]]\nname = \"away\"\n"
                                       "keyframes = [{ time = 0.1 }, { time = 0.2, move = [1e6, 1.0, 0.0] }]\n"
                                       "[[sheet]]\ncolumns = 5\nhandles = [{ name = \"away\", pins = [\"top\"] }]\n");
    const ProgramResult lost = run_program({"auto", scene.string(), "--error", "3", "--quiet"},
                                           {"XDG_CACHE_HOME=" + directory.path().string()});
    EXPECT_EQ(lost.exit_code, 3) << lost.err;
    EXPECT_THAT(lost.err, HasSubstr("frame "));
    EXPECT_THAT(lost.err, HasSubstr("without it no error can be told; softer springs, less load"));
}

// A scene that jitters its start by half a millimetre is held against that start shifted by a millionth of a metre.
TEST(SceneStudy, jitter_of_the_scene_is_no_doubt_in_its_errors)
{
    const auto class_of = [](int seed, float jitter) {
        SceneStudy study = small_study("seed", 20);
        SimParams params = study.asked_params();
        params.seed = seed;
        params.jitter = jitter;
        return SceneStudy(study.scene(), params).scene_class();
    };
    const SceneClass plain = class_of(0, 0), jittered = class_of(std::numeric_limits<std::int32_t>::max(), 5e-4f);
    EXPECT_GT(plain.doubt_share, 0);
    EXPECT_LT(jittered.doubt_share, 2 * plain.doubt_share);
    EXPECT_GE(jittered.frames, plain.frames / 2);
}

TEST(Auto, the_command_prints_words_that_render_takes)
{
    const TemporaryDirectory directory;
    const std::string cache = "XDG_CACHE_HOME=" + directory.path().string();
    const std::vector<std::string> words{"auto", "seed", "--set", "resolution=9", "--error", "3", "--quiet"};
    const ProgramResult found = run_program(words, {cache});
    ASSERT_EQ(found.exit_code, 0) << found.err;
    EXPECT_THAT(found.out, HasSubstr("--set method="));
    const ProgramResult again = run_program(words, {cache});
    EXPECT_THAT(again.out, HasSubstr(" 0 settings measured"));
    const ProgramResult run = run_program({"render", "seed", "--set", "resolution=9", "--error", "3", "--frames", "5",
                                           "--no-images", "--json", (directory.path() / "r.json").string()},
                                          {cache});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr(found.out.substr(0, found.out.find('\n'))));
    const ProgramResult refused =
        run_program({"render", "seed", "--error", "3", "--method", "vbd", "--no-images"}, {cache});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("method is set"));
    EXPECT_EQ(run_program({"auto", "seed", "--error", "0"}).exit_code, 2);
    EXPECT_EQ(run_program({"auto", "seed"}).exit_code, 2);
}

// A scene names its mesh; what was measured with another one says nothing.
TEST(Auto, measures_anew_where_a_mesh_file_has_changed)
{
    const TemporaryDirectory directory;
    const auto write_mesh = [&](const char* height) {
        directory.write("m.obj", fmt::format("v 0 0 0\nv 1 0 0\nv 1 {0} 0\nv 0 {0} 0\nf 1 2 3\nf 1 3 4\n", height));
    };
    write_mesh("1");
    const auto scene = directory.write("mesh.toml", "[[sheet]]\nmesh = \"m.obj\"\npins = [2, 3]\n").string();
    const std::vector<std::string> words{"auto", scene, "--error", "10"};
    const std::string cache = "XDG_CACHE_HOME=" + (directory.path() / "cache").string();
    const ProgramResult first = run_program(words, {cache});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_THAT(run_program(words, {cache}).out, HasSubstr(" 0 settings measured"));
    write_mesh("0.8");
    const ProgramResult anew = run_program(words, {cache});
    EXPECT_THAT(anew.err, HasSubstr("measured anew"));
    EXPECT_THAT(anew.out, testing::Not(HasSubstr(" 0 settings measured")));
}

}  // namespace
}  // namespace nuno
