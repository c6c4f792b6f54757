// Colours given out one after another.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace nuno {

// Gives what stands on some vertices the first colour that nothing before it has at one of them.
class FirstFit
{
  public:
    explicit FirstFit(std::uint32_t vertex_count) : used_(vertex_count) {}

    // From the colour `least` on.
    std::size_t colour(std::span<const std::uint32_t> vertices, std::size_t least = 0)
    {
        std::size_t colour = least;
        const auto taken = [&](std::uint32_t v) { return colour < used_[v].size() && used_[v][colour]; };
        while (std::any_of(vertices.begin(), vertices.end(), taken)) ++colour;
        for (const std::uint32_t v : vertices) {
            if (used_[v].size() <= colour) used_[v].resize(colour + 1);
            used_[v][colour] = true;
        }
        return colour;
    }

  private:
    std::vector<std::vector<bool>> used_;  // by vertex and colour
};

}  // namespace nuno
