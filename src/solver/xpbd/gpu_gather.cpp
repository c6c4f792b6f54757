// Uploads springs that are projected all at once, and runs passes over them.
#include "solver/xpbd/gpu_gather.h"

#include <string>

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"
#include "solver/base/slot_quads.h"

namespace nuno {

GpuGather::GpuGather(std::uint32_t vertex_count)
    : vertex_count_(vertex_count),
      passed_(vertex_count),
      neighbours_(GL_RGBA32I),
      share_(GL_RGBA32F),
      share_length_(GL_RGBA32F),
      limit_(GL_RGBA32F),
      limit_length_(GL_RGBA32F)
{
}

void GpuGather::upload(const JacobiSprings& springs)
{
    const auto quads = [&](const std::vector<float>& slots) { return in_quads<float>(slots, vertex_count_); };
    neighbours_.upload(in_quads<std::int32_t>(springs.neighbours, vertex_count_));
    share_.upload(quads(springs.share));
    share_length_.upload(quads(springs.share_length));
    limit_.upload(quads(springs.limit));
    limit_length_.upload(quads(springs.limit_length));
    const int quad_count = springs.slot_count / 4;
    const bool limited = !springs.limit.empty();
    if (quad_count == quad_count_ && limited == limited_) return;
    quad_count_ = quad_count;
    limited_ = limited;
    program_ = compute_program("sim/xpbd_gather.comp",
                               {{"SPRING_QUADS", std::to_string(quad_count)}, {"LIMITED", limited ? "1" : "0"}});
    program_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
}

void GpuGather::run(int passes, const VertexBuffer& positions) const
{
    program_.use();
    neighbours_.bind(UNIT_NEIGHBOURS);
    share_.bind(UNIT_PULL);
    share_length_.bind(UNIT_PULL_LENGTH);
    limit_.bind(UNIT_LIMIT_PULL);
    limit_length_.bind(UNIT_LIMIT_PULL_LENGTH);
    for (int pass = 0; pass < passes; ++pass) {
        const bool there = pass % 2 == 0;
        (there ? positions : passed_).texture.bind(UNIT_POSITIONS);
        (there ? passed_ : positions).buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITIONS);
        glDispatchCompute((vertex_count_ + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1);
        barrier_compute_to_compute();
    }
}

}  // namespace nuno
