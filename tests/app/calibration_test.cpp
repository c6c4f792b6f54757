// Ladders that are measured on a thread of their own, and what is remembered of them.
#include "app/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "app/auto_memory.h"
#include "app/trade_slider.h"
#include "core/error.h"
#include "study/trajectory.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using namespace std::chrono_literals;

// With a memory of its own.
class CalibrationTest : public testing::Test
{
  protected:
    CalibrationTest()
    {
        setenv("XDG_CACHE_HOME", memory_.path().c_str(), 1);
        params_.threads = 1;
        params_.backend = Backend::cpu;
        scene_.check.frames = 20;
    }

    Calibration::Result result_of(Calibration& calibration)
    {
        for (;;) {
            if (auto result = calibration.take()) return *std::move(result);
            std::this_thread::sleep_for(1ms);
        }
    }
    // Starts what tries many settings, and waits until it does.
    void start_long(Calibration& calibration)
    {
        calibration.start(scene_, params_, exact_);
        while (calibration.progress().tried < 1) {
            ASSERT_FALSE(calibration.take()) << "ended before it was begun";
            std::this_thread::sleep_for(1ms);
        }
    }
    std::size_t remembered_points()
    {
        const SceneStudy study(scene_, params_);
        const auto directory = memory_directory(study);
        return std::filesystem::exists(directory) ? read_points(directory).results.size() : 0;
    }

    TemporaryDirectory memory_;
    Scene scene_ = load_scene("seed");
    SimParams params_ = scene_.params;
    AutoGoal goal_ = auto_goal(3, {}), exact_ = auto_goal(0.01, {});
};

TEST_F(CalibrationTest, a_ladder_rises_in_cost_and_is_remembered_as_it_was_measured)
{
    Calibration calibration;
    calibration.start(scene_, params_, exact_);
    EXPECT_TRUE(calibration.is_running());
    const Calibration::Result result = result_of(calibration);
    EXPECT_FALSE(calibration.is_running());
    ASSERT_TRUE(result.ladder) << result.error;
    const std::vector<Rung>& rungs = result.ladder->rungs;
    ASSERT_GT(rungs.size(), 1u);
    for (std::size_t i = 1; i < rungs.size(); ++i) {
        EXPECT_GE(rungs[i].ms_per_frame, rungs[i - 1].ms_per_frame);
        EXPECT_LE(rungs[i].error_share, rungs[i - 1].error_share);
    }
    EXPECT_TRUE(result.ladder->is_kept);
    EXPECT_LE(rungs[result.ladder->chosen].error_share, 1e-4);

    const auto remembered = remembered_ladder(scene_, params_, exact_);
    ASSERT_TRUE(remembered);
    EXPECT_EQ(remembered->chosen, result.ladder->chosen);
    ASSERT_EQ(remembered->rungs.size(), rungs.size());
    for (std::size_t i = 0; i < rungs.size(); ++i) {
        EXPECT_EQ(remembered->rungs[i].set, rungs[i].set);
        EXPECT_EQ(remembered->rungs[i].error_share, rungs[i].error_share);
    }
}

TEST_F(CalibrationTest, what_is_remembered_is_of_this_cloth_and_this_goal_alone)
{
    params_.resolution = 9;
    Calibration calibration;
    calibration.start(scene_, params_, goal_);
    ASSERT_TRUE(result_of(calibration).ladder);
    SimParams others = params_;
    others.wind_strength += 1;
    EXPECT_TRUE(remembered_ladder(scene_, params_, goal_));
    EXPECT_FALSE(remembered_ladder(scene_, others, goal_));
    EXPECT_FALSE(remembered_ladder(scene_, params_, auto_goal(1, {})));
}

TEST_F(CalibrationTest, what_is_given_up_ends_within_a_frame_and_goes_on_from_there)
{
    Calibration calibration;
    start_long(calibration);
    calibration.give_up();
    EXPECT_FALSE(calibration.is_running());
    EXPECT_FALSE(calibration.take());
    EXPECT_EQ(calibration.progress(), Calibration::Progress{});
    EXPECT_FALSE(remembered_ladder(scene_, params_, exact_)) << "half a ladder";

    calibration.start(scene_, params_, exact_);  // waits for the thread before
    const Calibration::Result result = result_of(calibration);
    ASSERT_TRUE(result.ladder) << result.error;
    EXPECT_TRUE(remembered_ladder(scene_, params_, exact_));
}

TEST_F(CalibrationTest, times_of_frames_end_with_the_frame_in_which_they_are_given_up)
{
    params_.resolution = 9;
    int frames = 0;
    const auto watch = [&] {
        if (++frames == 5) throw std::runtime_error("given up");
    };
    EXPECT_THROW(least_frames_ms(scene_, params_, 2, 1000, 1e9, watch), std::runtime_error);
    EXPECT_EQ(frames, 5);
}

TEST_F(CalibrationTest, an_object_that_goes_takes_its_thread_with_it)
{
    {
        Calibration calibration;
        start_long(calibration);
    }
    const std::size_t points = remembered_points();
    EXPECT_GE(points, 2u) << "what was measured whole";
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(remembered_points(), points);
}

TEST_F(CalibrationTest, the_slider_knows_its_rungs_and_what_was_changed_since)
{
    params_.resolution = 9;
    TradeSlider slider(goal_);
    slider.start(scene_, params_);
    EXPECT_FALSE(slider.ladder());
    slider.measure(scene_, params_);
    while (slider.follow() != TradeSlider::News::done) std::this_thread::sleep_for(1ms);
    ASSERT_TRUE(slider.ladder()) << slider.error();
    SimParams asked = on_rung(params_, slider.ladder()->base, slider.ladder()->rungs[0].set);
    EXPECT_EQ(slider.rung_of(asked), 0u);
    EXPECT_EQ(slider.changed_param(asked), "");
    asked.wind_strength += 1;
    EXPECT_EQ(slider.rung_of(asked), 0u) << "whose error is now another: changed_param() says so";
    EXPECT_EQ(slider.changed_param(asked), "wind_strength");
    asked.substeps += 1;
    EXPECT_EQ(slider.rung_of(asked), std::nullopt);
}

}  // namespace
}  // namespace nuno
