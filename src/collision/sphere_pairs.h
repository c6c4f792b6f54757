// Vertices that come closer to each other than the cloth is thick, by a uniform grid: what level `spheres` answers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/thread_pool.h"
#include "model/cloth_model.h"

namespace nuno {

struct VertexPair
{
    std::uint32_t a, b;  // a < b

    bool operator==(const VertexPair&) const = default;
    bool operator<(const VertexPair& other) const { return a != other.a ? a < other.a : b < other.b; }
};

// Keeps its storage from one search to the next.
class SphereSearch
{
  public:
    // Rest positions [m] of all sheets, which must outlive it; without sheets, all vertices are of one.
    SphereSearch(std::span<const glm::vec3> rest_positions, std::span<const Sheet> sheets);

    // Sorts the vertices into the cells of a grid, `distance` [m] wide or more. Positions (xyz [m]) are finite.
    void sort(std::span<const glm::vec4> positions, float distance);
    // All pairs that were closer than the distance when they were sorted, each once, in an order that depends on the
    // positions alone; they last until the next search. Not those of one sheet that are closer than it at rest.
    std::span<const VertexPair> find(ThreadPool& pool);
    // Pairs of vertices of neighbouring cells in the last search.
    std::uint64_t pairs_tested() const { return pairs_tested_; }

    // Whether the two are close and no neighbours at rest: what `find` finds, pair by pair.
    bool is_pair(const glm::vec4& position_a, const glm::vec4& position_b, VertexPair pair, float distance) const;

  private:
    struct Entry
    {
        std::uint64_t key;  // number of the cell
        std::uint32_t vertex;
    };
    struct Task
    {
        std::vector<VertexPair> pairs;
        std::uint64_t pairs_tested;
    };
    void sort_entries(std::uint64_t key_end);
    void search(std::size_t begin, std::size_t end, Task& task) const;

    std::span<const glm::vec3> rest_positions_;
    std::vector<std::uint32_t> sheet_numbers_;  // of every vertex
    float distance_ = 0;
    std::uint64_t row_stride_ = 0, layer_stride_ = 0;  // from a cell to the next along y and z
    std::vector<Entry> entries_, unsorted_;            // in order of cells, then of vertices
    std::vector<glm::vec4> positions_;                 // of the entries
    std::vector<Task> tasks_;
    std::vector<VertexPair> pairs_;
    std::uint64_t pairs_tested_ = 0;
};

}  // namespace nuno
