// What a user gets wrong: one message with where, what and what would be right, and exit code 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Runs, expects exit code 2, and gives the message: one line on stderr, nothing on stdout.
std::string refusal(std::vector<std::string> words, const std::vector<std::string>& environment = {})
{
    words.push_back("--quiet");
    const ProgramResult result = run_program(words, environment);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
}

std::string render_refusal(const std::string& scene_text, const std::vector<std::string>& more = {})
{
    const TemporaryDirectory directory;
    std::vector<std::string> words{"render",    directory.write("bad.toml", scene_text).string(),
                                   "--frames",  "2",
                                   "--out",     (directory.path() / "out").string(),
                                   "--backend", "cpu"};
    words.insert(words.end(), more.begin(), more.end());
    return refusal(words);
}

const std::string kSheet = "[[sheet]]\ncolumns = 5\n";

TEST(BadInput, names_and_values_of_parameters)
{
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--set", "dampin=1"}), HasSubstr("nearest is damping"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--set", "damping=-1"}),
                HasSubstr("from 0 to 1000 kg/(m2 s)"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--set", "damping=nan"}), HasSubstr("--set"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--set", "damping"}), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--method", "xpdb"}), HasSubstr("xpbd"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--backend", "gpu", "--method", "sdirk2"}),
                HasSubstr("sdirk2 does not run on gpu; choose explicit_euler"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--method", "vbd", "--set", "internal_model=continuum"}),
                HasSubstr("vbd has no continuum"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--method", "rk4", "--set", "tethers=pins"}),
                HasSubstr("tethers: rk4 has none; choose none, or method xpbd"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--method", "xpbd", "--set", "stiffness_damping=0.01"}),
                HasSubstr("stiffness_damping: xpbd has none; choose 0, or method"));
    // Only methods that take everything asked for are offered.
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--method", "rk4", "--set", "stiffness_damping=0.01", "--set",
                         "tethers=pins"}),
                HasSubstr("choose none, or method vbd"));
    EXPECT_THAT(
        refusal({"render", "seed", "--no-images", "--method", "rk4", "--set", "internal_model=continuum", "--set",
                 "tethers=pins"}),
        HasSubstr("tethers: rk4 has none; choose none, or method xpbd or vbd with internal_model fabric_springs\n"));
    EXPECT_THAT(refusal({"render", "mannequin", "--no-images", "--backend", "cpu", "--set", "tethers=contacts"}),
                HasSubstr("contacts needs bodies that stand still"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--set", "thickness=-0.01"}), HasSubstr("from 0 to 1 m"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--set", "areal_density=0"}), HasSubstr("0.001"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--backend", "tpu"}), HasSubstr("cpu or gpu"));
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--threads", "many"}), HasSubstr("--threads"));
    EXPECT_THAT(refusal({"render", "seed", "--size", "12by4", "--out", "x"}), HasSubstr("WIDTHxHEIGHT"));
}

TEST(BadInput, scenes_and_places)
{
    EXPECT_THAT(refusal({"render", "sead", "--no-images"}), HasSubstr("nearest is seed"));
    EXPECT_THAT(refusal({"render", "missing.toml", "--no-images"}), HasSubstr("missing.toml"));
    EXPECT_THAT(refusal({"render", "seed"}), HasSubstr("--out"));
    const TemporaryDirectory directory;
    const std::string in_the_way = directory.write("file", "text").string();
    EXPECT_THAT(refusal({"render", "seed", "--out", in_the_way}), HasSubstr(in_the_way));
    EXPECT_THAT(refusal({"render", "seed", "--out", in_the_way + "/deeper"}), HasSubstr(in_the_way));
    EXPECT_EQ(read_text(in_the_way), "text");
    EXPECT_THAT(refusal({"render", "seed", "--no-images", "--backend", "cpu", "--frames", "2", "--json",
                         in_the_way + "/r.json"}),
                HasSubstr("r.json"));
}

TEST(BadInput, scene_files)
{
    EXPECT_THAT(render_refusal("format = 9\n" + kSheet), AllOf(HasSubstr("bad.toml:1"), HasSubstr("newer nuno")));
    EXPECT_THAT(render_refusal("[params]\nwind_strenght = 1\n" + kSheet),
                AllOf(HasSubstr("bad.toml:2"), HasSubstr("wind_strength")));
    EXPECT_THAT(render_refusal("[view]\nlok = \"phong\"\n" + kSheet),
                AllOf(HasSubstr("bad.toml:2"), HasSubstr("nearest is look")));
    EXPECT_THAT(render_refusal("[view]\ncamera_distance = inf\n" + kSheet), HasSubstr("bad.toml:2"));
    EXPECT_THAT(render_refusal("[view]\ncamera_distance = \"3\"\n" + kSheet), HasSubstr("bad.toml:2"));
}

