// A promise that is kept while a scene runs: up the ladder where the estimate breaks it, down where it is far below, and
// plain words where no rung is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "study/auto_choice.h"
#include "study/doubling_error.h"
#include "study/promise_keeper.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kTiny = 1e-12, kHuge = 1e3;  // as what an estimate is held against: far over it, far below

SimParams small(const Scene& scene)
{
    SimParams params = scene.params;
    params.resolution = 9;
    params.threads = 1;
    params.backend = Backend::cpu;
    params.collision = CollisionLevel::none;
    return params;
}

// Two rungs of implicit_euler, one substep and four, and what was estimated of each when they were measured.
std::vector<Rung> two_rungs(double doubling_m, double finer_doubling_m)
{
    return {{{{"method", "implicit_euler"}, {"substeps", "1"}}, 1, 0.008, 1.0, 1.0, doubling_m},
            {{{"method", "implicit_euler"}, {"substeps", "4"}}, 4, 0.002, 2.0, 1.0, finer_doubling_m}};
}

struct WatchedRun
{
    explicit WatchedRun(PromiseKeeper promise_keeper) : keeper(std::move(promise_keeper))
    {
        simulation.set_params(on_rung(base, base, keeper.ladder()[keeper.rung()].set));
    }

    void frames(int count)
    {
        for (int i = 0; i < count; ++i)
            for (const std::string& line : keeper.look(simulation, simulation.advance_frame())) lines.push_back(line);
    }

    // Frames that are said to have taken so long.
    void frames_of(double ms, int count)
    {
        for (int i = 0; i < count; ++i) {
            FrameStats stats = simulation.advance_frame();
            stats.stage_ms = {};
            stats.stage_ms.solve = ms;
            for (const std::string& line : keeper.look(simulation, stats)) lines.push_back(line);
        }
    }

    Scene scene = load_scene("seed");
    SimParams base = small(scene);
    Simulation simulation{scene, base};
    PromiseKeeper keeper;
    std::vector<std::string> lines;
};

PromiseKeeper error_keeper(std::vector<Rung> ladder, std::size_t rung = 0)
{
    return {auto_goal(1.0, {}), std::move(ladder), rung, small(load_scene("seed")), 0};
}

PromiseKeeper budget_keeper(std::size_t rung)
{
    return {auto_goal({}, 4.0), two_rungs(0, 0), rung, small(load_scene("seed")), 0};
}

TEST(DoublingError, halves_with_the_substep_of_a_method_of_first_order)
{
    const Scene scene = load_scene("seed");
    SimParams params = small(scene);
    params.method = Method::symplectic_euler;
    params.substeps = 40;
    const auto estimate = [&](int substeps) {
        Simulation simulation(scene, params);
        for (int frame = 0; frame < 20; ++frame) simulation.advance_frame();
        SimParams other = params;
        other.substeps = substeps;
        simulation.set_params(other);
        ThreadPool pool(1);
        return doubling_error_m(simulation, pool);
    };
    const double coarse = estimate(40), fine = estimate(80);
    EXPECT_GT(fine, 0);
    EXPECT_NEAR(coarse / fine, 2, 0.3);
}

TEST(DoublingError, leaves_the_run_alone)
{
    const Scene scene = load_scene("seed");
    Simulation alone(scene, small(scene)), watched(scene, small(scene));
    ThreadPool pool(1);
    for (int frame = 0; frame < 12; ++frame) {
        alone.advance_frame();
        watched.advance_frame();
        doubling_error_m(watched, pool);
    }
    EXPECT_EQ(state_hash(alone.state()), state_hash(watched.state()));
}

TEST(PromiseKeeper, goes_up_where_the_estimate_breaks_the_promise_and_says_so)
{
    WatchedRun run(error_keeper(two_rungs(kTiny, kHuge)));
    run.frames(40);
    ASSERT_EQ(run.keeper.changes().size(), 1u);
    EXPECT_EQ(run.keeper.rung(), 1u);
    EXPECT_EQ(run.simulation.params().substeps, 4);
    EXPECT_TRUE(run.keeper.is_kept());
    ASSERT_EQ(run.lines.size(), 1u);
    EXPECT_THAT(run.lines[0], HasSubstr("over 1 %: goes on with method=implicit_euler substeps=4"));
}

