// The program ccd_queries: what it answers, in which forms it takes numbers, and what it says to a bad line.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <regex>

#include <fmt/format.h>

#include "collision/ccd/query_file.h"
#include "core/error.h"
#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

ProgramResult run_queries(const std::string& arguments)
{
    const TemporaryDirectory directory;
    const std::string out = (directory.path() / "out").string(), err = (directory.path() / "err").string();
    const std::string command = fmt::format("'{}' {} >'{}' 2>'{}'", NUNO_CCD_QUERIES, arguments, out, err);
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
}

ProgramResult answers_to(const std::string& text)
{
    const TemporaryDirectory directory;
    return run_queries(fmt::format("'{}'", directory.write("queries.txt", text).string()));
}

const std::string kStill = "0 0 0  1 0 0  0 1 0";  // a face that does not move

// A vertex with this x that falls through the height of the face.
std::string falling(const std::string& x) { return fmt::format(" {0} 0.25 1 {1} {0} 0.25 -1 {1}", x, kStill); }

TEST(CcdQueries, answers_each_line)
{
    const ProgramResult run =
        answers_to(fmt::format("# a comment\nfirst vf{}\nbeside vf{}\nedges ee {} {}\n", falling("0.25"),
                               falling("0.8"), "0 -1 0  0 1 0  -1 0 0  1 0 0", "0 -1 0  0 1 0  -1 0 0  1 0 0"));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::regex lines("first,1,(0\\.[0-9]+)\nbeside,0,\nedges,1,0\n");
    std::smatch match;
    ASSERT_TRUE(std::regex_match(run.out, match, lines)) << run.out;
    EXPECT_NEAR(std::stod(match[1]), 0.5, 1e-9);
    EXPECT_TRUE(std::regex_match(run.err, std::regex("mean microseconds a query: [0-9.]+\n"))) << run.err;
}

TEST(CcdQueries, takes_every_form_of_number_and_of_line_end)
{
    const ProgramResult run =
        answers_to(fmt::format("\n   \na vf{}\r\n\tb\tvf{}  \r\n\r\nc vf{}\nd vf{}\n#e vf\ne vf{}", falling("0.25"),
                               falling("2.5e-1"), falling("0x1p-2"), falling("+0X.4P0"), falling("25E-2")));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::regex lines("a,1,(.+)\nb,1,(.+)\nc,1,(.+)\nd,1,(.+)\ne,1,(.+)\n");
    std::smatch match;
    ASSERT_TRUE(std::regex_match(run.out, match, lines)) << run.out;
    for (int i = 2; i <= 5; ++i) EXPECT_EQ(match[i], match[1]);
}

TEST(CcdQueries, answers_for_a_separation)
{
    const TemporaryDirectory directory;
    const std::string file = directory.write("queries.txt", fmt::format("a vf{}\n", falling("0.25"))).string();
    const ProgramResult run = run_queries(fmt::format("'{}' 0.5", file));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    ASSERT_TRUE(run.out.starts_with("a,1,")) << run.out;
    EXPECT_NEAR(std::stod(run.out.substr(4)), 0.25, 1e-3);
    for (const std::string separation : {"-1", "far", "nan", ""}) {
        const ProgramResult bad = run_queries(fmt::format("'{}' '{}'", file, separation));
        EXPECT_EQ(bad.exit_code, 2) << separation;
        EXPECT_EQ(bad.err, fmt::format("ccd_queries: separation '{}' is no length, a number that is not negative\n",
                                       separation));
    }
}

TEST(CcdQueries, has_no_answers_to_an_empty_file)
{
    const ProgramResult run = answers_to("# nothing\n");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.out, "");
}

void expect_complaint(const std::string& bad_line, const std::string& expected)
{
    const ProgramResult run = answers_to(fmt::format("# one\ngood vf{}\n{}\n", falling("0.25"), bad_line));
    EXPECT_EQ(run.exit_code, 2) << bad_line;
    EXPECT_EQ(run.out, "") << bad_line;
    EXPECT_TRUE(
        std::regex_match(run.err, std::regex(fmt::format("ccd_queries: [^\n]*queries\\.txt:3: {}\n", expected))))
        << run.err;
}

TEST(CcdQueries, names_file_and_line_of_what_it_does_not_understand)
{
    expect_complaint(fmt::format("x fv{}", falling("0.25")), "the second word is 'fv', not vf or ee");
    expect_complaint("x", "the second word is '', not vf or ee");
    expect_complaint("x vf 1 2 3", "3 numbers after the kind, where there must be 24");
    expect_complaint(fmt::format("x vf{} 7", falling("0.25")), "more than 24 numbers after the kind");
    for (const std::string number : {"1,5", "0.25x", "0x", "--1", "+-1", "nan", "inf", "1e999", "-"})
        expect_complaint(fmt::format("x vf{}", falling(number)), "'[^\n]*' is no finite number of double precision");
}

TEST(CcdQueries, says_what_it_cannot_read_and_how_it_is_used)
{
    const ProgramResult missing = run_queries("/nowhere/queries.txt");
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_EQ(missing.err, "ccd_queries: /nowhere/queries.txt: cannot be read\n");
    EXPECT_EQ(run_queries("/").exit_code, 2);
    EXPECT_EQ(run_queries("").exit_code, 2);
    EXPECT_EQ(run_queries("a b c").exit_code, 2);
}

TEST(CcdQueries, reads_the_least_numbers)
{
    const TemporaryDirectory directory;
    const std::string line = "x vf 5e-324 -0x1p-1074 1e-400 -1.7976931348623157e308 0 0 0 0 0 0 0 0" +
                             std::string(" 0 0 0 0 0 0 0 0 0 0 0 0\n");
    const auto read = [&] { return read_query_file(directory.write("least.txt", line)); };
    try {
        const std::vector<FileQuery> queries = read();
        ASSERT_EQ(queries.size(), 1u);
        EXPECT_EQ(queries[0].t0[0].x, 5e-324);
        EXPECT_EQ(queries[0].t0[0].y, -5e-324);
        EXPECT_EQ(queries[0].t0[0].z, 0);
        EXPECT_EQ(queries[0].t0[1].x, -1.7976931348623157e308);
    } catch (const Error& error) {
        FAIL() << error.what();
    }
}

}  // namespace
}  // namespace nuno
