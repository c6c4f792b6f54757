// The seed's culling: the nodes of the tree that cannot hit themselves, if one goes by their normals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/tree/tree_layout.h"
#include "core/thread_pool.h"

namespace nuno {

class SeedFlags
{
  public:
    // Marks the nodes whose faces' normals at `positions` lie in one half space, and all nodes below them.
    void mark(const TreeLayout& layout, std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions,
              ThreadPool& pool);
    bool skips(int level, std::uint32_t node) const { return flags_[static_cast<std::size_t>(level)][node] != 0; }

  private:
    // The box of unit normals; empty where there are no faces.
    struct NormalBox
    {
        glm::vec3 lo{1}, hi{-1};
    };
    NormalBox of_cells(const TreeLayout& layout, std::span<const glm::uvec3> faces,
                       std::span<const glm::vec4> positions, std::uint32_t node) const;
    static bool within_half_space(const NormalBox& box);

    std::vector<std::vector<NormalBox>> boxes_;
    std::vector<std::vector<std::uint8_t>> flags_;
};

}  // namespace nuno
