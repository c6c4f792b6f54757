// The viewer as its user meets it: a real window, a real mouse, a real keyboard.
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "app/viewer_driver.h"
#include "core/files.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

// A place of the default window (1280 x 720) where the start of the scene `seed` has cloth, and one where there is only
// floor.
constexpr int kClothX = 800, kClothY = 300, kFloorX = 1150, kFloorY = 660;

std::string steps(int count)
{
    std::string keys;
    for (int i = 0; i < count; ++i) keys += "n ";
    return keys;
}

glm::dvec3 vector_of(const std::vector<std::string>& groups, std::size_t first)
{
    return {std::stod(groups[first]), std::stod(groups[first + 1]), std::stod(groups[first + 2])};
}

// The number that ImGui's logarithmic slider from 0 to 1000 gives at a share of its width: 0.001 to 1000 along its
// usable part.
double log_slider_value(const ControlPlace& slider, int x)
{
    constexpr double kPadding = 2, kGrab = 11;
    const double usable = slider.width - 2 * kPadding - kGrab;
    return 1e-3 * std::pow(1e6, (x - slider.left - kPadding - kGrab / 2) / usable);
}

std::size_t colour_count(const Picture& picture)
{
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i + 2 < picture.rgba.size(); i += 4)
        colours.insert(picture.rgba[i] | std::uint32_t(picture.rgba[i + 1]) << 8 |
                       std::uint32_t(picture.rgba[i + 2]) << 16);
    return colours.size();
}

bool is_black(const Picture& picture, int x, int y)
{
    const std::uint8_t* pixel = &picture.rgba[4 * static_cast<std::size_t>(y * picture.width + x)];
    return pixel[0] + pixel[1] + pixel[2] == 0;
}

TEST_F(ViewerTest, a_dragged_slider_changes_its_parameter_while_the_cloth_goes_on)
{
    ViewerDriver viewer({"seed"});
    const ControlPlace slider = viewer.control("wind_strength");
    viewer.press(slider.x(0.6), slider.y());
    const auto first = viewer.wait_for("wind_strength = ([0-9.]+)$");
    EXPECT_NEAR(std::stod(first.groups[1]), log_slider_value(slider, slider.x(0.6)), 0.1 * std::stod(first.groups[1]));
    viewer.move(slider.x(0.7), slider.y());
    const auto second = viewer.wait_for("wind_strength = ([0-9.]+)$");
    viewer.release();
    EXPECT_NEAR(std::stod(second.groups[1]), log_slider_value(slider, slider.x(0.7)),
                0.1 * std::stod(second.groups[1]));
    // The keys wait until the slider has let go of them.
    viewer.key("space");
    const int paused_at = viewer.wait_for("paused").frame;
    EXPECT_GT(second.frame, first.frame);
    EXPECT_GT(paused_at, second.frame);
    EXPECT_EQ(viewer.quit(), 0);
    EXPECT_EQ(viewer.program().transcript().find("restarted"), std::string::npos);
}

