// Uploads coloured springs, and projects them.
#include "solver/xpbd/gpu_springs.h"

#include <algorithm>
#include <string>

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"

namespace nuno {
namespace {

constexpr float kNoSpring = -1;  // as its length

}  // namespace

GpuSprings::GpuSprings(std::uint32_t vertex_count)
    : vertex_count_(vertex_count), groups_(GL_RGBA32I), corners_(GL_RGBA32I), lengths_(GL_RGBA32F), limits_(GL_RGBA32F)
{
}

void GpuSprings::choose(const ColouredSprings& springs, bool limited, bool at_once)
{
    limited_ = limited;
    quads_ = make_spring_quads(springs, vertex_count_);
    corners_.upload(quads_.corners);
    static_assert(sizeof(QuadGroup) == sizeof(glm::ivec4));
    groups_.upload(quads_.groups);
    if (at_once) return;
    for (const QuadGroup& group : quads_.groups)
        for (const Way way : {Way::forth, Way::back}) compile(variant(group, way));
    if (!quads_.groups.empty()) compile(variant(quads_.groups.back(), Way::forth_and_back));
}

// One colour by itself is the same both ways.
GpuSprings::Variant GpuSprings::variant(const QuadGroup& group, Way way) const
{
    return {limited_, group.colour_count, group.colour_count == 1 && way == Way::back ? Way::forth : way};
}

void GpuSprings::compile(const Variant& variant)
{
    Program& program = programs_[variant];
    if (program.id() != 0) return;
    const auto& [limited, colour_count, way] = variant;
    const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
    program = compute_program("sim/xpbd_springs.comp", {{"LIMITED", flag(limited)},
                                                        {"MOST_COLOURS", std::to_string(colour_count)},
                                                        {"FORTH", flag(way != Way::back)},
                                                        {"BACK", flag(way != Way::forth)}});
}

void GpuSprings::set_numbers(std::span<const glm::vec4> numbers)
{
    std::vector<glm::vec4> lengths, limits;
    const auto of = [&](std::int32_t spring) {
        return spring < 0 ? glm::vec4(kNoSpring, 0, 0, 0) : numbers[std::size_t(spring)];
    };
    for (const glm::ivec2 sides : quads_.sides) {
        const glm::vec4 a = of(sides.x), b = of(sides.y);
        lengths.emplace_back(a.x, a.y, b.x, b.y);
        limits.emplace_back(a.z, a.w, b.z, b.w);
    }
    lengths_.upload(lengths);
    if (limited_) limits_.upload(limits);
}

void GpuSprings::project(const QuadGroup& group, Way way) const
{
    if (group.count == 0) return;
    const Program& kernel = programs_.at(variant(group, way));
    kernel.use();
    kernel.set(LOCATION_FIRST_PLACE, group.first);
    kernel.set(LOCATION_PLACE_COUNT, group.count);
    kernel.set(LOCATION_FIRST_SIDES, group.first_sides);
    glDispatchCompute(static_cast<GLuint>((group.count + GROUP_SIZE - 1) / GROUP_SIZE), 1, 1);
    barrier_compute_to_compute();
}

void GpuSprings::bind() const
{
    corners_.bind(UNIT_ENDS);
    lengths_.bind(UNIT_NUMBERS);
    if (limited_) limits_.bind(UNIT_SHARES);
}

std::int32_t GpuSprings::bind_groups() const
{
    bind();
    groups_.bind(UNIT_QUAD_GROUPS);
    return static_cast<std::int32_t>(quads_.groups.size());
}

int GpuSprings::most_colours() const
{
    int most = 1;
    for (const QuadGroup& group : quads_.groups) most = std::max(most, group.colour_count);
    return most;
}

void GpuSprings::sweep_forth() const
{
    bind();
    for (const QuadGroup& group : quads_.groups) project(group, Way::forth);
}

void GpuSprings::sweep_back() const
{
    bind();
    for (auto group = quads_.groups.rbegin(); group != quads_.groups.rend(); ++group) project(*group, Way::back);
}

void GpuSprings::sweep_forth_and_back() const
{
    if (quads_.groups.empty()) return;
    bind();
    const std::size_t last = quads_.groups.size() - 1;
    for (std::size_t n = 0; n < last; ++n) project(quads_.groups[n], Way::forth);
    project(quads_.groups[last], Way::forth_and_back);
    for (std::size_t n = last; n-- > 0;) project(quads_.groups[n], Way::back);
}

}  // namespace nuno
