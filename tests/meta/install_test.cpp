// What `cmake --install` leaves works by itself, and the man page and the completion know all that the program does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "meta/markdown.h"
#include "model/sim_params.h"
#include "render/view_params.h"
#include "support/program_run.h"

namespace nuno::meta {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// The installed program, and its share/nuno.
struct Installed
{
    explicit Installed(const fs::path& prefix)
    {
        const ProgramResult result = run_words({NUNO_CMAKE, "--install", NUNO_BUILD_DIR, "--prefix", prefix.string()});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        program = prefix / "bin" / "nuno";
        share = prefix / "share" / "nuno";
    }
    fs::path program, share;
};

TEST(Install, the_program_takes_scenes_and_shaders_from_beside_it)
{
    const TemporaryDirectory directory;
    const Installed installed(directory.path());
    for (const fs::directory_entry& scene : fs::directory_iterator(installed.share / "assets" / "scenes"))
        if (scene.path().stem() != "seed") fs::remove(scene.path());
    const ProgramResult listed = run_words({installed.program.string(), "scenes"}, {"NUNO_ROOT="});
    EXPECT_EQ(std::count(listed.out.begin(), listed.out.end(), '\n'), 1) << listed.out;
    EXPECT_TRUE(listed.out.starts_with("seed ")) << listed.out;

    const std::string out = (directory.path() / "frames").string();
    const std::vector<std::string> words{installed.program.string(), "render", "seed", "--frames", "2", "--out", out};
    const ProgramResult drawn = run_words(words, {"NUNO_ROOT="});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_TRUE(fs::exists(fs::path(out) / "frame_00001.png"));
    fs::remove_all(installed.share / "shaders");
    EXPECT_EQ(run_words(words, {"NUNO_ROOT="}).exit_code, 2);
}

TEST(Install, the_man_page_and_the_completion_stand_where_man_and_bash_look)
{
    const TemporaryDirectory directory;
    const Installed installed(directory.path());
    const fs::path share = installed.share.parent_path();
    const ProgramResult page = run_words({"gzip", "-dc", (share / "man" / "man1" / "nuno.1.gz").string()});
    EXPECT_EQ(page.out, run_program({"manual"}).out);
    const fs::path completion = share / "bash-completion" / "completions" / "nuno";
    EXPECT_EQ(run_words({"cat", completion.string()}).out, run_program({"completion"}).out);
}

// man(7) has hyphens as \-.
std::string read_page(std::string text)
{
    for (std::size_t at = text.find("\\-"); at != text.npos; at = text.find("\\-", at)) text.erase(at, 1);
    return text;
}

TEST(Manual, names_every_command_flag_and_parameter)
{
    const std::string page = read_page(run_program({"manual"}).out);
    for (const std::string command : {"view", "render", "trade", "manual"}) {
        EXPECT_THAT(page, HasSubstr(".SS nuno " + command));
        for (const std::string& flag : flags_in(run_program({command, "--help"}).out)) {
            if (flag == "--help") continue;
            EXPECT_THAT(page, HasSubstr(".B " + flag));
        }
    }
    for (const ParamTable table : {sim_param_table(), view_param_table()})
        for (const ParamInfo& info : table) EXPECT_THAT(page, HasSubstr(".B " + std::string(info.name) + "\n"));
}

// What bash proposes for the last of `words`.
std::string proposed(const TemporaryDirectory& directory, const std::string& words, int last)
{
    const fs::path script = directory.write("nuno.bash", run_program({"completion"}).out);
    const std::string program = fs::path(NUNO_PROGRAM).parent_path().string();
    const std::string text = "set -u; PATH='" + program + "':$PATH; compopt() { :; }; source '" + script.string() +
                             "'; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(last) +
                             "; _nuno; echo ${COMPREPLY[@]}";
    const ProgramResult result = run_words({"bash", "-c", text});
    EXPECT_EQ(result.err, "");
    return result.out;
}

TEST(Completion, proposes_commands_flags_scenes_parameters_and_choices)
{
    const TemporaryDirectory directory;
    EXPECT_EQ(proposed(directory, "nuno sta", 1), "stability\n");
    EXPECT_EQ(proposed(directory, "nuno render --vid", 2), "--video\n");
    EXPECT_EQ(proposed(directory, "nuno view curt", 2), "curtain\n");
    EXPECT_EQ(proposed(directory, "nuno render --set wind_str", 3), "wind_strength=\n");
    EXPECT_EQ(proposed(directory, "nuno render --set method = sdi", 5), "sdirk2\n");
    EXPECT_EQ(proposed(directory, "nuno render --set backend = ''", 5), "cpu gpu\n");
    EXPECT_EQ(proposed(directory, "nuno render --set backend =", 4), "cpu gpu\n");
    EXPECT_EQ(proposed(directory, "nuno view --collision gu", 3), "guaranteed\n");
}

}  // namespace
}  // namespace nuno::meta
