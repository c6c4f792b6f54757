// Uploads tethers.
#include "solver/base/gpu_tethers.h"

#include <glm/vec2.hpp>

#include "shaders/shared/bindings.h"

namespace nuno {

static_assert(kTethersPerVertex == 2, "sim/tethers.glsl reads two a vertex");

GpuTethers::GpuTethers(const ClothModel& model) : pins_(model), anchors_(GL_RG32I), lengths_(GL_RG32F) {}

bool GpuTethers::refresh(const SimParams& params)
{
    const bool had_any = pins_.any();
    if (!pins_.refresh(params) || !pins_.any()) return pins_.any() != had_any;
    const std::vector<Tether>& tethers = pins_.tethers();
    const std::size_t vertex_count = tethers.size() / kTethersPerVertex;
    std::vector<glm::ivec2> anchors(vertex_count);
    std::vector<glm::vec2> lengths(vertex_count);
    for (std::size_t v = 0; v < vertex_count; ++v)
        for (int k = 0; k < kTethersPerVertex; ++k) {
            const Tether& tether = tethers[static_cast<std::size_t>(k) * vertex_count + v];
            anchors[v][k] = static_cast<std::int32_t>(tether.anchor == Tether::kNone ? v : tether.anchor);
            lengths[v][k] = tether.length;
        }
    anchors_.upload(anchors);
    lengths_.upload(lengths);
    return !had_any;
}

std::vector<Define> GpuTethers::defines() const { return {{"TETHERED", pins_.any() ? "1" : "0"}}; }

void GpuTethers::bind() const
{
    if (!pins_.any()) return;
    anchors_.bind(UNIT_ANCHORS);
    lengths_.bind(UNIT_TETHER_LENGTHS);
}

}  // namespace nuno
