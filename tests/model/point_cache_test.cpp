// PC2 files: whole at any time, and bounded by no memory.
#include "model/point_cache.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

const std::vector<glm::vec4> kFirst{{1, 2, 3, 9}, {4, 5, 6, 9}}, kSecond{{7, 8, 9, 9}, {10, 11, 12, 9}};

TEST(PointCache, is_a_header_and_all_samples)
{
    const TemporaryDirectory directory;
    PointCache cache(directory.path() / "c.pc2", 2);
    cache.add(kFirst);
    cache.add(kSecond);
    cache.finish();
    const std::string bytes = read_text(directory.path() / "c.pc2");
    ASSERT_EQ(bytes.size(), 32u + 2 * 2 * 12);
    EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    std::int32_t numbers[5];
    std::memcpy(numbers, bytes.data() + 12, sizeof numbers);
    EXPECT_EQ(numbers[0], 1);
    EXPECT_EQ(numbers[1], 2);
    EXPECT_EQ(numbers[4], 2);
    float points[12];
    std::memcpy(points, bytes.data() + 32, sizeof points);
    for (int i = 0; i < 12; ++i) EXPECT_EQ(points[i], float(i + 1));
}

TEST(PointCache, samples_are_on_the_disk_before_the_end_and_under_the_name_only_then)
{
    const TemporaryDirectory directory;
    const auto path = directory.path() / "c.pc2";
    write_whole(path, "old");
    {
        PointCache cache(path, 2);
        cache.add(kFirst);
        EXPECT_EQ(read_text(path), "old");
        std::uintmax_t written = 0;
        for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
            if (entry.path() != path) written += entry.file_size();
        EXPECT_EQ(written, 32u + 2 * 12);
    }
    EXPECT_EQ(read_text(path), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);
}

}  // namespace
}  // namespace nuno