TEST_F(ViewerTest, a_row_goes_back_to_the_value_of_the_scene)
{
    ViewerDriver viewer({"seed", "--paused", "--set", "wind_strength=7"});
    const ControlPlace reset = viewer.control("reset wind_strength");
    viewer.click(reset.x(), reset.y());
    EXPECT_EQ(viewer.wait_for("wind_strength = (.*)").groups[1], "2");
    viewer.wait_for("control reset wind_strength hidden");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_typed_value_is_kept_within_the_range_and_its_letters_are_no_commands)
{
    ViewerDriver viewer({"seed", "--paused"});
    const ControlPlace slider = viewer.control("wind_strength");
    viewer.key_down("ctrl");
    viewer.click(slider.x(), slider.y());
    viewer.wait_for("keys go to the panel");
    viewer.key_up("ctrl");
    viewer.type("q12345");
    viewer.key("Return");
    EXPECT_EQ(viewer.wait_for("wind_strength = (.*)").groups[1], "1000");
    viewer.wait_for("keys go to the picture");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_dragged_vertex_follows_the_mouse)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.press(kClothX, kClothY);
    const auto held = viewer.wait_for("holding vertex ([0-9]+) at (\\S+) (\\S+) (\\S+)");
    viewer.move(kClothX + 80, kClothY);
    viewer.key(steps(30));
    viewer.program().wait_for("frame 30: stepped");
    viewer.release();
    const auto released = viewer.wait_for("released vertex ([0-9]+) at (\\S+) (\\S+) (\\S+)");
    EXPECT_EQ(released.groups[1], held.groups[1]);
    const glm::dvec3 way = vector_of(released.groups, 2) - vector_of(held.groups, 2);
    // The scene's camera stands at azimuth 30 degrees: to its right is (cos 30, 0, -sin 30). A pixel there is about 2.5
    // mm.
    const double right = glm::dot(way, glm::dvec3(0.8660, 0, -0.5));
    // The cloth holds the vertex back, so it lags; but it comes, and straight.
    EXPECT_GT(right, 0.02);
    EXPECT_LT(right, 80 * 0.0025 * 1.1);
    EXPECT_GT(right, 0.95 * glm::length(way));
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, the_mouse_beside_the_cloth_moves_the_camera)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.drag(kFloorX, kFloorY, kFloorX - 100, kFloorY + 40);
    // Half a turn over the 720 pixels of the height.
    const auto turned =
        viewer.wait_for("camera azimuth (\\S+) elevation (\\S+) distance (\\S+) target (\\S+) (\\S+) (\\S+)");
    EXPECT_NEAR(std::stod(turned.groups[1]), 30 + 25, 0.3);
    EXPECT_NEAR(std::stod(turned.groups[2]), 8 + 10, 0.3);
    viewer.drag(kFloorX, kFloorY, kFloorX, kFloorY - 100, 3);
    const auto moved =
        viewer.wait_for("camera azimuth (\\S+) elevation (\\S+) distance (\\S+) target (\\S+) (\\S+) (\\S+)");
    EXPECT_EQ(moved.groups[1], turned.groups[1]);
    EXPECT_LT(std::stod(moved.groups[5]), std::stod(turned.groups[5]) - 0.1);
    EXPECT_EQ(viewer.quit(), 0);
    EXPECT_EQ(viewer.program().transcript().find("holding"), std::string::npos);
}

TEST_F(ViewerTest, the_wheel_zooms_over_the_picture_and_not_over_the_panel)
{
    ViewerDriver viewer({"seed", "--paused"});
    const ControlPlace group = viewer.control("group start");
    viewer.click(group.x(), group.y(), 5);
    viewer.key("n");
    viewer.wait_for("stepped");
    viewer.click(kFloorX, kFloorY, 4);
    EXPECT_NEAR(std::stod(viewer.wait_for("camera .* distance (\\S+)").groups[1]), 2.6 * 0.9, 0.01);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_resized_window_is_filled)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.resize(900, 640);
    viewer.wait_for("framebuffer 900x640");
    viewer.key("Tab");
    viewer.wait_for("control wind_strength hidden");
    viewer.key("s");
    const std::string name = viewer.wait_for("wrote (\\S+)").groups[1];
    const Picture picture = load_picture(viewer.directory() / name, 4096);
    ASSERT_EQ(picture.width, 900);
    ASSERT_EQ(picture.height, 640);
    for (const int x : {0, 450, 899})
        for (const int y : {0, 320, 639}) EXPECT_FALSE(is_black(picture, x, y)) << x << ", " << y;
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, keys_pause_step_and_restart)
{
    ViewerDriver viewer({"seed"});
    viewer.key("space");
    const int paused = viewer.wait_for("paused").frame;
    viewer.key("n");
    EXPECT_EQ(viewer.wait_for("stepped").frame, paused + 1);
    viewer.key("Right");
    EXPECT_EQ(viewer.wait_for("stepped").frame, paused + 2);
    viewer.key("r");
    viewer.wait_for("restarted");
    viewer.key("n");
    EXPECT_EQ(viewer.wait_for("stepped").frame, 1);
    viewer.key("space");
    viewer.wait_for("playing");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, the_panel_pauses_steps_and_restarts)
{
    ViewerDriver viewer({"seed"});
    const auto press = [&](const char* name) {
        const ControlPlace place = viewer.control(std::string("button ") + name);
        viewer.click(place.x(), place.y());
    };
    press("Pause");
    const int paused = viewer.wait_for("paused").frame;
    press("Step");
    EXPECT_EQ(viewer.wait_for("stepped").frame, paused + 1);
    press("Restart");
    viewer.wait_for("restarted");
    press("Play");
    viewer.wait_for("playing");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, photos_take_free_names_and_show_the_window)
{
    ViewerDriver viewer({"seed", "--paused"});
    std::ofstream(viewer.directory() / "nuno_0001.png") << "mine";
    viewer.key("s");
    EXPECT_EQ(viewer.wait_for("wrote (\\S+)").groups[1], "nuno_0002.png");
    viewer.key("F12");
    EXPECT_EQ(viewer.wait_for("wrote (\\S+)").groups[1], "nuno_0003.png");
    const Picture picture = load_picture(viewer.directory() / "nuno_0002.png", 4096);
    EXPECT_EQ(picture.width, 1280);
    EXPECT_EQ(picture.height, 720);
    EXPECT_GT(colour_count(picture), 500u);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, closing_leaves_nothing_behind)
{
    ViewerDriver viewer({"seed"});
    viewer.key("h");
    viewer.wait_for("help shown");
    viewer.key("Escape");
    viewer.wait_for("help hidden");
    viewer.key("Escape");
    EXPECT_EQ(viewer.program().wait_for_exit(), 0);
    EXPECT_TRUE(std::filesystem::is_empty(viewer.directory()));
}

