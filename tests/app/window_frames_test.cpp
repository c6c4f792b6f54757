// The tally of the frames of the window.
#include "app/window_frames.h"

#include <gtest/gtest.h>

namespace nuno {
namespace {

TEST(WindowFrames, of_several_simulated_frames_in_one_picture_all_but_the_last_were_skipped)
{
    WindowFrames frames;
    for (const int simulated : {1, 3, 0, 2}) frames.add(simulated, {});
    EXPECT_EQ(frames.shown(), 4);
    EXPECT_EQ(frames.simulated(), 6);
    EXPECT_EQ(frames.skipped(), 3);
}

TEST(WindowFrames, times_are_those_of_the_last_frames_however_many_there_were)
{
    WindowFrames frames;
    EXPECT_TRUE(frames.json()["frame_ms"].is_null()) << "nothing was shown";
    for (std::size_t i = 0; i < 3 * WindowFrames::kTimed; ++i) frames.add(1, {9, 8, 7});
    for (std::size_t i = 0; i < WindowFrames::kTimed; ++i) frames.add(1, {double(i % 100), 2, 3});
    const auto json = frames.json();
    EXPECT_EQ(json["shown"], 4 * WindowFrames::kTimed);
    EXPECT_NEAR(json["frame_ms"]["median"], 50, 1);
    EXPECT_NEAR(json["frame_ms"]["p95"], 95, 1);
    EXPECT_EQ(json["render_ms"]["p95"], 2);
    EXPECT_EQ(json["panel_ms"]["median"], 3);
}

}  // namespace
}  // namespace nuno
