// Copies the state into one buffer, and runs substeps on it.
#include "solver/xpbd/gpu_one_group.h"

#include <algorithm>
#include <span>
#include <string>

#include "gl/barriers.h"
#include "gl/context.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"

namespace nuno {
namespace {

// Invocations of a group. In a cloth of GpuSprings::kSmallVertices, 64 x 64, a few colours are 1024 quads
// (spring_quads.h) or less, which 1024 invocations, as many as a group may have on every device, take at once. A
// hardware device then works on one multiprocessor alone, but a barrier of that is waited for less long than a
// dispatch, and there are 13 a substep otherwise; that is reasoned, not measured. Measured on software: one group is
// one thread, and no others need be woken. With few invocations it is fastest, since eight of them are a coroutine
// that every barrier switches. A substep of 24 x 24 or 32 x 32 vertices takes 0.4 times as long as with dispatches for
// the motion and one for all sweeps, one of 64 x 64 between 0.3 and 0.9 times as long as with a dispatch for every few
// colours, and one of 96 x 96 would take longer.
int group_size() { return gl_info().software ? 64 : 1024; }

// Of all loops of an invocation together: after 65535, llvmpipe ends them without a word.
constexpr int kMostTurns = 32768;
constexpr int kMostSubsteps = 256;  // of a dispatch, which a display waits for

int turns(std::int32_t count, int group) { return (count + group - 1) / group; }

}  // namespace

GpuOneGroup::GpuOneGroup(std::uint32_t vertex_count)
    : vertex_count_(vertex_count), group_(group_size()), state_(std::size_t{5} * vertex_count), commons_(GL_RGBA32F)
{
}

void GpuOneGroup::compile(const GpuSprings& springs, const std::vector<Define>& motion)
{
    const std::vector<Define> own{{"SMALL_GROUP", std::to_string(group_)},
                                  {"LIMITED", springs.limited() ? "1" : "0"},
                                  {"MOST_COLOURS", std::to_string(springs.most_colours())}};
    substeps_ = gpu_program("sim/xpbd_small.comp", {motion, own});
    substeps_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    sweep_ = compute_program("sim/xpbd_sweep_small.comp", own);
}

int GpuOneGroup::turns_of_pair(const GpuSprings& springs) const
{
    int sum = 1;
    for (const QuadGroup& group : springs.groups()) sum += 2 * (1 + turns(group.count, group_));
    return sum + 2;
}

int GpuOneGroup::most_substeps(const Work& work) const
{
    const int of_vertex = 2 + work.bodies.bodies_a_substep();  // its own, and those of the loop over bodies
    const int of_motion = 2 * turns(static_cast<std::int32_t>(vertex_count_), group_) * of_vertex;
    const std::int64_t all = 2 + of_motion + std::int64_t(work.pairs) * turns_of_pair(work.springs);
    return static_cast<int>(std::min<std::int64_t>(kMostTurns / all, kMostSubsteps));
}

void GpuOneGroup::copy(const Sides& sides, bool back) const
{
    const std::size_t row = vertex_count_ * sizeof(glm::vec4);
    std::size_t at = 0;
    for (const auto* const both : {&sides.positions, &sides.velocities})
        for (const VertexBuffer& side : *both) {
            if (back)
                state_.buffer.copy_to(at, side.buffer, 0, row);
            else
                side.buffer.copy_to(0, state_.buffer, at, row);
            at += row;
        }
}

void GpuOneGroup::run(const Sides& sides, const Work& work, const std::vector<glm::vec4>& commons)
{
    barrier_compute_to_upload();
    copy(sides, false);
    state_.texture.bind_image(IMAGE_STATE);
    state_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_STATE);
    sides.positions[std::size_t(sides.from)].texture.bind(UNIT_POSITIONS);  // where tethers find their ends
    substeps_.use();
    substeps_.set(LOCATION_SUBSTEP, work.times.h);
    substeps_.set(LOCATION_STEP, work.times.step);
    substeps_.set(LOCATION_KEEP, work.times.keep);
    substeps_.set(LOCATION_PER_STEP, work.times.per_step);
    substeps_.set(LOCATION_PAIR_COUNT, work.pairs);
    substeps_.set(LOCATION_BODIES_A_SUBSTEP, work.bodies.bodies_a_substep());
    substeps_.set(LOCATION_GROUP_COUNT, work.springs.bind_groups());
    const auto most = static_cast<std::size_t>(most_substeps(work));
    for (std::size_t first = 0; first < commons.size(); first += most) {
        const std::size_t count = std::min(most, commons.size() - first);
        commons_.upload(std::as_bytes(std::span(commons).subspan(first, count)));
        commons_.bind(UNIT_COMMON);
        substeps_.set(LOCATION_SUBSTEP_COUNT, static_cast<std::int32_t>(count));
        substeps_.set(LOCATION_FIRST_SIDE, static_cast<std::int32_t>((std::size_t(sides.from) + first) % 2));
        work.bodies.set_substep(substeps_, static_cast<int>(first));
        glDispatchCompute(1, 1, 1);
        barrier_compute_to_compute();
    }
    barrier_compute_to_upload();
    copy(sides, true);
}

void GpuOneGroup::sweep(const GpuSprings& springs, int pairs, const VertexBuffer& positions) const
{
    positions.texture.bind_image(IMAGE_STATE);
    positions.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_STATE);
    sweep_.use();
    sweep_.set(LOCATION_GROUP_COUNT, springs.bind_groups());
    const int most = std::max(kMostTurns / turns_of_pair(springs), 1);
    for (int first = 0; first < pairs; first += most) {
        sweep_.set(LOCATION_PAIR_COUNT, std::min(most, pairs - first));
        glDispatchCompute(1, 1, 1);
        barrier_compute_to_compute();
    }
}

}  // namespace nuno