TEST_F(ViewerTest, ctrl_c_ends_it_with_a_whole_report)
{
    ViewerDriver viewer({"seed", "--paused", "--json", "report.json"});
    viewer.key(steps(3));
    viewer.program().wait_for("frame 3: stepped");
    viewer.program().signal(SIGINT);
    EXPECT_EQ(viewer.program().wait_for_exit(), 130);
    const auto report = nlohmann::json::parse(read_text(viewer.directory() / "report.json"));
    EXPECT_EQ(report["frames"].size(), 3u);
    EXPECT_EQ(report["scene"], "seed");
    EXPECT_EQ(report["window"]["simulated"], 3);
    EXPECT_LE(report["window"]["skipped"], 2) << "of three steps at least the last was shown";
    EXPECT_GE(report["window"]["shown"], 3);
    EXPECT_GT(report["window"]["frame_ms"]["median"], 0);
}

TEST_F(ViewerTest, another_scene_is_chosen_from_the_list)
{
    ViewerDriver viewer({"seed", "--paused"});
    const ControlPlace list = viewer.control("scene");
    viewer.click(list.x(), list.y());
    const ControlPlace choice = viewer.control("scene=hang");
    viewer.click(choice.x(), choice.y());
    viewer.wait_for("scene hang");
    viewer.wait_for("keys go to the picture");
    viewer.key("n");
    EXPECT_EQ(viewer.wait_for("stepped").frame, 1);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_simulation_that_goes_bad_waits_with_advice)
{
    ViewerDriver viewer({"seed", "--method", "symplectic_euler", "--set", "substeps=1", "--paused"});
    viewer.key("space");
    EXPECT_NE(viewer.wait_for("error (.*)").groups[1].find("no longer finite"), std::string::npos);
    const std::string advice = viewer.wait_for("control (message Use [0-9]+ substeps)").groups[1];
    const ControlPlace button = viewer.control(advice);
    viewer.click(button.x(), button.y());
    viewer.wait_for("substeps = [0-9]+");
    viewer.wait_for("restarted");
    viewer.key("space");
    EXPECT_GT(viewer.wait_for("paused").frame, 0);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, twice_the_content_scale_gives_panels_of_twice_the_size)
{
    if (!has_program("xprop")) GTEST_SKIP() << "needs xprop (package x11-utils)";
    ControlPlace small, large;
    {
        ViewerDriver viewer({"seed", "--paused", "--size", "640x400"});
        small = viewer.control("wind_strength");
        EXPECT_EQ(viewer.quit(), 0);
    }
    {
        ViewerDriver viewer({"seed", "--paused", "--size", "640x400"}, 192);
        large = viewer.control("wind_strength");
        EXPECT_FALSE(viewer.program().latest("content scale 2").empty());
        EXPECT_FALSE(viewer.program().latest("framebuffer 1280x800").empty());
        EXPECT_EQ(viewer.quit(), 0);
    }
    EXPECT_NEAR(large.height, 2 * small.height, 2);
    EXPECT_NEAR(large.width, 2 * small.width, 4);
}

TEST(ViewerWithoutDisplay, says_what_to_do_and_exits_2)
{
    const ProgramResult result = run_program({"view", "seed"}, {"DISPLAY=", "WAYLAND_DISPLAY="});
    EXPECT_EQ(result.exit_code, 2);
    for (const char* advice : {"DISPLAY", "xvfb-run", "nuno render"})
        EXPECT_NE(result.err.find(advice), std::string::npos) << result.err;
}

}  // namespace
}  // namespace nuno
