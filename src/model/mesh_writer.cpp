// Writes meshes in motion.
#include "model/mesh_writer.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "core/files.h"

namespace nuno {
namespace {

static_assert(std::endian::native == std::endian::little, "PC2 holds little-endian numbers");

struct Pc2Header
{
    char magic[12] = "POINTCACHE2";
    std::int32_t version = 1;
    std::int32_t point_count = 0;
    float start_frame = 0;
    float sample_rate = 1;
    std::int32_t sample_count = 0;
};
static_assert(sizeof(Pc2Header) == 32);

}  // namespace

std::string obj_text(const MeshView& mesh)
{
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "# nuno\n");
    for (const glm::vec4& p : mesh.positions) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    for (const glm::vec2& uv : mesh.uvs) fmt::format_to(out, "vt {:.9g} {:.9g}\n", uv.x, uv.y);
    for (const glm::uvec3& f : mesh.faces) {
        if (mesh.uvs.empty())
            fmt::format_to(out, "f {} {} {}\n", f.x + 1, f.y + 1, f.z + 1);
        else
            fmt::format_to(out, "f {0}/{0} {1}/{1} {2}/{2}\n", f.x + 1, f.y + 1, f.z + 1);
    }
    return fmt::to_string(text);
}

std::string ply_text(const MeshView& mesh)
{
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "ply\nformat ascii 1.0\ncomment nuno\nelement vertex {}\nproperty float x\nproperty float y\n"
                   "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
                   mesh.positions.size(), mesh.faces.size());
    for (const glm::vec4& p : mesh.positions) fmt::format_to(out, "{:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    for (const glm::uvec3& f : mesh.faces) fmt::format_to(out, "3 {} {} {}\n", f.x, f.y, f.z);
    return fmt::to_string(text);
}

void PointCache::add(std::span<const glm::vec4> positions)
{
    for (const glm::vec4& p : positions) samples_.emplace_back(p);
}

void PointCache::write(const std::filesystem::path& path) const
{
    Pc2Header header;
    header.point_count = static_cast<std::int32_t>(point_count_);
    header.sample_count = static_cast<std::int32_t>(point_count_ ? samples_.size() / point_count_ : 0);
    std::vector<std::byte> bytes(sizeof header + samples_.size() * sizeof(glm::vec3));
    std::memcpy(bytes.data(), &header, sizeof header);
    if (!samples_.empty())
        std::memcpy(bytes.data() + sizeof header, samples_.data(), samples_.size() * sizeof(glm::vec3));
    write_whole(path, bytes);
}

}  // namespace nuno
