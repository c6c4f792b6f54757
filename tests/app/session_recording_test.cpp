// Recording where the encoder is missing or dies, or the disk is full: it is told, what was written stays, and the cloth goes on.
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "app/viewer_session.h"
#include "core/error.h"
#include "gl/gl_test.h"
#include "render/texture_file.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

// As long as it lives, a write beyond so many bytes of a file fails, as on a full disk.
class FullDisk
{
  public:
    explicit FullDisk(rlim_t file_bytes)
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{file_bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

// Steps until the recording ends by itself, and a frame more: the run goes on.
void step_to_the_end(ViewerSession& session)
{
    for (int frame = 0; frame < 40 && session.recording().is_on(); ++frame) session.step();
    EXPECT_FALSE(session.recording().is_on());
    EXPECT_TRUE(session.error().starts_with("recording has ended: ")) << session.error();
    EXPECT_FALSE(session.went_bad());
    const int frame = session.simulation().frame();
    session.step();
    EXPECT_EQ(session.simulation().frame(), frame + 1);
}

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

TEST_F(SessionRecordingTest, a_point_cache_begun_in_the_middle_has_its_mesh_beside_it)
{
    ViewerSession session(options(), log_, false);
    for (int frame = 0; frame < 3; ++frame) session.step();
    session.recording_plan().point_cache = true;
    session.toggle_recording();
    ASSERT_TRUE(session.recording().is_on()) << session.error();
    const glm::vec3 first(session.simulation().state().positions.back());
    const fs::path folder = session.recording().directory();
    session.step();
    session.stop_recording();
    const TriangleMesh mesh = load_obj(folder / "cloth.obj");
    ASSERT_EQ(mesh.positions.size(), session.simulation().model().vertex_count());
    EXPECT_LT(glm::distance(mesh.positions.back(), first), 1e-6f) << "as the first sample has it";
    EXPECT_TRUE(fs::exists(folder / "cloth.mtl"));
}

TEST_F(SessionRecordingTest, another_frame_rate_ends_the_recording)
{
    ViewerSession session(options(), log_, false);
    session.toggle_recording();
    ASSERT_TRUE(session.recording().is_on()) << session.error();
    session.set_sim_param(*find_param(sim_param_table(), "damping"), 1);
    EXPECT_TRUE(session.recording().is_on());
    session.set_sim_param(*find_param(sim_param_table(), "frame_rate"), 30);
    EXPECT_FALSE(session.recording().is_on());
}

TEST_F(SessionRecordingTest, an_encoder_that_dies_ends_the_recording_and_not_the_run)
{
    const fs::path broken = folder_.write("ffmpeg", "#!/bin/sh\n/usr/bin/head -c 70000 >/dev/null\nkill -9 $$\n");
    fs::permissions(broken, fs::perms::owner_all);
    ViewerSession session(options(), log_, false);
    session.recording_plan() = {RecordingKind::video, true};
    session.toggle_recording();
    ASSERT_TRUE(session.recording().is_on()) << session.error();
    step_to_the_end(session);
    EXPECT_NE(session.error().find("ffmpeg was ended by signal 9"), std::string::npos) << session.error();
    const fs::path directory = session.recording().directory();
    EXPECT_FALSE(fs::exists(directory / "video.mp4"));
    EXPECT_GT(fs::file_size(directory / "cloth.pc2"), 32u + 289 * 12) << "the meshes are whole";
}

TEST_F(SessionRecordingTest, a_disk_that_fills_up_ends_the_recording_with_whole_pictures)
{
    ViewerSession session(options(), log_, false);
    session.toggle_recording();
    for (int frame = 0; frame < 12; ++frame) session.step();
    ASSERT_TRUE(session.recording().is_on()) << session.error();
    const FullDisk full(100);
    step_to_the_end(session);
    EXPECT_NE(session.error().find(".png: cannot be written (File too large)"), std::string::npos) << session.error();
    EXPECT_NE(session.error().find("has room"), std::string::npos) << session.error();
    EXPECT_EQ(std::count(session.error().begin(), session.error().end(), '\n'), 0);
    int count = 0;
    for (const auto& file : fs::directory_iterator(session.recording().directory())) {
        EXPECT_EQ(load_picture(file.path(), 4096).width, 160);
        ++count;
    }
    EXPECT_GE(count, 1);
    EXPECT_EQ(session.take_recorded(), "") << "no word of success";
}

TEST_F(SessionRecordingTest, a_disk_that_fills_up_leaves_the_samples_of_the_point_cache_so_far)
{
    ViewerSession session(options(), log_, false);
    session.recording_plan().point_cache = true;
    constexpr rlim_t sample_bytes = 289 * 12;
    const FullDisk full(32 + 16 * sample_bytes + 100);  // more than what the OBJ file and a picture take
    session.toggle_recording();
    ASSERT_TRUE(session.recording().is_on()) << session.error();
    step_to_the_end(session);
    EXPECT_NE(session.error().find("cloth.pc2: cannot be written"), std::string::npos) << session.error();
    const fs::path directory = session.recording().directory();
    EXPECT_EQ(fs::file_size(directory / "cloth.pc2"), 32 + 16 * sample_bytes);
    for (const auto& file : fs::directory_iterator(directory)) {
        if (file.path().extension() == ".png") {
            EXPECT_EQ(load_picture(file.path(), 4096).width, 160);
        }
        EXPECT_EQ(file.path().string().find(".part"), std::string::npos) << file.path();
    }
}

TEST_F(SessionRecordingTest, a_disk_that_is_full_from_the_start_is_told_and_nothing_is_left)
{
    ViewerSession session(options(), log_, false);
    session.recording_plan().point_cache = true;
    const FullDisk full(10);
    session.toggle_recording();
    EXPECT_FALSE(session.recording().is_on());
    EXPECT_NE(session.error().find("cannot be written"), std::string::npos) << session.error();
    EXPECT_TRUE(fs::is_empty(folder_.path()));
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
