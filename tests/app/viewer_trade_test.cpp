// The slider from fast to accurate, in the window.
#include <chrono>

#include "app/viewer_driver.h"
#include "core/files.h"

namespace nuno {
namespace {

using std::chrono::steady_clock;

// Its ladder takes seconds to measure.
const std::vector<std::string> kSmall{"seed", "--size", "900x720"};

std::string rung_line(int rung, int count)
{
    return "rung " + std::to_string(rung) + " of " + std::to_string(count) + ": (.*)";
}

// The number of its rungs. Measuring takes seconds, but on a loaded machine a minute.
std::string wait_for_ladder(ViewerDriver& viewer)
{
    return viewer.program().wait_for("ladder of ([0-9]+) rungs measured", 120)[1];
}

// Puts the slider to its end: 0 fast, 1 accurate.
void drag_slider_to(ViewerDriver& viewer, double share)
{
    const ControlPlace slider = viewer.control("rung");
    viewer.press(slider.x(0.5), slider.y());
    viewer.move(slider.x(share), slider.y());
    viewer.release();
}

TEST_F(ViewerTest, a_ladder_is_measured_moved_along_and_remembered)
{
    const TemporaryDirectory memory;
    int rungs = 0;
    {
        ViewerDriver viewer(kSmall, 0, memory.path());
        viewer.click_control("button Measure");
        viewer.wait_for("measuring");
        rungs = std::stoi(wait_for_ladder(viewer));
        ASSERT_GT(rungs, 2);
        drag_slider_to(viewer, 0.99);
        const auto accurate = viewer.wait_for(rung_line(rungs, rungs));
        drag_slider_to(viewer, 0.01);
        const auto fast = viewer.wait_for(rung_line(1, rungs));
        EXPECT_NE(fast.groups[1], accurate.groups[1]);
        EXPECT_GT(fast.frame, accurate.frame) << "the cloth goes on while its setting changes";
        EXPECT_EQ(viewer.quit(), 0);
    }
    ViewerDriver viewer(kSmall, 0, memory.path());
    EXPECT_FALSE(viewer.program().latest("ladder of " + std::to_string(rungs) + " rungs remembered").empty());
    viewer.control("rung");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_measurement_that_is_given_up_lets_the_cloth_go_on)
{
    ViewerDriver viewer({"seed", "--size", "900x720"});
    viewer.click_control("button Measure");
    viewer.wait_for("measuring");
    viewer.key("n");  // does nothing now
    viewer.click_control("button Stop measuring");
    const int rested = viewer.wait_for("measuring given up").frame;
    viewer.key("space");
    EXPECT_GT(viewer.wait_for("paused").frame, rested);
    EXPECT_EQ(viewer.program().transcript().find("stepped"), std::string::npos);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_window_closed_while_measuring_writes_its_report_and_goes)
{
    ViewerDriver viewer({"drape", "--json", "report.json", "--size", "900x720"});
    viewer.click_control("button Measure");
    viewer.wait_for("measuring");
    const auto asked = steady_clock::now();
    EXPECT_EQ(viewer.quit(), 0);
    EXPECT_LT(steady_clock::now() - asked, std::chrono::seconds(20)) << "the whole measurement takes minutes";
    EXPECT_NE(read_text(viewer.directory() / "report.json").find("\"summary\""), std::string::npos);
}

TEST_F(ViewerTest, a_promise_opens_the_window_at_once_and_is_kept_when_a_setting_is_known)
{
    std::vector<std::string> words = kSmall;
    words.insert(words.end(), {"--error", "3"});
    ViewerDriver viewer(words);
    EXPECT_TRUE(viewer.program().latest("ladder of").empty()) << "measured before there was a window";
    wait_for_ladder(viewer);
    const auto kept = viewer.wait_for("rung [0-9]+ of [0-9]+: (.*)");
    EXPECT_EQ(kept.frame, 0) << "the cloth rests until there is a setting";
    EXPECT_NE(kept.groups[1].find("method="), std::string::npos);
    viewer.key("space");
    EXPECT_GT(viewer.wait_for("paused").frame, 0);
    EXPECT_EQ(viewer.quit(), 0);
}

}  // namespace
}  // namespace nuno
