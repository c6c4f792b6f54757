// Frames written beside the main thread: all of them, in order, whole; and an error comes back to the one who pushed.
#include "render/frame_writer.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/temporary_folder.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

Picture filled(std::uint8_t value) { return {16, 8, std::vector<std::uint8_t>(4 * 16 * 8, value)}; }

std::size_t file_count(const std::filesystem::path& folder)
{
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(FrameWriter, writes_every_frame_whole)
{
    const TemporaryFolder folder;
    FrameWriter writer;
    for (int i = 0; i < 10; ++i)
        writer.push(folder / ("frame" + std::to_string(i) + ".png").c_str(), filled(std::uint8_t(i)));
    writer.finish();
    EXPECT_EQ(file_count(folder / ""), 10u);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(load_picture(folder / ("frame" + std::to_string(i) + ".png").c_str(), 64).rgba[0], i);
    EXPECT_EQ(writer.encode_ms().size(), 10u);
}

TEST(FrameWriter, a_destroyed_writer_has_written_what_was_pushed)
{
    const TemporaryFolder folder;
    {
        FrameWriter writer;
        writer.push(folder / "a.png", filled(1));
        writer.push(folder / "b.png", filled(2));
    }
    EXPECT_EQ(file_count(folder / ""), 2u);
}

TEST(FrameWriter, finish_tells_of_a_frame_that_could_not_be_written)
{
    FrameWriter writer;
    writer.push("/proc/nowhere/frame.png", filled(0));
    try {
        writer.finish();
        FAIL() << "no error came back";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("/proc/nowhere/frame.png"), 0u) << error.what();
    }
}

TEST(FrameWriter, no_frame_is_written_after_one_that_could_not_be)
{
    const TemporaryFolder folder;
    FrameWriter writer;
    writer.push("/proc/nowhere/frame.png", filled(0));
    EXPECT_THROW(writer.finish(), Error);
    EXPECT_THROW(writer.push(folder / "later.png", filled(0)), Error);
    EXPECT_THROW(writer.finish(), Error);
    EXPECT_EQ(file_count(folder / ""), 0u);
}

TEST(FrameWriter, pushing_on_after_an_error_throws_before_long)
{
    FrameWriter writer;
    EXPECT_THROW(for (int i = 0; i < 100; ++i) writer.push("/proc/nowhere/frame.png", filled(0)), Error);
}

}  // namespace
}  // namespace nuno
