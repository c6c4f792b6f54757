// Time, changes and saving in the window, by keys and mouse.
#include <cmath>

#include "app/viewer_driver.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

TEST_F(ViewerTest, keys_go_back_slow_down_and_take_back)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.key("n n n");
    viewer.program().wait_for("frame 3: stepped");
    viewer.key("Left");
    EXPECT_EQ(viewer.wait_for("shown").frame, 2);
    viewer.key("comma");
    viewer.wait_for("speed 1/2");
    viewer.key("period");
    viewer.wait_for("speed 1/1");
    const ControlPlace slider = viewer.control("wind_strength");
    viewer.click(slider.x(0.8), slider.y());
    const std::string value = viewer.wait_for("wind_strength = (.*)").groups[1];
    EXPECT_NE(value, "2");
    viewer.key("ctrl+z");
    viewer.wait_for("undone wind_strength");
    viewer.key("ctrl+shift+z");
    viewer.wait_for("redone wind_strength");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, the_bar_shows_an_earlier_frame)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.key("n n n n n n");
    viewer.program().wait_for("frame 6: stepped");
    const ControlPlace bar = viewer.control("frame");
    viewer.click(bar.x(0.05), bar.y());
    EXPECT_EQ(viewer.wait_for("shown").frame, 0);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_preset_is_one_click)
{
    ViewerDriver viewer({"seed", "--paused", "--size", "1280x1000"});
    const ControlPlace group = viewer.control("group presets");
    viewer.click(group.x(), group.y());
    const ControlPlace gale = viewer.control("button gale");
    viewer.click(gale.x(), gale.y());
    viewer.wait_for("preset gale");
    viewer.key("ctrl+z");
    viewer.wait_for("undone gale");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_saved_scene_goes_on_with_the_same_bits)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.key("n n n n n");
    viewer.program().wait_for("frame 5: stepped");
    viewer.key("ctrl+s");
    const std::string name = viewer.wait_for("wrote (\\S+)").groups[1];
    EXPECT_EQ(name, "seed_0001.toml");
    viewer.key("n");
    viewer.program().wait_for("frame 6: stepped");
    EXPECT_EQ(viewer.quit(), 0);
    const ProgramResult whole = run_program({"render", "seed", "--frames", "7", "--no-images", "--hash"}, {});
    const ProgramResult went_on =
        run_program({"render", (viewer.directory() / name).string(), "--frames", "2", "--no-images", "--hash"}, {});
    EXPECT_EQ(went_on.exit_code, 0);
    ASSERT_NE(whole.out.find("state-hash "), std::string::npos);
    EXPECT_EQ(went_on.out.substr(went_on.out.find("state-hash ")), whole.out.substr(whole.out.find("state-hash ")));
}

TEST_F(ViewerTest, a_saved_scene_comes_back_with_its_camera_and_overlays)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.drag(1200, 680, 1100, 640);
    const std::string camera = viewer.wait_for("camera (azimuth .*)").groups[1];
    viewer.key("1");
    viewer.wait_for("show_wireframe = true");
    viewer.key("ctrl+s");
    const std::string path = viewer.directory() / viewer.wait_for("wrote (\\S+)").groups[1];
    EXPECT_EQ(viewer.quit(), 0);
    ViewerDriver again({path, "--paused"});
    again.click(1200, 680);
    EXPECT_EQ(again.wait_for("camera (azimuth .*)").groups[1], camera);
    again.key("1");
    again.wait_for("show_wireframe = false");
    EXPECT_EQ(again.quit(), 0);
}

TEST_F(ViewerTest, the_box_beside_the_bar_ends_keeping_frames)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.key("n n n");
    viewer.program().wait_for("frame 3: stepped");
    viewer.click_control("keep_frames");
    viewer.key("n");
    viewer.program().wait_for("frame 4: stepped");
    viewer.key("Left");  // nothing is kept to go back to
    viewer.key("n");
    viewer.program().wait_for("frame 5: stepped");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, plots_open_and_show_the_last_seconds)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.click_control("plots");
    const ControlPlace plot = viewer.control("plot energies");
    viewer.control("plot strain");
    viewer.control("plot counts");
    std::string steps;
    for (int i = 0; i < 30; ++i) steps += "n ";
    viewer.key(steps);
    viewer.program().wait_for("frame 30: stepped");
    viewer.key("s");
    const Picture photo = load_picture(viewer.directory() / viewer.wait_for("wrote (\\S+)").groups[1], 4096);
    // The line of the kinetic energy is blue.
    int blue = 0;
    for (int y = plot.top; y < plot.top + plot.height; ++y)
        for (int x = plot.left; x < plot.left + plot.width; ++x) {
            const std::uint8_t* pixel = &photo.rgba[4 * static_cast<std::size_t>(y * photo.width + x)];
            blue += pixel[2] > 150 && pixel[2] > 2 * pixel[0];
        }
    EXPECT_GT(blue, 5);
    EXPECT_LT(blue, plot.width * plot.height / 4);
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_body_is_dragged_with_the_cloth_on_it_saved_and_put_back)
{
    ViewerDriver viewer({"drape", "--set", "backend=cpu", "--paused"});
    // The ball is seen under the sheet, which is still in the air.
    viewer.press(800, 340);
    const std::vector<std::string> start = viewer.wait_for("holding body 1 at ([-0-9.]+) ([-0-9.]+) ([-0-9.]+)").groups;
    for (int step = 1; step <= 12; ++step) viewer.move(800 + 10 * step, 340);
    viewer.key("n n n n n n n n n n n n n n n");
    viewer.program().wait_for("frame 15: stepped");
    viewer.release();
    const std::vector<std::string> end = viewer.wait_for("released body 1 at ([-0-9.]+) ([-0-9.]+) ([-0-9.]+)").groups;
    const double way = std::hypot(std::stod(end[1]) - std::stod(start[1]), std::stod(end[3]) - std::stod(start[3]));
    EXPECT_GT(way, 0.1);
    EXPECT_NEAR(std::stod(end[2]), std::stod(start[2]), 0.02) << "level, as the camera is";
    viewer.key("ctrl+s");
    viewer.wait_for("wrote drape_0001.toml");
    viewer.key("r");
    viewer.wait_for("restarted");
    viewer.press(800, 340);
    const std::vector<std::string> again = viewer.wait_for("holding body 1 at ([-0-9.]+) ([-0-9.]+) ([-0-9.]+)").groups;
    EXPECT_EQ(again, start) << "it is back where the scene has it";
    viewer.release();
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_click_with_shift_and_a_key_pin_a_vertex_and_let_it_go)
{
    ViewerDriver viewer({"seed", "--paused"});
    viewer.key_down("shift");
    viewer.click(800, 300);
    const std::string vertex = viewer.wait_for("pinned vertex ([0-9]+)").groups[1];
    viewer.key_up("shift");
    viewer.key("p");
    EXPECT_EQ(viewer.wait_for("let go of vertex ([0-9]+)").groups[1], vertex);
    viewer.key("p");
    viewer.wait_for("pinned vertex " + vertex);
    // It stays where it is while the cloth around it falls: it is taken at the place where it was pinned.
    viewer.key("n n n n n n n n n n");
    viewer.program().wait_for("frame 10: stepped");
    viewer.press(800, 300);
    EXPECT_EQ(viewer.wait_for("holding vertex ([0-9]+)").groups[1], vertex);
    viewer.release();
    viewer.key("r");
    viewer.wait_for("restarted");
    viewer.key("p");
    viewer.wait_for("pinned vertex " + vertex);
    EXPECT_EQ(viewer.quit(), 0);
}

}  // namespace
}  // namespace nuno
