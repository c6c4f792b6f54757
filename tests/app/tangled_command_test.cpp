// Layers that intersect, and other input that is hard for `guaranteed`: what `nuno render` says and ends with.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "support/program_run.h"
#include "support/tangled_sheets.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

// Runs of one scene, without pictures, on the cpu.
class HardInput : public testing::Test
{
  protected:
    ProgramResult run(const std::string& scene, std::vector<std::string> flags)
    {
        const std::vector<std::string> common{
            "render", directory_.write("hard.toml", scene).string(), "--frames", "11", "--no-images", "--backend",
            "cpu"};
        flags.insert(flags.begin(), common.begin(), common.end());
        return run_program(flags);
    }
    ProgramResult guaranteed(const std::string& scene, const std::vector<std::string>& more = {})
    {
        std::vector<std::string> flags{"--collision", "guaranteed", "--set", "collision_passes=2", "--check", "1"};
        flags.insert(flags.end(), more.begin(), more.end());
        return run(scene, flags);
    }
    Json report_of(const std::string& scene, std::vector<std::string> flags, int exit_code)
    {
        const std::string path = (directory_.path() / "report.json").string();
        flags.insert(flags.end(), {"--json", path});
        const ProgramResult result = run(scene, flags);
        EXPECT_EQ(result.exit_code, exit_code) << result.err;
        return Json::parse(read_text(path)).at("summary");
    }

    TemporaryDirectory directory_;
};

TEST_F(HardInput, a_tangled_start_is_told_with_places_and_breaks_the_promise)
{
    const ProgramResult result = run(kTangledSheets, {"--collision", "guaranteed"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr("at the start"), HasSubstr("of sheet upper goes through face"),
                                  HasSubstr("--untangle"), HasSubstr("`guaranteed` does not hold")));
    const ProgramResult lower = run(kTangledSheets, {"--collision", "speculative"});
    EXPECT_EQ(lower.exit_code, 0);
    EXPECT_THAT(lower.err, AllOf(HasSubstr("at the start"), Not(HasSubstr("does not hold"))));
    EXPECT_EQ(run(kTangledSheets, {"--collision", "discrete"}).err.find("at the start"), std::string::npos);
    EXPECT_EQ(run(kTangledSheets, {"--collision", "speculative", "--quiet"}).err, "");
}

TEST_F(HardInput, untangle_makes_the_promise_hold)
{
    const ProgramResult result = guaranteed(kTangledSheets, {"--untangle"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("untangled"), HasSubstr("largest move"),
                                  HasSubstr("check of 11 poses: nothing"), Not(HasSubstr("at the start"))));
    const Json start = report_of(kTangledSheets, {"--untangle", "--collision", "guaranteed"}, 0).at("tangled_at_start");
    EXPECT_EQ(start.at("crossing"), 0);
    EXPECT_GT(start.at("pairs_before_untangle"), 10);
    EXPECT_GT(start.at("untangle_steps"), 0);
    EXPECT_GT(start.at("untangle_largest_move_m"), 0);
}

TEST_F(HardInput, the_report_tells_of_the_start_and_of_the_check)
{
    const Json plain = report_of(kTangledSheets, {"--collision", "none"}, 0);
    EXPECT_TRUE(plain.at("tangled_at_start").is_null());
    EXPECT_TRUE(plain.at("check").is_null());
    const Json checked = report_of(kTangledSheets, {"--collision", "guaranteed", "--check", "5"}, 1);
    EXPECT_GT(checked.at("tangled_at_start").at("crossing"), 10);
    EXPECT_EQ(checked.at("check").at("every"), 5);
    EXPECT_EQ(checked.at("check").at("poses"), 3);
    EXPECT_GT(checked.at("check").at("crossing"), 30);
    EXPECT_EQ(checked.at("check").at("first_frame"), 0);
}

TEST_F(HardInput, the_check_changes_nothing_and_tells_each_finding)
{
    const std::string falling =
        "[params]\nthickness = 0.001\n[[sheet]]\nname = \"floor\"\ncolumns = 9\n"
        "across = [1.0, 0.0, 0.0]\ndown = [0.0, 0.0, 1.0]\npins = [\"left\", \"right\"]\n"
        "[[sheet]]\nname = \"falling\"\ncolumns = 9\norigin = [0.1, 0.02, 0.1]\n"
        "across = [0.7, 0.1, 0.0]\ndown = [0.0, 0.0, 0.7]\n";
    const std::vector<std::string> flags{"--collision", "none", "--hash"};
    std::vector<std::string> checking = flags;
    checking.insert(checking.end(), {"--check", "1"});
    const ProgramResult plain = run(falling, flags), checked = run(falling, checking);
    EXPECT_EQ(plain.out, checked.out);
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_THAT(checked.err, AllOf(HasSubstr("of sheet falling goes through face"), HasSubstr("frame 10: "),
                                   HasSubstr("of sheet falling went through face"), HasSubstr("check of 11 poses")));
    EXPECT_EQ(run(falling, {"--check", "0"}).exit_code, 2);
}

