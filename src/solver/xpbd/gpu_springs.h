// The coloured springs of xpbd in compute shaders: a dispatch for every few colours, or one for all of a small cloth.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
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
    static constexpr std::uint32_t kSmallVertices = 1024;

    explicit GpuSprings(std::uint32_t vertex_count);

    // Other springs, with numbers left to set; `limited`: they will have a limit; `at_once`: only sweep_all will be
    // called, of a small cloth, else only the others. Error where they do not fit into what this device reads.
    void choose(const ColouredSprings& springs, bool limited, bool at_once);
    // SpringNumber of solver/xpbd/constraint_colours.h, one vec4 a spring.
    void set_numbers(std::span<const glm::vec4> numbers);

    // In the positions bound as read and as written: every colour once; every colour once in reverse; one after the
    // other.
    void sweep_forth() const;
    void sweep_back() const;
    void sweep_forth_and_back() const;

    // So often forth and back in one dispatch.
    void sweep_all(int pairs) const;

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
    void compile_small();
    void bind() const;
    void project(const QuadGroup& group, Way way) const;

    const std::uint32_t vertex_count_;
    bool limited_ = false, at_once_ = false;
    SpringQuads quads_;
    GpuTable corners_, lengths_, limits_;  // of quads: vertices; length and share of both sides, limit and hardness
    std::map<Variant, Program> programs_;

    // At once: springs by colour.
    std::int32_t colour_count_ = 0;
    GpuTable ends_, numbers_, starts_;
    Program small_;
    std::optional<bool> small_limited_;  // what it is compiled for
};

}  // namespace nuno
