// Headless runs as scripts use them: files, hashes, reports, exit codes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stb_image.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::set<std::string> names_in(const fs::path& directory)
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory)) names.insert(entry.path().filename().string());
    return names;
}

bool is_whole_picture(const fs::path& path, int width, int height)
{
    int w = 0, h = 0, channels = 0;
    unsigned char* pixels = stbi_load(path.c_str(), &w, &h, &channels, 3);
    stbi_image_free(pixels);
    return pixels && w == width && h == height;
}

TEST(RenderCommand, writes_one_whole_picture_a_frame_and_nothing_else)
{
    const TemporaryDirectory directory;
    const ProgramResult result =
        run_program({"render", "seed", "--frames", "4", "--size", "160x90", "--out", directory.path()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(names_in(directory.path()),
              (std::set<std::string>{"frame_00000.png", "frame_00001.png", "frame_00002.png", "frame_00003.png"}));
    for (const std::string& name : names_in(directory.path()))
        EXPECT_TRUE(is_whole_picture(directory.path() / name, 160, 90));
}

TEST(RenderCommand, the_first_mesh_is_the_start_and_every_k_th_is_written)
{
    const TemporaryDirectory directory;
    const ProgramResult result =
        run_program({"render", "seed", "--backend", "cpu", "--no-images", "--frames", "7", "--every", "3", "--mesh",
                     "ply", "--pc2", directory.path() / "seed.pc2", "--out", directory.path()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(names_in(directory.path()), (std::set<std::string>{"mesh_00000.ply", "mesh_00003.ply", "mesh_00006.ply",
                                                                 "seed.mtl", "seed.obj", "seed.pc2"}));
    EXPECT_THAT(read_text(directory.path() / "mesh_00000.ply"), HasSubstr("end_header\n-0.5 1 0\n-0.4375 1 0\n"));
    EXPECT_EQ(fs::file_size(directory.path() / "seed.pc2"), 32u + 3 * 289 * 12);
}

TEST(RenderCommand, the_hash_is_the_last_line_and_the_same_for_every_backend_and_thread_count)
{
    std::set<std::string> lines;
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--backend", "cpu", "--threads", "1"},
                                                 {"--backend", "cpu", "--threads", "2"},
                                                 {"--backend", "gpu"}})
    {
        std::vector<std::string> words{"render", "seed", "--frames", "30", "--no-images", "--hash", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramResult result = run_program(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        EXPECT_THAT(result.out, testing::MatchesRegex("state-hash [0-9a-f]+\n"));
        EXPECT_EQ(result.out.size(), 11u + 16 + 1);
        lines.insert(result.out);
    }
    EXPECT_EQ(lines.size(), 1u);
}

TEST(RenderCommand, the_report_has_a_row_a_frame_and_the_parameters_as_used)
{
    const TemporaryDirectory directory;
    const ProgramResult result = run_program({"render", "seed", "--backend", "cpu", "--frames", "12", "--no-images",
                                              "--set", "wind_strength=5", "--json", directory.path() / "r.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto report = nlohmann::json::parse(read_text(directory.path() / "r.json"));
    EXPECT_EQ(report["frames"].size(), 12u);
    EXPECT_EQ(report["params"]["wind_strength"], 5);
    EXPECT_EQ(report["params"]["backend"], "cpu");
    EXPECT_EQ(report["scene"], "seed");
    EXPECT_GT(report["frames"][11]["stage_ms"]["solve"], 0);
    EXPECT_GT(report["frames"][11]["energy_j"]["kinetic"], 0);
    EXPECT_NEAR(report["frames"][11]["time_s"].get<double>(), 11 / 60.0, 1e-9);
}

TEST(RenderCommand, a_scene_that_fails_its_end_check_exits_with_1)
{
    const TemporaryDirectory directory;
    const auto scene =
        directory.write("t.toml", "[[sheet]]\ncolumns = 5\n[check]\nframes = 3\nfinal_highest = [5, 6]\n");
    const std::vector<std::string> words{"render", scene, "--backend", "cpu", "--no-images", "--frames", "5"};
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("t.toml:5: final_highest is"));
    std::vector<std::string> changed = words;
    changed.insert(changed.end(), {"--set", "gravity_y=-1"});
    EXPECT_EQ(run_program(changed).exit_code, 0) << "the check is for the scene as written";
}

TEST(RenderCommand, a_promise_that_is_not_kept_exits_with_1_and_says_where)
{
    const TemporaryDirectory directory;
    const std::string sheet =
        "[[sheet]]\ncolumns = 3\norigin = [0, 0, {}]\nacross = [1, 0, 0]\ndown = [0, 0, 1]\npins = [\"top\"]\n";
    const auto scene = [&](const char* name, const char* z) {
        return directory
            .write(name,
                   "title = \"two\"\n" + fmt::format(fmt::runtime(sheet), 0) + fmt::format(fmt::runtime(sheet), z))
            .string();
    };
    const std::vector<std::string> words{"--frames", "3",           "--no-images", "--backend",
                                         "cpu",      "--collision", "guaranteed"};
    const auto run = [&](const std::string& path) {
        std::vector<std::string> all{"render", path};
        all.insert(all.end(), words.begin(), words.end());
        return run_program(all);
    };
    const ProgramResult touching = run(scene("touching.toml", "0.5"));
    EXPECT_EQ(touching.exit_code, 1);
    EXPECT_THAT(touching.err, HasSubstr("`guaranteed` does not hold: layers touched"));
    EXPECT_THAT(touching.err, HasSubstr("face 0 of sheet cloth touches face 8 of sheet cloth at "));
    EXPECT_EQ(run(scene("apart.toml", "1.5")).exit_code, 0);
}

TEST(RenderCommand, a_run_that_goes_bad_exits_with_3_and_advice)
{
    const ProgramResult result = run_program({"render", "hang", "--method", "symplectic_euler", "--backend", "cpu",
                                              "--no-images", "--frames", "60", "--set", "substeps=40"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, testing::AllOf(HasSubstr("hang"), HasSubstr("frame"), HasSubstr("vertex"),
                                           HasSubstr("--set substeps=")));
}

TEST(RenderCommand, a_disk_that_fills_ends_it_with_a_message_and_whole_files)
{
    const TemporaryDirectory directory;
    const ProgramResult result =
        run_program({"render", "seed", "--backend", "cpu", "--frames", "20", "--size", "640x360", "--out",
                     directory.path(), "--quiet"},
                    {"MESA_SHADER_CACHE_DISABLE=true"}, {.file_bytes = 20000, .interrupt_at = {}});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("frame_000"));
    for (const std::string& name : names_in(directory.path()))
        EXPECT_TRUE(is_whole_picture(directory.path() / name, 640, 360)) << name;
}

TEST(RenderCommand, interrupted_it_exits_with_130_and_whole_files)
{
    const TemporaryDirectory directory;
    const fs::path report = directory.path() / "report.json", frames = directory.path() / "frames";
    const ProgramResult result = run_program({"render", "seed", "--backend", "cpu", "--frames", "100000", "--size",
                                              "320x180", "--out", frames, "--json", report},
                                             {}, {.file_bytes = 0, .interrupt_at = frames / "frame_00003.png"});
    EXPECT_EQ(result.exit_code, 130) << result.err;
    const auto names = names_in(frames);
    EXPECT_GE(names.size(), 4u);
    EXPECT_LT(names.size(), 100000u);
    for (const std::string& name : names) EXPECT_TRUE(is_whole_picture(frames / name, 320, 180)) << name;
    EXPECT_EQ(nlohmann::json::parse(read_text(report))["frames"].size(), names.size());
}

TEST(RenderCommand, a_video_is_whole_or_not_there)
{
    const TemporaryDirectory directory;
    const fs::path video = directory.path() / "seed.mp4";
    const std::vector<std::string> words{"render", "seed",   "--backend", "cpu", "--frames", "5",
                                         "--size", "161x90", "--video",   video, "--quiet"};
    const ProgramResult without = run_program(words, {"PATH=/nonexistent"});
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_THAT(without.err, HasSubstr("ffmpeg"));
    // An encoder that dies at once.
    const fs::path broken = directory.write("ffmpeg", "#!/bin/sh\nexit 1\n");
    fs::permissions(broken, fs::perms::owner_all);
    const ProgramResult died = run_program(words, {"PATH=" + directory.path().string()});
    EXPECT_EQ(died.exit_code, 2);
    EXPECT_THAT(died.err, HasSubstr("seed.mp4"));
    EXPECT_EQ(names_in(directory.path()), std::set<std::string>{"ffmpeg"});
    if (std::system("command -v ffmpeg >/dev/null") != 0) GTEST_SKIP() << "no ffmpeg";
    EXPECT_EQ(run_program(words).exit_code, 0);
    EXPECT_EQ(names_in(directory.path()), (std::set<std::string>{"ffmpeg", "seed.mp4"}));
    EXPECT_THAT(read_text(video).substr(0, 12), HasSubstr("ftyp"));
}

TEST(RenderCommand, on_a_software_renderer_it_says_once_that_the_cpu_is_faster)
{
    const ProgramResult result =
        run_program({"render", "seed", "--frames", "2", "--no-images"}, {"LIBGL_ALWAYS_SOFTWARE=1"});
    EXPECT_EQ(result.exit_code, 0);
    const std::size_t at = result.err.find("--backend cpu");
    EXPECT_NE(at, std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("--backend cpu", at + 1), std::string::npos) << result.err;
}

}  // namespace
}  // namespace nuno
