// The header says how many samples follow, which is known at the end.
#include "model/point_cache.h"

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace nuno {
namespace {

static_assert(std::endian::native == std::endian::little, "PC2 holds little-endian numbers");

struct Header
{
    char magic[12] = "POINTCACHE2";
    std::int32_t version = 1;
    std::int32_t point_count = 0;
    float start_frame = 0;
    float sample_rate = 1;
    std::int32_t sample_count = 0;
};
static_assert(sizeof(Header) == 32);

}  // namespace

PointCache::PointCache(const std::filesystem::path& path, std::size_t point_count) : file_(path), sample_(point_count)
{
    Header header;
    header.point_count = static_cast<std::int32_t>(point_count);
    file_.append(std::as_bytes(std::span(&header, 1)));
}

void PointCache::add(std::span<const glm::vec4> positions)
{
    assert(positions.size() == sample_.size());
    for (std::size_t i = 0; i < sample_.size(); ++i) sample_[i] = positions[i];
    file_.append(std::as_bytes(std::span(sample_)));
    ++sample_count_;
}

void PointCache::finish()
{
    file_.rewrite(offsetof(Header, sample_count), std::as_bytes(std::span(&sample_count_, 1)));
    file_.commit();
}

}  // namespace nuno
