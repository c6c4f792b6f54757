// The command line is the one that docs/cli.md tells, and every command that a page shows is accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "core/params.h"
#include "meta/markdown.h"
#include "meta/tree.h"
#include "model/sim_params.h"
#include "render/view_params.h"
#include "support/program_run.h"

namespace nuno::meta {
namespace {

using Words = std::vector<std::string>;

bool holds(const Words& words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

// The commands that `nuno --help` lists, each with the flags that its own --help lists.
std::map<std::string, Words> program_flags()
{
    std::map<std::string, Words> flags;
    const std::string help = run_program({"--help"}).out;
    std::istringstream list(help.substr(help.find("Subcommands:")));
    std::string line;
    std::getline(list, line);
    while (std::getline(list, line) && !line.empty()) {
        std::istringstream words(line);
        std::string command;
        words >> command;
        flags[command] = flags_in(run_program({command, "--help"}).out);
    }
    return flags;
}

TEST(CommandLine, flags_are_found_in_a_text)
{
    EXPECT_EQ(flags_in("`--b-c FILE` --a --a=1 x--y -d\n--e"), (Words{"--a", "--b-c", "--e"}));
}

// A heading that names commands in `backticks` says whose flags its section tells.
TEST(CommandLine, the_page_names_every_flag_of_every_command_and_no_other)
{
    const std::map<std::string, Words> program = program_flags();
    ASSERT_GE(program.size(), 5u);
    std::map<std::string, Words> page;
    for (const Section& section : sections(read_file("docs/cli.md"))) {
        const Words told = flags_in(section.text);
        for (const std::string& word : code_words(section.heading)) {
            const std::string command = word.substr(0, word.find(' '));
            ASSERT_TRUE(program.contains(command)) << "docs/cli.md, heading " << section.heading;
            page[command].insert(page[command].end(), told.begin(), told.end());
            for (const std::string& flag : told)
                EXPECT_TRUE(holds(program.at(command), flag)) << "nuno " << command << " does not take " << flag;
        }
    }
    for (const auto& [command, flags] : program)
        for (const std::string& flag : flags)
            EXPECT_TRUE(holds(page[command], flag)) << "docs/cli.md does not tell " << flag << " of " << command;
}

bool is_param(std::string_view name)
{
    return find_param(sim_param_table(), name) || find_param(view_param_table(), name);
}

TEST(CommandLine, every_command_that_a_page_shows_is_accepted)
{
    const std::map<std::string, Words> program = program_flags();
    int count = 0;
    for (const std::string& page : pages())
        for (const Command& command : commands(read_file(page))) {
            ++count;
            const std::string where = page + ": " + command.line;
            const std::string& name = command.words.front();
            if (name.starts_with("--")) continue;
            ASSERT_TRUE(program.contains(name)) << where;
            for (const std::string& flag : flags_in(command.line)) EXPECT_TRUE(holds(program.at(name), flag)) << where;
            for (std::size_t i = 0; i + 1 < command.words.size(); ++i) {
                if (command.words[i] != "--set") continue;
                const std::string& set = command.words[i + 1];
                EXPECT_TRUE(is_param(set.substr(0, set.find('=')))) << where;
            }
        }
    EXPECT_GT(count, 20);
}

TEST(CommandLine, commands_are_found_with_their_continued_lines)
{
    const std::vector<Command> found = commands("```sh\nnuno a --b \\\n   --c  # why\n./test\n./run d\n```\nnuno e\n");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].words, (Words{"a", "--b", "--c"}));
    EXPECT_EQ(found[1].words, (Words{"d"}));
}

}  // namespace
}  // namespace nuno::meta