std::string stacked(double thickness, double gap)
{
    return fmt::format(
        "[params]\nthickness = {}\n[[plane]]\noffset = -0.2\n[[sheet]]\nname = \"lower\"\ncolumns = 9\n"
        "across = [0.5, 0.0, 0.0]\ndown = [0.0, 0.0, 0.5]\n[[sheet]]\nname = \"upper\"\ncolumns = 9\n"
        "origin = [0.03, {}, 0.04]\nacross = [0.5, 0.0, 0.0]\ndown = [0.0, 0.0, 0.5]\n",
        thickness, gap);
}

TEST_F(HardInput, thickness_beyond_the_length_of_edges_holds)
{
    const ProgramResult result = guaranteed(stacked(0.1, 0.12));
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(HardInput, layers_that_start_closer_than_the_thickness_hold)
{
    for (const double gap : {1e-3, 1e-6}) {
        const ProgramResult result = guaranteed(stacked(0.01, gap));
        EXPECT_EQ(result.exit_code, 0) << result.err;
    }
}

TEST_F(HardInput, layers_in_one_plane_are_told)
{
    const ProgramResult result = guaranteed(stacked(0.01, 0));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr("faces touch"), HasSubstr("does not hold"), HasSubstr("touched")));
    const ProgramResult untangled = guaranteed(stacked(0.01, 0), {"--untangle"});
    EXPECT_EQ(untangled.exit_code, 0) << untangled.err;
}

// Two strips of one mesh whose seam has its vertices twice.
TEST_F(HardInput, doubled_vertices_are_told_apart_from_crossings)
{
    std::string obj;
    for (int strip = 0; strip < 2; ++strip)
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 5; ++i) obj += fmt::format("v {} 0 {}\n", 0.1 * (i + 4 * strip), 0.1 * j);
    for (int strip = 0; strip < 2; ++strip)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const int a = 25 * strip + 5 * j + i + 1;
                obj += fmt::format("f {} {} {} {}\n", a, a + 1, a + 6, a + 5);
            }
    directory_.write("seam.obj", obj);
    const std::string seam = "[[sheet]]\nmesh = \"seam.obj\"\npins = [0, 49]\n";
    const ProgramResult result = guaranteed(seam);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, AllOf(HasSubstr("merge vertices"), HasSubstr("touches face"), Not(HasSubstr("passed"))));
    const ProgramResult untangled = guaranteed(seam, {"--untangle"});
    EXPECT_EQ(untangled.exit_code, 0) << untangled.err;
}

TEST_F(HardInput, faces_without_area_are_refused_by_name)
{
    directory_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\n");
    const ProgramResult result = guaranteed("[[sheet]]\nmesh = \"flat.obj\"\n");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, AllOf(HasSubstr("flat.obj"), HasSubstr("no area")));
}

TEST_F(HardInput, a_body_inside_the_cloth_pushes_it_out)
{
    const ProgramResult result =
        guaranteed(stacked(0.005, 0.03) + "[[sphere]]\ncentre = [0.25, 0.015, 0.25]\nradius = 0.06\n");
    EXPECT_THAT(result.exit_code, testing::AnyOf(0, 1)) << result.err;
    EXPECT_THAT(result.err, HasSubstr("check of 11 poses"));
    EXPECT_EQ(result.exit_code == 1, result.err.find("does not hold") != std::string::npos) << result.err;
}

TEST_F(HardInput, coordinates_of_ten_kilometres_hold)
{
    std::string far = stacked(0.01, 0.02);
    far = far.substr(0, far.find("[[plane]]")) + far.substr(far.find("[[sheet]]"));
    const auto shift = [&](const std::string& from, const std::string& to) {
        far.replace(far.find(from), from.size(), to);
    };
    shift("columns = 9\nacross", "columns = 9\npins = [\"top\", \"bottom\"]\norigin = [10000.0, 10000.0, 0.0]\nacross");
    shift("origin = [0.03, 0.02, 0.04]", "origin = [10000.03, 10000.02, 0.04]");
    const ProgramResult result = guaranteed(far);
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace nuno