TEST(PromiseKeeper, goes_down_where_it_is_far_below_for_long)
{
    WatchedRun run(error_keeper(two_rungs(kHuge, kHuge), 1));
    run.frames(60);
    EXPECT_EQ(run.keeper.rung(), 1u);  // not at once
    run.frames(60);
    EXPECT_EQ(run.keeper.rung(), 0u);
    EXPECT_EQ(run.simulation.params().substeps, 1);
    EXPECT_THAT(run.lines.at(0), HasSubstr("far below 1 %"));
}

TEST(PromiseKeeper, waits_longer_each_time_it_had_to_come_back)
{
    WatchedRun run(error_keeper(two_rungs(kTiny, kHuge), 1));
    run.frames(2000);
    EXPECT_GE(run.keeper.changes().size(), 4u);
    EXPECT_LE(run.keeper.changes().size(), 14u);  // 4, 8, 16, 32 looks of 20 frames; without waiting, over 30
}

TEST(PromiseKeeper, says_once_that_no_rung_is_left)
{
    std::vector<Rung> ladder = two_rungs(kTiny, kTiny);
    ladder.pop_back();
    WatchedRun run(error_keeper(ladder));
    run.frames(120);
    EXPECT_FALSE(run.keeper.is_kept());
    ASSERT_EQ(run.lines.size(), 1u);
    EXPECT_THAT(run.lines[0], HasSubstr("the promise cannot be kept"));
    EXPECT_GT(run.keeper.report()["looks_over"], 3);
}

TEST(PromiseKeeper, decides_the_same_in_every_run)
{
    const auto hash = [] {
        WatchedRun run(error_keeper(two_rungs(kTiny, kHuge), 1));
        run.frames(300);
        EXPECT_GE(run.keeper.changes().size(), 2u);
        return std::pair(state_hash(run.simulation.state()), run.keeper.report().dump());
    };
    EXPECT_EQ(hash(), hash());
}

TEST(PromiseKeeper, keeps_a_budget_by_a_cheaper_rung)
{
    WatchedRun run(budget_keeper(1));
    run.frames_of(5, 15);
    EXPECT_EQ(run.keeper.rung(), 0u);
    EXPECT_EQ(run.simulation.params().substeps, 1);
    EXPECT_THAT(run.lines.at(0), HasSubstr("5 ms a frame, over 4: goes on with"));
    run.frames_of(3, 100);
    EXPECT_EQ(run.keeper.changes().size(), 1u);  // twice 3 ms would not fit
    EXPECT_TRUE(run.keeper.is_kept());
    run.frames_of(1, 200);
    EXPECT_EQ(run.keeper.rung(), 1u);  // twice 1 ms does
    EXPECT_TRUE(run.keeper.is_kept());
}

TEST(PromiseKeeper, waits_longer_where_it_comes_back_over_several_rungs)
{
    std::vector<Rung> ladder = two_rungs(0, 0);
    ladder.push_back(ladder.back());
    ladder.back().ms_per_frame = 2.5;
    const double ms[] = {1, 1, 5};  // the last is dearer than it was measured
    WatchedRun run({auto_goal({}, 4.0), ladder, 2, small(load_scene("seed")), 0});
    for (int frame = 0; frame < 3000; ++frame) run.frames_of(ms[run.keeper.rung()], 1);
    EXPECT_EQ(run.keeper.changes().at(0).to, 0u) << "over both";
    EXPECT_GE(run.keeper.changes().size(), 7u);
    EXPECT_LE(run.keeper.changes().size(), 14u) << "without waiting, over 30";
}

TEST(PromiseKeeper, frames_of_cloth_asleep_say_nothing)
{
    WatchedRun run(budget_keeper(0));
    run.frames_of(3, 20);
    FrameStats asleep;
    for (asleep.frame = 21; asleep.frame < 400; ++asleep.frame)
        EXPECT_THAT(run.keeper.look(run.simulation, asleep), IsEmpty());
    EXPECT_THAT(run.keeper.changes(), IsEmpty()) << "no time is no room";
    EXPECT_EQ(run.keeper.report()["looks"], 20);
}

