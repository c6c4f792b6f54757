// Sweeps in parts as a user runs them: by hand, by GNU parallel and as the tasks of a job array; and what is missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;

// Words after the command and the scene of a small study whose results depend on nothing but themselves.
const std::vector<std::string> kSmall{"--coarse", "--method", "vbd", "--set", "resolution=3"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

ProgramResult measure(const fs::path& out, const std::vector<std::string>& more = {})
{
    return run_program(with(with({"stability", "seed", "--out", out.string(), "--quiet"}, kSmall), more));
}

// The lines of a store, in any order.
std::vector<std::string> points_in(const fs::path& directory)
{
    std::istringstream text(read_text(directory / "points.jsonl"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    std::sort(lines.begin(), lines.end());
    return lines;
}

Json report_of(const fs::path& directory) { return Json::parse(read_text(directory / "stability.json")); }

// Runs of a script of the tree, with this program.
ProgramResult run_script(const std::string& script, const std::vector<std::string>& words,
                         std::vector<std::string> environment = {})
{
    std::vector<std::string> all{NUNO_ROOT_DIR "/bench/" + script};
    environment.emplace_back("NUNO=" NUNO_PROGRAM);
    return run_words(with(std::move(all), words), environment);
}

class SweepParts : public testing::Test
{
  protected:
    static void SetUpTestSuite()
    {
        whole_ = new TemporaryDirectory;
        ASSERT_EQ(measure(whole_->path()).exit_code, 0);
    }
    static void TearDownTestSuite() { delete whole_; }

    static void expect_whole(const fs::path& joined)
    {
        EXPECT_EQ(points_in(joined), points_in(whole_->path()));
        EXPECT_EQ(report_of(joined), report_of(whole_->path()));
        EXPECT_TRUE(report_of(joined)["missing"].empty());
        EXPECT_TRUE(report_of(joined)["scenes"][0]["holds"].get<bool>());
    }

    static TemporaryDirectory* whole_;
    TemporaryDirectory directory_;
};
TemporaryDirectory* SweepParts::whole_ = nullptr;

TEST_F(SweepParts, by_gnu_parallel_join_to_the_whole_and_a_second_run_measures_nothing)
{
    const fs::path out = directory_.path() / "in parts";
    const std::vector<std::string> words = with({"3", out.string(), "stability", "seed"}, kSmall);
    const ProgramResult first = run_script("sweep.sh", words);
    ASSERT_EQ(first.exit_code, 0) << first.err << first.out;
    expect_whole(out / "whole");
    const std::vector<std::string> part = points_in(out / "part2");
    EXPECT_LT(part.size(), points_in(whole_->path()).size() / 2);
    const ProgramResult second = run_script("sweep.sh", words);
    EXPECT_EQ(second.exit_code, 0) << second.err;
    EXPECT_EQ(second.out, first.out);
    EXPECT_EQ(points_in(out / "part2"), part);
}

TEST_F(SweepParts, as_tasks_of_a_job_array_join_to_the_whole)
{
    const fs::path out = directory_.path() / "array";
    const std::vector<std::string> words = with({"2", out.string(), "stability", "seed"}, kSmall);
    for (const char* task : {"1", "2"}) {
        const ProgramResult part =
            run_script("sweep.sbatch", words, {std::string("SLURM_ARRAY_TASK_ID=") + task, "SLURM_CPUS_PER_TASK=1"});
        ASSERT_EQ(part.exit_code, 0) << part.err;
    }
    const ProgramResult joined =
        run_program({"merge", (out / "part1").string(), (out / "part2").string(), "--out", (out / "whole").string()});
    EXPECT_EQ(joined.exit_code, 0) << joined.err;
    expect_whole(out / "whole");
}

TEST_F(SweepParts, a_part_says_what_is_missing_and_not_that_all_holds)
{
    const fs::path part = directory_.path() / "part", joined = directory_.path() / "joined";
    const ProgramResult measured = measure(part, {"--shard", "1/4"});
    EXPECT_EQ(measured.exit_code, 0) << measured.err;
    EXPECT_THAT(measured.out, HasSubstr("points are missing"));
    const ProgramResult merged = run_program({"merge", part.string(), "--out", joined.string(), "--quiet"});
    EXPECT_EQ(merged.exit_code, 1);
    EXPECT_THAT(merged.err, AllOf(HasSubstr("points are missing"), HasSubstr("seed/"), HasSubstr(" more")));
    for (const fs::path& directory : {part, joined}) {
        const Json report = report_of(directory);
        EXPECT_TRUE(report["scenes"][0]["holds"].is_null());
        EXPECT_EQ(report["missing"].size() + points_in(directory).size(), points_in(whole_->path()).size());
        EXPECT_THAT(read_text(directory / "report.html"), HasSubstr("Not the whole sweep"));
    }
    // The same sweep goes on from there.
    EXPECT_EQ(measure(joined).exit_code, 0);
    expect_whole(joined);
}

TEST_F(SweepParts, what_is_not_of_this_program_is_not_joined)
{
    const fs::path old = directory_.path() / "old", other = directory_.path() / "other";
    fs::create_directory(old);
    fs::create_directory(other);
    write_whole(old / "points.jsonl", "{\"study\":\"trade\",\"version\":\"0.0.1 (none)\"}\n");
    write_whole(other / "points.jsonl", "{\"study\":\"compare\"}\n");
    const std::string out = (directory_.path() / "out").string();
    const ProgramResult of_old = run_program({"merge", old.string(), "--out", out});
    EXPECT_EQ(of_old.exit_code, 2);
    EXPECT_THAT(of_old.err, HasSubstr("0.0.1 (none)"));
    const ProgramResult of_other = run_program({"merge", other.string(), "--out", out});
    EXPECT_EQ(of_other.exit_code, 2);
    EXPECT_THAT(of_other.err, HasSubstr("compare"));
    EXPECT_FALSE(fs::exists(out));
}

TEST(SweepScripts, wrong_words_are_refused_with_what_would_be_right)
{
    const TemporaryDirectory directory;
    for (const char* parts : {"0", "some"}) {
        const ProgramResult result = run_script("sweep.sh", {parts, directory.path().string(), "trade"});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, HasSubstr("usage"));
    }
    EXPECT_EQ(run_script("sweep.sh", {"2", directory.path().string(), "render"}).exit_code, 2);
    EXPECT_EQ(run_script("sweep.sbatch", {"2", directory.path().string(), "trade"}).exit_code, 2) << "no task id";
    EXPECT_TRUE(fs::is_empty(directory.path()));
}

TEST(TradeCommand, a_reference_that_goes_bad_is_the_failure_of_its_points)
{
    const TemporaryDirectory directory;
    const fs::path out = directory.path() / "out";
    // It falls out of the space that nuno knows.
    const std::string scene = directory
                                  .write("far.toml",
                                         "[params]\ngravity_y = -1000.0\nbackend = \"cpu\"\n"
                                         "[[sheet]]\ncolumns = 3\norigin = [0.0, -999990.0, 0.0]\n")
                                  .string();
    const ProgramResult result = run_program({"trade", scene, "--out", out.string(), "--repeats", "1", "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json report = Json::parse(read_text(out / "trade.json"));
    const Json& time = report["scenes"][0]["time"];
    ASSERT_GT(time.size(), 5u);
    for (const Json& point : time) EXPECT_THAT(point["failure"].get<std::string>(), HasSubstr("no longer finite"));
    EXPECT_TRUE(report["missing"].empty());
    EXPECT_THAT(read_text(out / "report.html"), HasSubstr("went bad"));
}

}  // namespace
}  // namespace nuno
