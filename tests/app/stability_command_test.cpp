// `nuno stability` as a user runs it: what it writes, that it goes on where it was, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

ProgramResult stability(const std::string& scene, const fs::path& out, const std::vector<std::string>& more = {})
{
    std::vector<std::string> words{"stability", scene, "--out", out.string(),   "--coarse",
                                   "--method",  "vbd", "--set", "resolution=3", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
}

TEST(StabilityCommand, writes_data_pictures_and_a_page_and_measures_nothing_twice)
{
    const TemporaryDirectory directory;
    const fs::path out = directory.path() / "out", json = directory.path() / "copy.json";
    const ProgramResult first = stability("seed", out, {"--threads", "2", "--json", json.string()});
    ASSERT_EQ(first.exit_code, 0) << first.err << first.out;
    EXPECT_THAT(first.out, AllOf(HasSubstr("vbd"), HasSubstr("0 lost numbers unseen, 0 hangs, 0 crashes")));
    EXPECT_EQ(first.err, "");
    for (const char* name : {"points.jsonl", "stability.csv", "stability.json", "report.html"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
    EXPECT_TRUE(nlohmann::json::parse(read_text(json))["scenes"][0]["holds"].get<bool>());

    const std::string points = read_text(out / "points.jsonl");
    const ProgramResult second = stability("seed", out, {"--threads", "1"});
    EXPECT_EQ(second.exit_code, 0);
    EXPECT_EQ(second.out, first.out);
    EXPECT_EQ(read_text(out / "points.jsonl"), points);

    write_whole(out / "points.jsonl", points.substr(0, points.size() - 20));
    const ProgramResult third = stability("seed", out);
    EXPECT_EQ(third.out, first.out);
    EXPECT_EQ(read_text(out / "points.jsonl"), points);
}

void expect_refused(const ProgramResult& result, const std::string& message)
{
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(result.out, "");
}

TEST(StabilityCommand, what_is_wrong_is_said_before_the_work)
{
    const TemporaryDirectory directory;
    const fs::path out = directory.path() / "out";
    expect_refused(stability("sead", out), "nearest is seed");
    expect_refused(stability("seed", directory.write("file", "text")), "file");
    expect_refused(stability("seed", out, {"--shard", "3/2"}), "--shard 3/2");
    expect_refused(stability("seed", out, {"--set", "stiffness_damping=0.1", "--method", "xpbd"}), "no method");
    directory.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_refused(stability(directory.write("mesh.toml", "[[sheet]]\nmesh = \"sheet.obj\"\n").string(), out),
                   "a sheet that is a mesh");
    const std::string pins = "pins = [\"top\", \"bottom\"]\n";
    expect_refused(stability(directory.write("held.toml", "[[sheet]]\ncolumns = 2\n" + pins).string(), out,
                             {"--set", "resolution=2"}),
                   "nothing moves");
    EXPECT_FALSE(fs::exists(out / "points.jsonl"));
}

TEST(StabilityCommand, points_of_another_sweep_are_refused_and_kept)
{
    const TemporaryDirectory directory;
    const fs::path other = directory.write("points.jsonl", "{\"study\":\"other\"}\n");
    expect_refused(stability("seed", directory.path()), "points are of another sweep");
    EXPECT_EQ(read_text(other), "{\"study\":\"other\"}\n");
    directory.write("points.jsonl", "no point\n");
    expect_refused(stability("seed", directory.path()), "points.jsonl:1: is no point");
}

TEST(StabilityCommand, an_interrupt_leaves_whole_points_and_a_report_of_them)
{
    const TemporaryDirectory directory;
    const std::vector<std::string> words{"stability", "seed",  "--out",        directory.path().string(),
                                         "--coarse",  "--set", "resolution=5", "--quiet"};
    ProgramLimits limits;
    limits.interrupt_at = directory.path() / "points.jsonl";
    const ProgramResult result = run_program(words, {}, limits);
    EXPECT_EQ(result.exit_code, 130) << result.err;
    const std::string text = read_text(directory.path() / "points.jsonl");
    EXPECT_EQ(text.back(), '\n');
    EXPECT_TRUE(fs::exists(directory.path() / "report.html"));
}

}  // namespace
}  // namespace nuno
