// Uploads tethers.
#include "solver/base/gpu_tethers.h"

#include <glm/vec2.hpp>

#include "shaders/shared/bindings.h"

namespace nuno {

static_assert(kTethersPerVertex == 2, "sim/tethers.glsl reads two a vertex");

GpuTethers::GpuTethers() : anchors_(GL_RG32I), lengths_(GL_RG32F) {}

void GpuTethers::upload(std::span<const Tether> tethers)
{
    const auto vertex_count = static_cast<std::uint32_t>(tethers.size() / kTethersPerVertex);
    std::vector<glm::ivec2> anchors(vertex_count);
    std::vector<glm::vec2> lengths(vertex_count);
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        for (int k = 0; k < kTethersPerVertex; ++k) {
            const Tether& tether = tethers[static_cast<std::size_t>(k) * vertex_count + v];
            const bool none = tether.anchor == Tether::kNone;
            anchors[v][k] = static_cast<std::int32_t>(none ? v : tether.anchor);
            lengths[v][k] = tether.length;
        }
    anchor_buffer_ = make_buffer(anchors, GL_STATIC_DRAW);
    length_buffer_ = make_buffer(lengths, GL_STATIC_DRAW);
    anchors_.view(anchor_buffer_.id(), anchor_buffer_.size_bytes());
    lengths_.view(length_buffer_.id(), length_buffer_.size_bytes());
}

void GpuTethers::bind() const
{
    anchors_.bind(UNIT_ANCHORS);
    lengths_.bind(UNIT_TETHER_LENGTHS);
}

}  // namespace nuno
