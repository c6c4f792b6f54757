// Overlays as their user meets them: each key in the window, and the parameters without one.
#include <cstdlib>
#include <string>

#include "app/viewer_driver.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

// The part of the pixels of an area, given as parts of the picture, that differ clearly.
double changed_part(const Picture& a, const Picture& b, double x0, double x1)
{
    const int first = static_cast<int>(x0 * a.width), last = static_cast<int>(x1 * a.width);
    int changed = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = first; x < last; ++x) {
            const std::size_t i = 4 * static_cast<std::size_t>(y * a.width + x);
            int most = 0;
            for (std::size_t c = i; c < i + 3; ++c) most = std::max(most, std::abs(a.rgba[c] - b.rgba[c]));
            changed += most > 24;
        }
    return double(changed) / ((last - first) * a.height);
}

Picture photo(ViewerDriver& viewer)
{
    viewer.key("s");
    return load_picture(viewer.directory() / viewer.wait_for("wrote (\\S+)").groups[1], 4096);
}

TEST_F(ViewerTest, each_key_shows_its_overlay_with_a_legend_and_takes_it_back)
{
    struct Key
    {
        const char *key, *on, *off;
        double least;  // of the picture that it changes, right of the legend
    };
    // Nothing touches yet, so that of contacts there is only the legend.
    constexpr Key keys[] = {{"1", "show_wireframe = true", "show_wireframe = false", 0.01},
                            {"2", "show_springs = true", "show_springs = false", 0.01},
                            {"3", "heat = strain", "heat = none", 0.01},
                            {"4", "heat = speed", "heat = none", 0.01},
                            {"5", "show_contacts = true", "show_contacts = false", 0.0},
                            {"6", "show_boxes = true", "show_boxes = false", 0.002},
                            {"7", "heat = culled", "heat = none", 0.01},
                            {"8", "heat = asleep", "heat = none", 0.01},
                            {"9", "show_pins = true", "show_pins = false", 0.0001},
                            {"0", "show_wind = true", "show_wind = false", 0.001}};
    ViewerDriver viewer({"seed", "--paused", "--backend", "cpu", "--set", "wind_mean=1"});
    viewer.key("n n n n n n n n");
    viewer.program().wait_for("frame 8: stepped");
    viewer.key("Tab");
    viewer.wait_for("control wind_strength hidden");
    // Good news of the first photo may lie over the picture's lower edge in the later ones.
    photo(viewer);
    const Picture bare = photo(viewer);
    for (const Key& key : keys) {
        viewer.key(key.key);
        viewer.wait_for(key.on);
        viewer.control("legend");
        const Picture shown = photo(viewer);
        EXPECT_GE(changed_part(bare, shown, 0.3, 0.9), key.least) << key.on;
        EXPECT_GT(changed_part(bare, shown, 0, 0.22), 0.02) << key.on << ": its legend";
        viewer.key(key.key);
        viewer.wait_for(key.off);
        viewer.wait_for("control legend hidden");
    }
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, the_legend_is_whole_in_a_small_window_and_at_twice_the_scale)
{
    for (const int dpi : {0, 192}) {
        if (dpi > 0 && !has_program("xprop")) GTEST_SKIP() << "needs xprop (package x11-utils)";
        ViewerDriver viewer({"seed", "--paused", "--size", "640x400"}, dpi);
        const int scale = dpi == 0 ? 1 : 2;
        viewer.key("3 9 0");
        viewer.wait_for("show_wind = true");
        const ControlPlace legend = viewer.control("legend");
        EXPECT_GE(legend.left, 320 * scale);
        EXPECT_LE(legend.left + legend.width, 640 * scale);
        EXPECT_GE(legend.top, 0);
        EXPECT_LE(legend.top + legend.height, 400 * scale);
        EXPECT_GT(legend.width, 200 * scale);
        EXPECT_EQ(viewer.quit(), 0);
    }
}

TEST(OverlaysWithoutWindow, a_rendered_frame_shows_them_and_the_run_has_the_same_bits)
{
    TemporaryDirectory directory;
    // Frame 28 of a scene with one more parameter; in the scene twist layers touch by then.
    const auto render = [&](const std::string& scene, const std::string& setting) {
        const std::filesystem::path out = directory.path() / (scene + setting);
        std::vector<std::string> words{"render",  scene,     "--frames", "29",        "--every", "28",    "--size",
                                       "320x180", "--quiet", "--hash",   "--backend", "cpu",     "--out", out.string()};
        if (!setting.empty()) words.insert(words.end(), {"--set", setting});
        const ProgramResult result = run_program(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.out.find("state-hash"), std::string::npos);
        return std::pair(load_picture(out / "frame_00028.png", 4096), result.out);
    };
    for (const std::string scene : {"seed", "twist"}) {
        const auto [bare, hash] = render(scene, "");
        for (const std::string setting : {"heat=strain", "heat=culled", "show_boxes=true", "show_contacts=true"}) {
            const auto [picture, same_hash] = render(scene, setting);
            EXPECT_EQ(hash, same_hash) << setting;
            const bool has_contacts = scene == "twist";
            if (setting == "show_contacts=true" && !has_contacts)
                EXPECT_EQ(bare.rgba, picture.rgba);
            else
                EXPECT_GT(changed_part(bare, picture, 0, 1), 0.002) << scene << " with " << setting;
        }
    }
}

}  // namespace
}  // namespace nuno
