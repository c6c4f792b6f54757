// What a headless run leaves behind for other programs: whole, also where an encoder dies or the disk is full.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stb_image.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::set<std::string> names_in(const fs::path& directory)
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory)) names.insert(entry.path().filename().string());
    return names;
}

std::int32_t sample_count(const fs::path& cache)
{
    std::int32_t count = -1;
    std::memcpy(&count, read_text(cache).data() + 28, sizeof count);
    return count;
}

// A cloth of 25 vertices, simulated without OpenGL.
class FileOutputTest : public testing::Test
{
  protected:
    ProgramResult run(std::vector<std::string> more, const ProgramLimits& limits = {},
                      const std::vector<std::string>& environment = {})
    {
        const fs::path scene =
            folder.write("towel.toml", "[[sheet]]\nname = \"towel\"\ncolumns = 5\npins = [\"top\"]\n");
        std::vector<std::string> words{"render", scene, "--backend", "cpu", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words, environment, limits);
    }
    TemporaryDirectory folder;
    fs::path out = folder.path() / "out";
};

TEST_F(FileOutputTest, a_point_cache_comes_with_the_mesh_that_it_moves)
{
    fs::create_directory(out);
    const ProgramResult result = run({"--no-images", "--frames", "7", "--every", "3", "--pc2", out / "towel.pc2"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(names_in(out), (std::set<std::string>{"towel.mtl", "towel.obj", "towel.pc2"}));
    EXPECT_EQ(sample_count(out / "towel.pc2"), 3);
    // The vertices of the mesh are those of the first sample, in order.
    const std::string cache = read_text(out / "towel.pc2");
    ASSERT_EQ(cache.size(), 32u + 3 * 25 * 12);
    std::istringstream obj(read_text(out / "towel.obj"));
    std::size_t vertex = 0;
    for (std::string word; obj >> word;) {
        if (word != "v") continue;
        float from_cache[3], x, y, z;
        std::memcpy(from_cache, cache.data() + 32 + 12 * vertex++, sizeof from_cache);
        obj >> x >> y >> z;
        EXPECT_EQ(x, from_cache[0]);
        EXPECT_EQ(y, from_cache[1]);
        EXPECT_EQ(z, from_cache[2]);
    }
    EXPECT_EQ(vertex, 25u);
}

TEST_F(FileOutputTest, a_mesh_of_the_user_beside_the_point_cache_is_not_replaced)
{
    folder.write("towel.obj", "v 0 0 0\n");
    const ProgramResult result = run({"--no-images", "--frames", "2", "--pc2", folder.path() / "towel.pc2"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("towel.obj: would be replaced"));
    EXPECT_EQ(read_text(folder.path() / "towel.obj"), "v 0 0 0\n");
    EXPECT_FALSE(fs::exists(folder.path() / "towel.pc2"));
}

TEST_F(FileOutputTest, meshes_name_the_sheets_and_their_textures_from_where_they_are)
{
    const fs::path texture = folder.path() / "weave.bmp";
    fs::copy(root_directory() / "assets/textures/weave.bmp", texture);
    const fs::path scene = folder.write("two.toml",
                                        "[view]\ntexture_scale = 3.0\n[[sheet]]\nname = \"red flag\"\ncolumns = 3\n"
                                        "texture = \"weave.bmp\"\n[[sheet]]\ncolumns = 3\norigin = [0, 0, 1]\n");
    const ProgramResult result = run_program({"render", scene, "--backend", "cpu", "--no-images", "--frames", "2",
                                              "--mesh", "obj", "--out", out, "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(names_in(out), (std::set<std::string>{"mesh.mtl", "mesh_00000.obj", "mesh_00001.obj"}));
    EXPECT_THAT(read_text(out / "mesh_00001.obj"),
                AllOf(HasSubstr("mtllib mesh.mtl\n"), HasSubstr("g red_flag\nusemtl red_flag\nf 1/1 4/4 5/5\n"),
                      HasSubstr("g cloth\nusemtl cloth\nf 10/10 13/13 14/14\n")));
    EXPECT_THAT(read_text(out / "mesh.mtl"), HasSubstr("newmtl red_flag\n"));
    EXPECT_THAT(read_text(out / "mesh.mtl"), HasSubstr("map_Kd -s 3 3 1 ../weave.bmp\n"));
}

TEST_F(FileOutputTest, the_table_has_the_fields_of_the_report_and_a_line_a_frame)
{
    fs::create_directory(out);
    const ProgramResult result =
        run({"--no-images", "--frames", "5", "--csv", out / "t.csv", "--json", out / "r.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto frames = nlohmann::json::parse(read_text(out / "r.json"))["frames"];
    std::istringstream lines(read_text(out / "t.csv"));
    std::string names, line;
    ASSERT_TRUE(std::getline(lines, names));
    for (std::size_t k = 0; k < 5; ++k) {
        ASSERT_TRUE(std::getline(lines, line));
        std::istringstream names_left(names), values(line);
        std::size_t fields = 0;
        for (std::string name, value; std::getline(names_left, name, ',') && std::getline(values, value, ','); ++fields)
        {
            const std::size_t dot = name.find('.');
            const auto& field =
                dot == name.npos ? frames[k].at(name) : frames[k].at(name.substr(0, dot)).at(name.substr(dot + 1));
            EXPECT_EQ(field, nlohmann::json::parse(value)) << name;
        }
        EXPECT_EQ(fields, 5 + frames[k]["stage_ms"].size() + frames[k]["count"].size() + 3);
    }
    EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(FileOutputTest, a_gltf_file_holds_every_written_frame_and_the_texture)
{
    const fs::path file = folder.path() / "seed.glb";
    const ProgramResult result = run_program({"render", "drape", "--backend", "cpu", "--no-images", "--frames", "7",
                                              "--every", "2", "--gltf", file, "--quiet", "--set", "resolution=9"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::string bytes = read_text(file);
    std::uint32_t json_length = 0;
    std::memcpy(&json_length, bytes.data() + 12, sizeof json_length);
    const auto json = nlohmann::json::parse(bytes.substr(20, json_length));
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["targets"].size(), 3u);
    const auto& input = json["accessors"][json["animations"][0]["samplers"][0]["input"].get<std::size_t>()];
    EXPECT_FLOAT_EQ(input["max"][0].get<float>(), 6 / 60.0f);
    const auto& view = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
    int width = 0, height = 0, channels = 0;
    const auto* image =
        reinterpret_cast<const stbi_uc*>(bytes.data()) + 28 + json_length + view["byteOffset"].get<std::size_t>();
    EXPECT_TRUE(stbi_info_from_memory(image, view["byteLength"], &width, &height, &channels));
    EXPECT_EQ(width, 256);
}

TEST_F(FileOutputTest, a_seam_of_the_texture_changes_files_and_not_the_simulation)
{
    const std::string mesh = "v 0 1 0\nv 0 0 0\nv 1 1 0\nv 1 0 0\nv 2 1 0\nv 2 0 0.1\nvt 0 1\nvt 0 0\nvt 1 1\nvt 1 0\n";
    const auto simulate = [&](const std::string& name, const std::string& faces) {
        folder.write(name + ".obj", mesh + faces);
        const fs::path scene = folder.write(name + ".toml", "[[sheet]]\nmesh = \"" + name + ".obj\"\npins = [0]\n");
        const fs::path base = folder.path() / ("written_" + name);
        return run_program({"render", scene, "--backend", "cpu", "--quiet", "--no-images", "--frames", "20", "--hash",
                            "--set", "fabric=cotton", "--pc2", base.string() + ".pc2", "--gltf",
                            base.string() + ".glb"});
    };
    // On the left square, vertices 3 and 4 wear the right side of the texture, or what the right square gives them.
    const ProgramResult seam = simulate("seam", "f 1/1 2/2 4/4 3/3\nf 3/1 4/2 6/4 5/3\n");
    const ProgramResult none = simulate("none", "f 1/1 2/2 4/2 3/1\nf 3/1 4/2 6/4 5/3\n");
    EXPECT_EQ(seam.exit_code, 0) << seam.err;
    EXPECT_THAT(seam.out, testing::StartsWith("state-hash "));
    EXPECT_EQ(seam.out, none.out);
    EXPECT_EQ(read_text(folder.path() / "written_seam.pc2"), read_text(folder.path() / "written_none.pc2"));
    const auto lines = [&](const std::string& file, const std::string& start) {
        std::istringstream text(read_text(folder.path() / file));
        int count = 0;
        for (std::string line; std::getline(text, line);) count += line.starts_with(start) ? 1 : 0;
        return count;
    };
    EXPECT_EQ(lines("written_seam.obj", "v "), 6) << "as many as the point cache moves";
    EXPECT_EQ(lines("written_seam.obj", "vt "), 8);
    EXPECT_EQ(lines("written_none.obj", "vt "), 6);
    const auto vertex_count = [&](const std::string& file) {
        const std::string bytes = read_text(folder.path() / file);
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, sizeof length);
        const auto json = nlohmann::json::parse(bytes.substr(20, length));
        const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
        return json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"].get<int>();
    };
    EXPECT_EQ(vertex_count("written_seam.glb"), 8);
    EXPECT_EQ(vertex_count("written_none.glb"), 6);
}

TEST_F(FileOutputTest, names_with_an_ending_of_another_format_are_refused)
{
    EXPECT_THAT(run({"--no-images", "--pc2", folder.path() / "a.obj"}).err, HasSubstr("ends in .pc2"));
    EXPECT_THAT(run({"--no-images", "--gltf", folder.path() / "a.gltf"}).err, HasSubstr("ends in .glb"));
}

TEST_F(FileOutputTest, a_full_disk_leaves_each_kind_of_file_whole_or_as_it_was)
{
    // 25 vertices: 300 bytes a sample of the point cache, 1.3 kB of OBJ, more of the others.
    const auto full = [&](const std::string& flag, const std::string& name, const std::string& old) {
        fs::remove_all(out);
        fs::create_directory(out);
        if (!old.empty()) write_whole(out / name, old);
        const ProgramResult result =
            run({"--no-images", "--frames", "40", flag, out / name}, {.file_bytes = 3000, .interrupt_at = {}});
        EXPECT_EQ(result.exit_code, 2) << flag;
        EXPECT_THAT(result.err, AllOf(HasSubstr(name), HasSubstr("has room")));
    };
    full("--pc2", "t.pc2", "");
    EXPECT_EQ(sample_count(out / "t.pc2"), 9);
    EXPECT_EQ(fs::file_size(out / "t.pc2"), 32u + 9 * 300);
    EXPECT_EQ(names_in(out), (std::set<std::string>{"t.mtl", "t.obj", "t.pc2"}));
    for (const auto& [flag, name] : {std::pair{"--json", "t.json"}, {"--csv", "t.csv"}, {"--gltf", "t.glb"}}) {
        full(flag, name, "old");
        EXPECT_EQ(names_in(out), std::set<std::string>{name});
        EXPECT_EQ(read_text(out / name), "old");
    }
}

TEST_F(FileOutputTest, a_full_disk_leaves_no_half_mesh)
{
    const ProgramResult result =
        run({"--no-images", "--frames", "4", "--mesh", "obj", "--out", out}, {.file_bytes = 1000, .interrupt_at = {}});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("mesh_00000.obj: cannot be written"));
    EXPECT_EQ(names_in(out), std::set<std::string>{"mesh.mtl"});
}

TEST_F(FileOutputTest, a_full_disk_leaves_no_half_video)
{
    if (std::system("command -v ffmpeg >/dev/null") != 0) GTEST_SKIP() << "no ffmpeg";
    fs::create_directory(out);
    const ProgramResult result = run({"--frames", "30", "--size", "320x180", "--video", out / "t.mp4"},
                                     {.file_bytes = 2000, .interrupt_at = {}}, {"MESA_SHADER_CACHE_DISABLE=true"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("t.mp4"));
    EXPECT_TRUE(names_in(out).empty());
}

TEST_F(FileOutputTest, an_encoder_that_is_killed_ends_the_run_and_all_else_is_whole)
{
    // Reads a picture and a bit, and dies.
    const fs::path broken = folder.write("ffmpeg", "#!/bin/sh\n/usr/bin/head -c 70000 >/dev/null\nkill -9 $$\n");
    fs::permissions(broken, fs::perms::owner_all);
    const ProgramResult result =
        run({"--frames", "50", "--size", "160x90", "--out", out, "--video", folder.path() / "t.mp4", "--pc2",
             folder.path() / "t.pc2", "--json", folder.path() / "t.json", "--csv", folder.path() / "t.csv"},
            {}, {"PATH=" + folder.path().string()});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err,
                AllOf(HasSubstr("t.mp4"), HasSubstr("ffmpeg was ended by signal 9"), HasSubstr("picture ")));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(fs::exists(folder.path() / "t.mp4"));
    EXPECT_EQ(names_in(folder.path()),
              (std::set<std::string>{"ffmpeg", "out", "t.csv", "t.json", "t.mtl", "t.obj", "t.pc2", "towel.toml"}));
    const std::size_t frames = nlohmann::json::parse(read_text(folder.path() / "t.json"))["frames"].size();
    EXPECT_GE(frames, 1u);
    EXPECT_LT(frames, 50u);
    EXPECT_EQ(sample_count(folder.path() / "t.pc2"), static_cast<std::int32_t>(frames));
    EXPECT_EQ(names_in(out).size(), frames);
    for (const std::string& name : names_in(out)) {
        int width = 0, height = 0, channels = 0;
        stbi_uc* pixels = stbi_load((out / name).c_str(), &width, &height, &channels, 3);
        EXPECT_TRUE(pixels) << name;
        stbi_image_free(pixels);
    }
}

}  // namespace
}  // namespace nuno
