// Recording from the window.
#include <algorithm>
#include <csignal>
#include <fstream>

#include "app/viewer_driver.h"
#include "core/files.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSmall{"seed", "--paused", "--backend", "cpu", "--size", "640x400"};

int count_of(const fs::path& directory, const std::string& extension)
{
    return static_cast<int>(std::count_if(fs::directory_iterator(directory), fs::directory_iterator{},
                                          [&](const auto& entry) { return entry.path().extension() == extension; }));
}

void step(ViewerDriver& viewer, int count, int last)
{
    std::string keys;
    for (int i = 0; i < count; ++i) keys += "n ";
    viewer.key(keys);
    viewer.program().wait_for("frame " + std::to_string(last) + ": stepped");
}

TEST_F(ViewerTest, every_simulated_frame_is_recorded_as_a_picture_without_panels)
{
    ViewerDriver viewer(kSmall);
    step(viewer, 2, 2);
    viewer.key("v");
    viewer.wait_for("recording to seed_frames_0001");
    step(viewer, 4, 6);
    viewer.key("v");
    viewer.wait_for("wrote 5 frames to seed_frames_0001");
    const fs::path directory = viewer.directory() / "seed_frames_0001";
    EXPECT_EQ(count_of(directory, ".png"), 5);
    for (const char* name : {"frame_00002.png", "frame_00006.png"}) {
        const Picture picture = load_picture(directory / name, 4096);
        EXPECT_EQ(picture.width, 640);
        EXPECT_EQ(picture.height, 400);
        EXPECT_GT(picture.rgba[0] + picture.rgba[1] + picture.rgba[2], 300) << "the bright room, not the dark panel";
    }
    viewer.key("v");
    viewer.wait_for("recording to seed_frames_0002");
    viewer.key("r");
    viewer.wait_for("wrote 1 frames to seed_frames_0002");
    EXPECT_EQ(viewer.quit(), 0);
}

TEST_F(ViewerTest, a_window_closed_while_recording_leaves_whole_files)
{
    if (!has_program("ffmpeg")) GTEST_SKIP() << "needs ffmpeg";
    ViewerDriver viewer(kSmall);
    viewer.resize(900, 1400);
    viewer.wait_for("framebuffer 900x");
    viewer.click_control("group wind");
    viewer.click_control("group stiffness");
    viewer.click_control("group record");
    viewer.click_control("record video");
    viewer.click_control("record meshes");
    viewer.click_control("button Record");
    viewer.wait_for("recording to seed_frames_0001");
    step(viewer, 6, 6);
    EXPECT_EQ(viewer.quit(), 0);
    const fs::path directory = viewer.directory() / "seed_frames_0001";
    EXPECT_GT(fs::file_size(directory / "video.mp4"), 500u);
    EXPECT_EQ(fs::file_size(directory / "cloth.pc2"), 32u + 7 * 289 * 12);
    EXPECT_EQ(count_of(directory, ".png"), 0);
    if (!has_program("ffprobe")) return;
    EXPECT_EQ(
        run_shell("ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames -of csv=p=0 " +
                  (directory / "video.mp4").string()),
        "7\n");
}

}  // namespace
}  // namespace nuno
