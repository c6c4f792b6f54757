// Tables and vectors on the device.
#include "solver/base/gpu_table.h"

#include <algorithm>

#include <glm/vec4.hpp>

namespace nuno {
namespace {

constexpr std::size_t kLargestTexel = 16;  // [bytes]; a view of nothing is none

}  // namespace

void GpuTable::upload(std::span<const std::byte> values)
{
    if (const std::size_t bytes = std::max(values.size(), kLargestTexel); buffer_.size_bytes() < bytes) {
        buffer_ = Buffer(bytes, nullptr, GL_DYNAMIC_DRAW);
        texture_.view(buffer_.id(), bytes);
    }
    buffer_.update(0, values);
}

VertexBuffer::VertexBuffer(std::size_t vertex_count)
    : buffer(vertex_count * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY), texture(GL_RGBA32F)
{
    texture.view(buffer.id(), buffer.size_bytes());
}

}  // namespace nuno