TEST(PromiseKeeper, layers_that_went_through_take_it_to_where_more_passes_fit)
{
    WatchedRun run(error_keeper(two_rungs(kHuge, kHuge)));
    run.frames(1);
    SimParams params = run.simulation.asked_params();
    params.collision = CollisionLevel::speculative;
    params.collision_passes = 0;
    run.simulation.set_params(params);
    for (int i = 0; i < 20; ++i) {
        FrameStats stats = run.simulation.advance_frame();
        stats.count.unresolved = 1;
        run.keeper.look(run.simulation, stats);
    }
    ASSERT_EQ(run.keeper.changes().size(), 1u);
    EXPECT_EQ(run.keeper.changes()[0].reason, "layers went through one another");
    EXPECT_EQ(run.simulation.params().substeps, 4);
}

TEST(PromiseKeeper, one_slow_frame_breaks_no_budget)
{
    WatchedRun run(budget_keeper(1));
    for (int i = 0; i < 10; ++i) {
        run.frames_of(3, 10);
        run.frames_of(50, 1);
    }
    EXPECT_THAT(run.keeper.changes(), IsEmpty());
    EXPECT_TRUE(run.keeper.is_kept());
}

TEST(PromiseKeeper, says_that_a_budget_cannot_be_kept)
{
    WatchedRun run(budget_keeper(0));
    run.frames_of(9, 60);
    EXPECT_FALSE(run.keeper.is_kept());
    ASSERT_EQ(run.lines.size(), 1u);
    EXPECT_THAT(run.lines[0], HasSubstr("9 ms a frame, over 4: the promise cannot be kept"));
}

TEST(Ladder, rises_in_cost_and_falls_in_error_around_the_choice)
{
    const TemporaryDirectory directory;
    Scene scene = load_scene("seed");
    SimParams params = small(scene);
    scene.check.frames = 20;
    SceneStudy study(std::move(scene), params);
    PointStore store(directory.path(), {{"study", "auto"}});
    const auto go_on = [](std::size_t, std::size_t) { return true; };
    const AutoGoal goal = auto_goal(3.0, {});
    const AutoChoice choice = choose_setting(study, goal, store, go_on);
    const std::vector<Rung> ladder = ladder_around(study, goal, choice, store, go_on);
    ASSERT_GE(ladder.size(), 2u);
    int chosen = 0;
    for (std::size_t i = 0; i < ladder.size(); ++i) {
        chosen += ladder[i].set == choice.rung;
        EXPECT_GT(ladder[i].doubling_m, 0);
        if (i == 0) continue;
        EXPECT_GE(ladder[i].ms_per_frame, ladder[i - 1].ms_per_frame);
        EXPECT_LT(ladder[i].error_share, ladder[i - 1].error_share);
    }
    EXPECT_EQ(chosen, 1);
    EXPECT_LE(ladder.back().error_share, 0.2 * 0.03);
}

nlohmann::json rendered(const TemporaryDirectory& directory, const std::vector<std::string>& goal, int exit_code)
{
    const std::string report = (directory.path() / "r.json").string();
    std::vector<std::string> words{"render", "seed",    "--set",       "resolution=9", "--frames",
                                   "60",     "--quiet", "--no-images", "--json",       report};
    words.insert(words.end(), goal.begin(), goal.end());
    const ProgramResult run = run_program(words, {"XDG_CACHE_HOME=" + directory.path().string()});
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(run.err.find("the promise is not kept") != run.err.npos, exit_code == 1) << run.err;
    return nlohmann::json::parse(read_text(report)).at("promise");
}

TEST(Promise, render_tells_in_its_report_how_it_was_kept)
{
    const TemporaryDirectory directory;
    const nlohmann::json kept = rendered(directory, {"--budget-ms", "1000"}, 0);
    EXPECT_EQ(kept["kept"], true);
    EXPECT_EQ(kept["looks"], 59);
    EXPECT_EQ(kept["looks_over"], 0);
    const nlohmann::json broken = rendered(directory, {"--budget-ms", "0.00001"}, 1);
    EXPECT_EQ(broken["kept"], false);
    EXPECT_EQ(broken["looks_over"], 59);
    const nlohmann::json error = rendered(directory, {"--error", "3"}, 0);
    EXPECT_EQ(error["of"], "error_share");
    EXPECT_GE(error["looks"], 1);
}

}  // namespace
}  // namespace nuno
