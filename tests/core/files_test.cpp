// Files are whole or not there.
#include "core/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <vector>

#include "core/error.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& directory)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory)) names.push_back(entry.path().filename().string());
    return names;
}

TEST(Files, a_text_written_is_read_back_and_no_other_file_is_left)
{
    const TemporaryDirectory directory;
    write_whole(directory.path() / "a.txt", "first");
    write_whole(directory.path() / "a.txt", "second");
    EXPECT_EQ(read_text(directory.path() / "a.txt"), "second");
    EXPECT_EQ(names_in(directory.path()), std::vector<std::string>{"a.txt"});
}

TEST(Files, a_disk_that_fills_leaves_the_old_file_whole)
{
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "frame.png";
    write_whole(path, "old");
    // A limit on the size of files fails a write half way, as a full disk does.
    rlimit before{}, limit{};
    getrlimit(RLIMIT_FSIZE, &before);
    limit = before;
    limit.rlim_cur = 1000;
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_THROW(write_whole(path, std::string(5000, 'x')), Error);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(read_text(path), "old");
    EXPECT_EQ(names_in(directory.path()), std::vector<std::string>{"frame.png"});
}

TEST(Files, a_link_stays_a_link_and_a_device_a_device)
{
    const TemporaryDirectory directory;
    write_whole(directory.path() / "real", "old");
    fs::create_symlink("real", directory.path() / "link");
    write_whole(directory.path() / "link", "new");
    EXPECT_TRUE(fs::is_symlink(directory.path() / "link"));
    EXPECT_EQ(read_text(directory.path() / "real"), "new");
    fs::create_symlink("/dev/null", directory.path() / "null");
    write_whole(directory.path() / "null", "gone");
    EXPECT_TRUE(fs::is_character_file(directory.path() / "null"));
}

TEST(Files, a_place_that_cannot_be_written_is_named)
{
    const TemporaryDirectory directory;
    directory.write("file", "in the way");
    for (const fs::path& path : {directory.path() / "missing" / "a.txt", directory.path() / "file" / "a.txt"}) {
        try {
            write_whole(path, "text");
            ADD_FAILURE() << path;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(path.string()));
        }
    }
    EXPECT_THROW(make_writable_directory(directory.path() / "file"), Error);
    EXPECT_THROW(read_text(directory.path()), Error);
    EXPECT_THROW(read_text(directory.path() / "missing"), Error);
}

}  // namespace
}  // namespace nuno
