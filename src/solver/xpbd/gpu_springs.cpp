// Uploads coloured springs, and projects them.
#include "solver/xpbd/gpu_springs.h"

#include <string>

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"

namespace nuno {
namespace {

constexpr int kSmallGroup = 128;  // a group of more invocations than a colour of such a cloth has springs idles
constexpr float kNoSpring = -1;   // as its length

}  // namespace

GpuSprings::GpuSprings(std::uint32_t vertex_count)
    : vertex_count_(vertex_count),
      corners_(GL_RGBA32I),
      lengths_(GL_RGBA32F),
      limits_(GL_RGBA32F),
      ends_(GL_RG32I),
      numbers_(GL_RGBA32F),
      starts_(GL_R32I)
{
}

void GpuSprings::choose(const ColouredSprings& springs, bool limited, bool at_once)
{
    limited_ = limited;
    at_once_ = at_once;
    if (at_once) {
        colour_count_ = static_cast<std::int32_t>(springs.first.size()) - 1;
        ends_.upload(springs.ends);
        starts_.upload(springs.first);
        compile_small();
        return;
    }
    quads_ = make_spring_quads(springs, vertex_count_);
    corners_.upload(quads_.corners);
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
                                                        {"COLOURS", std::to_string(colour_count)},
                                                        {"FORTH", flag(way != Way::back)},
                                                        {"BACK", flag(way != Way::forth)}});
}

void GpuSprings::compile_small()
{
    if (small_limited_ == limited_) return;
    small_limited_ = limited_;
    small_ = compute_program("sim/xpbd_sweep_small.comp", {{"LIMITED", limited_ ? "1" : "0"},
                                                           {"SMALL_GROUP", std::to_string(kSmallGroup)},
                                                           {"SMALL_VERTICES", std::to_string(kSmallVertices)}});
    small_.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
}

void GpuSprings::set_numbers(std::span<const glm::vec4> numbers)
{
    if (at_once_) return numbers_.upload(std::as_bytes(numbers));
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

void GpuSprings::sweep_all(int pairs) const
{
    small_.use();
    small_.set(LOCATION_COLOUR_COUNT, colour_count_);
    small_.set(LOCATION_PAIR_COUNT, pairs);
    ends_.bind(UNIT_ENDS);
    numbers_.bind(UNIT_NUMBERS);
    starts_.bind(UNIT_COLOUR_STARTS);
    glDispatchCompute(1, 1, 1);
    barrier_compute_to_compute();
}

}  // namespace nuno
