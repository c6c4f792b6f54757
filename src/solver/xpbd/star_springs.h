// Springs of stars in colours: stars of one colour share no vertex.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "solver/base/team.h"
#include "solver/xpbd/constraint_colours.h"
#include "solver/xpbd/mesh_stars.h"

namespace nuno {

class StarSprings
{
  public:
    StarSprings(std::span<const Star> stars, std::size_t spring_count, std::uint32_t vertex_count);

    // Of a spring that is in a star.
    std::size_t colour(std::size_t spring) const;
    void set_numbers(std::size_t spring, float rest_length, float share);

    int colour_count() const { return colour_count_; }
    // This thread's part of the stars of a colour, spring by spring; `back`: in the reverse order. Positions and `lanes`
    // as for project_springs.
    void project(int colour, bool back, float* positions, int lanes, const Team& team) const;

  private:
    static constexpr std::size_t kSizes = Stars::kMostRing - Stars::kLeastRing + 1;

    struct Place
    {
        std::size_t size;  // of the ring, over Stars::kLeastRing
        std::size_t star;  // among those of that size
        int spring;
        std::size_t colour;
    };

    std::array<std::optional<ConstraintColours>, kSizes> sizes_;
    int colour_count_ = 0;
    std::vector<Place> places_;  // by spring
};

}  // namespace nuno
