// The coloured springs of xpbd in compute shaders: a dispatch for every few colours.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <tuple>

#include "gl/program.h"
#include "solver/base/gpu_table.h"
#include "solver/xpbd/spring_quads.h"

namespace nuno {

class GpuSprings
{
  public:
    // A cloth of at most so many vertices fits into one work group.
    static constexpr std::uint32_t kSmallVertices = 4096;

    explicit GpuSprings(std::uint32_t vertex_count);

    // Other springs, with numbers left to set; `limited`: they will have a limit; `at_once`: only a kernel that takes
    // all groups will sweep them. Error where they do not fit into what this device reads.
    void choose(const ColouredSprings& springs, bool limited, bool at_once);
    // SpringNumber of solver/xpbd/constraint_colours.h, one vec4 a spring.
    void set_numbers(std::span<const glm::vec4> numbers);

    // In the positions bound as read and as written: every colour once; every colour once in reverse; one after the
    // other.
    void sweep_forth() const;
    void sweep_back() const;
    void sweep_forth_and_back() const;

    // For a kernel that takes all groups: binds them, and says how many there are.
    std::int32_t bind_groups() const;
    const std::vector<QuadGroup>& groups() const { return quads_.groups; }
    int most_colours() const;  // of a group
    bool limited() const { return limited_; }

  private:
    enum class Way : std::uint8_t
    {
        forth,
        back,
        forth_and_back
    };
    // By limited, colours of a group, way.
    using Variant = std::tuple<bool, int, Way>;
    Variant variant(const QuadGroup& group, Way way) const;
    void compile(const Variant& variant);
    void bind() const;
    void project(const QuadGroup& group, Way way) const;

    const std::uint32_t vertex_count_;
    bool limited_ = false;
    SpringQuads quads_;
    // Of quads: their groups; vertices; length and share of both sides, limit and hardness.
    GpuTable groups_, corners_, lengths_, limits_;
    std::map<Variant, Program> programs_;
};

}  // namespace nuno
