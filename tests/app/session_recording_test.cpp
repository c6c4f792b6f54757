// Recording where the encoder is missing or dies: it is told, what was written stays, and the cloth goes on.
#include <algorithm>
#include <cstdlib>

#include "app/viewer_session.h"
#include "core/error.h"
#include "gl/gl_test.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

// Works in a folder of its own, where alone programs are looked for.
class SessionRecordingTest : public GlTest
{
  protected:
    SessionRecordingTest()
    {
        fs::current_path(folder_.path());
        setenv("PATH", folder_.path().c_str(), 1);
    }
    ~SessionRecordingTest() override
    {
        setenv("PATH", path_.c_str(), 1);
        fs::current_path(before_);
    }
    static ViewerOptions options()
    {
        ViewerOptions options;
        const Scene scene = load_scene("seed");
        options.start = {scene, scene.params, {}};
        options.start.params.backend = Backend::cpu;
        options.start.view.width = 160;
        options.start.view.height = 90;
        options.paused = true;
        return options;
    }

    TemporaryDirectory folder_;
    fs::path before_ = fs::current_path();
    std::string path_ = std::getenv("PATH");
    ViewerLog log_{false};
};

TEST_F(SessionRecordingTest, a_missing_encoder_is_told_and_leaves_nothing)
{
    ViewerSession session(options(), log_, false);
    session.recording_plan().kind = RecordingKind::video;
    session.toggle_recording();
    EXPECT_FALSE(session.recording().is_on());
    EXPECT_NE(session.error().find("ffmpeg"), std::string::npos) << session.error();
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(SessionRecordingTest, an_encoder_that_dies_ends_the_recording_and_not_the_run)
{
    const fs::path broken = folder_.write("ffmpeg", "#!/bin/sh\n/usr/bin/head -c 70000 >/dev/null\nkill -9 $$\n");
    fs::permissions(broken, fs::perms::owner_all);
    ViewerSession session(options(), log_, false);
    session.recording_plan() = {RecordingKind::video, true};
    session.toggle_recording();
    ASSERT_TRUE(session.recording().is_on()) << session.error();
    for (int frame = 0; frame < 40 && session.recording().is_on(); ++frame) session.step();
    EXPECT_FALSE(session.recording().is_on());
    EXPECT_NE(session.error().find("ffmpeg was ended by signal 9"), std::string::npos) << session.error();
    EXPECT_FALSE(session.went_bad());
    const fs::path directory = session.recording().directory();
    EXPECT_FALSE(fs::exists(directory / "video.mp4"));
    EXPECT_GT(fs::file_size(directory / "cloth.pc2"), 32u + 289 * 12) << "the meshes are whole";
    const int frame = session.simulation().frame();
    session.step();
    EXPECT_EQ(session.simulation().frame(), frame + 1);
}

TEST_F(SessionRecordingTest, another_scene_and_going_back_end_it)
{
    ViewerSession session(options(), log_, false);
    session.toggle_recording();
    for (int frame = 0; frame < 3; ++frame) session.step();
    session.show_frame(1);
    EXPECT_FALSE(session.recording().is_on());
    EXPECT_EQ(session.take_recorded(), "wrote 4 frames to seed_frames_0001");
    EXPECT_EQ(session.take_recorded(), "");
    session.toggle_recording();
    EXPECT_EQ(session.recording().directory(), "seed_frames_0002");
    session.restart();
    EXPECT_FALSE(session.recording().is_on());
    EXPECT_TRUE(fs::exists("seed_frames_0002/frame_00001.png"));
}

}  // namespace
}  // namespace nuno