TEST(BadInput, textures_that_are_missing_or_cut_short)
{
    EXPECT_THAT(render_refusal(kSheet + "texture = \"none.bmp\"\n"), HasSubstr("none.bmp"));
    const TemporaryDirectory directory;
    const std::string whole = read_text(root_directory() / "assets" / "textures" / "weave.bmp");
    directory.write("cut.bmp", whole.substr(0, whole.size() / 2));
    directory.write("noise.bmp", "this is no picture");
    for (const char* name : {"cut.bmp", "noise.bmp"}) {
        const auto scene = directory.write("t.toml", kSheet + "texture = \"" + name + "\"\n");
        EXPECT_THAT(refusal({"render", scene.string(), "--frames", "1", "--backend", "cpu", "--out",
                             (directory.path() / "out").string()}),
                    HasSubstr(name));
    }
}

TEST(BadInput, meshes_that_are_no_cloth)
{
    const TemporaryDirectory directory;
    const auto refuse = [&](const std::string& obj) {
        directory.write("m.obj", obj);
        const auto scene = directory.write("t.toml", "[[sheet]]\nmesh = \"m.obj\"\n");
        return refusal({"render", scene.string(), "--no-images", "--backend", "cpu", "--frames", "1"});
    };
    EXPECT_THAT(refuse(""), HasSubstr("no vertices"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n"), HasSubstr("m.obj:4"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), HasSubstr("no area"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1"), HasSubstr("m.obj:3"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), HasSubstr("m.obj:3: 'nan' is no finite number"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 3 2 4\n"), HasSubstr("m.obj:5: this polygon crosses"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 1 2\n"), HasSubstr("face 1 has the same vertices"));
}

TEST(BadInput, meshes_that_are_odd_but_cloth_are_simulated_and_told)
{
    const TemporaryDirectory directory;
    directory.write("m.obj",
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 -1\n"
                    "v 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n");
    const auto scene = directory.write("t.toml", "[[sheet]]\nmesh = \"m.obj\"\n");
    const ProgramResult result =
        run_program({"render", scene.string(), "--no-images", "--backend", "cpu", "--frames", "3"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("more than two faces meet at 1 of its edges"),
                                  HasSubstr("vertices 0 and 1 (faces 0, 1, 2)")));
}

TEST(BadInput, no_opengl_4_3_says_what_was_found)
{
    const TemporaryDirectory directory;
    const std::string message = refusal({"render", "seed", "--frames", "1", "--out", directory.path().string()},
                                        {"MESA_GL_VERSION_OVERRIDE=3.3"});
    EXPECT_THAT(message, AllOf(HasSubstr("4.3"), HasSubstr("3.3")));
}

TEST(BadInput, no_display_for_the_window_says_what_to_do)
{
    const std::string message = refusal({"view", "seed"}, {"DISPLAY=", "WAYLAND_DISPLAY="});
    EXPECT_THAT(message, AllOf(HasSubstr("DISPLAY"), HasSubstr("nuno render")));
}

TEST(BadInput, words_that_no_command_knows)
{
    for (const std::vector<std::string>& words : {std::vector<std::string>{"rendr"},
                                                  {},
                                                  {"render", "seed", "--frame", "3"},
                                                  {"render", "seed", "--frames", "0"}})
    {
        const ProgramResult result = run_program(words);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, testing::StartsWith("nuno: "));
    }
    EXPECT_THAT(run_program({"rendr"}).err, AllOf(HasSubstr("nearest is render"), HasSubstr("compare")));
}

TEST(BadInput, bodies_that_make_no_sense)
{
    EXPECT_THAT(render_refusal("[params]\nthickness = -0.01\n" + kSheet),
                AllOf(HasSubstr("bad.toml:2"), HasSubstr("0 to 1 m")));
    EXPECT_THAT(render_refusal(kSheet + "[[sphere]]\nradius = -1\n"),
                AllOf(HasSubstr("bad.toml:4"), HasSubstr("above 0")));
    EXPECT_THAT(render_refusal(kSheet + "[[box]]\nkeyframes = [{ time = 2 },\n{ time = 1 }]\n"),
                AllOf(HasSubstr("bad.toml:5"), HasSubstr("later than"), HasSubstr("2 s")));
    const TemporaryDirectory directory;
    directory.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
    const auto scene = directory.write("t.toml", kSheet + "[[body_mesh]]\nmesh = \"open.obj\"\n");
    EXPECT_THAT(refusal({"render", scene.string(), "--no-images", "--backend", "cpu", "--frames", "1"}),
                AllOf(HasSubstr("open.obj"), HasSubstr("closed"), HasSubstr("vertex 2 to vertex 1")));
}

TEST(BadInput, an_output_that_cannot_be_written_is_said_before_the_work)
{
    const ProgramResult result = run_program(
        {"render", "seed", "--no-images", "--backend", "cpu", "--frames", "90000000", "--json", "/nonexistent/r.json"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("/nonexistent"));
}

}  // namespace
}  // namespace nuno
