// Where a mesh cannot touch itself, by the monotonicity of its surface over planes at rest (docs/tree.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "collision/tree/chart_builder.h"
#include "collision/tree/kernels.h"
#include "collision/tree/tree_layout.h"
#include "core/thread_pool.h"

namespace nuno {

// Windows over all sheets of a tree that are no grids: each whole sheet, and parts of it that are nodes of the tree with
// the level-1 nodes around them; of those that have a plane. Keeps its storage.
class ChartProof
{
  public:
    ChartProof(const TreeLayout& layout, std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces);

    // In every window that is proven, vertices are further than the settings ask from the faces that they are no
    // corners of, and edges from edges without a common end, at all times of the way.
    void prove(const Poses& poses, const TreeSettings& settings, const TreeKernels& kernels, ThreadPool& pool);

    // Whether all these sheets are proven as a whole.
    bool holds_for_all() const;
    // Whether a window that holds all of the node has been proven.
    bool holds_node(int level, std::uint32_t node) const
    {
        return of_node_[static_cast<std::size_t>(level)][node] != kNoWindow;
    }
    // Whether contacts of a face with itself and with those that share a vertex with it are ruled out. Not of a grid.
    bool is_apart_from_neighbours(std::uint32_t face) const { return of_node_[1][node_of_face_[face]] != kNoWindow; }
    // For QueryFrame.
    const WindowLevels* levels() const { return windows_.empty() ? nullptr : &levels_; }

  private:
    // Nodes of level 1, and windows with all or some of them.
    struct Window
    {
        ChartWindow chart;
        std::uint32_t begin, end;           // nodes of level 1 that are its own
        std::vector<std::uint32_t> around;  // those that touch them, in order
        std::vector<std::uint32_t> inner;   // the largest windows of nodes within it
    };
    struct Way
    {
        const Poses& poses;
        const TreeSettings& settings;
        const TreeKernels& kernels;
    };
    struct PartTask
    {
        std::uint32_t window;
        std::size_t part;
        ChartTest test;
        ChartAnswer answer;
    };
    // A window of nodes, and the one of its whole sheet or kNoWindow.
    struct Family
    {
        std::uint32_t window, sheet;
    };
    class Builder;

    static std::optional<ChartTest> test_of(const ChartWindow& chart, const Way& way);
    static bool holds_where_it_failed(const ChartWindow& chart, const ChartTest& test, const Way& way);
    static ChartAnswer prove_part(const ChartPart& part, const ChartTest& test, const Way& way);
    static bool prove_window(ChartWindow& chart, const Way& way);
    void share(ThreadPool& pool, std::size_t task_count, const std::function<void(std::size_t)>& body) const;
    void prove_family(std::uint32_t window, const Way& way);
    void prove_sheets(const Way& way, ThreadPool& pool);
    void note_family(std::uint32_t window);
    void note(std::uint32_t window);

    std::vector<Window> windows_;
    std::vector<std::uint8_t> is_proven_;  // of each window
    std::vector<std::uint32_t> sheets_;    // the windows of whole sheets
    std::vector<Family> families_;         // with the windows of nodes that are in no other such window
    bool has_all_sheets_ = true;           // whether every sheet has a window

    std::vector<std::uint32_t> node_of_face_;                // of level 1
    std::vector<std::vector<std::uint32_t>> of_node_;        // by level and node, the window that was proven
    std::vector<std::span<const std::uint32_t>> around_of_;  // of each window
    WindowLevels levels_;
    std::vector<PartTask> tasks_;
};

}  // namespace nuno
