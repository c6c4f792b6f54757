// Which windows there are: of whole sheets, and of nodes from the largest down.
#include <algorithm>

#include "collision/tree/chart_builder.h"
#include "collision/tree/chart_proof.h"

namespace nuno {
namespace {

// Nodes of 4^4 of level 1, of 8192 faces, down to those of 16; where these have no plane, down to single ones.
constexpr int kTopLevel = 5, kLowLevel = 3, kLeastLevel = 1;

}  // namespace

class ChartProof::Builder
{
  public:
    Builder(ChartProof& proof, const TreeLayout& layout, std::span<const glm::vec3> rest_positions,
            std::span<const glm::uvec3> faces)
        : proof_(proof), charts_(rest_positions, faces), faces_of_((layout.levels[0].size() + 3) / 4)
    {
        proof.node_of_face_.assign(faces.size(), 0);
        for (std::uint32_t c = 0; c < layout.cells.size(); ++c) {
            const Cell& cell = layout.cells[c];
            for (std::size_t k = 0; !cell.is_absent() && k < (cell.has_two() ? 2 : 1); ++k) {
                faces_of_[c / 16].push_back(cell.face[k]);
                proof.node_of_face_[cell.face[k]] = c / 16;
            }
        }
        find_touching(faces, rest_positions.size());
    }

    // A sheet that is no grid, by its nodes of level 0. Where it shares one of level 1 with another, as the smallest do,
    // its nodes are in no window.
    void add_sheet(NodeRun run, const TreeLayout& layout)
    {
        first_ = (run.begin + 3) / 4;
        end_ = run.begin % 4 == 0 ? (run.end + 3) / 4 : first_;
        if (end_ > first_ && !is_alone(run, layout)) --end_;
        std::vector<std::uint32_t> held;
        for (std::uint32_t c = 4 * run.begin; c < 4 * run.end; ++c)
            for (std::size_t k = 0; !layout.cells[c].is_absent() && k < (layout.cells[c].has_two() ? 2 : 1); ++k)
                held.push_back(layout.cells[c].face[k]);
        sheet_ = kNoWindow;
        if (std::optional<ChartWindow> chart = charts_.window_of(held)) {
            sheet_ = append(std::move(*chart), first_, end_, {}, {});
            proof_.sheets_.push_back(sheet_);
        } else {
            proof_.has_all_sheets_ = false;
        }
        const std::uint32_t width = width_of(kTopLevel);
        std::vector<std::uint32_t> top;
        for (std::uint32_t node = first_ / width; node * width < end_; ++node) add_nodes(kTopLevel, node, top);
        for (const std::uint32_t window : top) proof_.families_.push_back({window, sheet_});
    }

  private:
    static std::uint32_t width_of(int level) { return std::uint32_t{1} << (2 * (level - 1)); }

    // Whether the last node of level 1 of the run has no faces of another sheet.
    bool is_alone(NodeRun run, const TreeLayout& layout) const
    {
        const std::size_t end = std::min<std::size_t>(16 * std::size_t(end_), layout.cells.size());
        for (std::size_t c = 4 * std::size_t(run.end); c < end; ++c)
            if (!layout.cells[c].is_absent()) return false;
        return true;
    }

    // Nodes of level 1 whose faces share a vertex.
    void find_touching(std::span<const glm::uvec3> faces, std::size_t vertex_count)
    {
        std::vector<std::vector<std::uint32_t>> nodes_at(vertex_count);
        for (std::uint32_t node = 0; node < faces_of_.size(); ++node)
            for (const std::uint32_t face : faces_of_[node])
                for (int k = 0; k < 3; ++k) {
                    std::vector<std::uint32_t>& nodes = nodes_at[faces[face][k]];
                    if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
                }
        touching_.resize(faces_of_.size());
        for (const std::vector<std::uint32_t>& nodes : nodes_at)
            for (const std::uint32_t a : nodes)
                for (const std::uint32_t b : nodes)
                    if (a != b) touching_[a].push_back(b);
        for (std::vector<std::uint32_t>& nodes : touching_) {
            std::sort(nodes.begin(), nodes.end());
            nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        }
    }

    // Adds the windows of the node and of those below it; `found` gets those that are in no other of them.
    void add_nodes(int level, std::uint32_t node, std::vector<std::uint32_t>& found)
    {
        const std::uint32_t begin = std::max(node * width_of(level), first_);
        const std::uint32_t end = std::min((node + 1) * width_of(level), end_);
        if (begin >= end) return;
        std::optional<ChartWindow> chart;
        const bool is_sheet = begin == first_ && end == end_;
        const std::vector<std::uint32_t> around = around_of(begin, end);
        if (!is_sheet) chart = charts_.window_of(held_by(begin, end, around));
        std::vector<std::uint32_t> inner;
        if (level > kLowLevel || (level > kLeastLevel && !chart && !(is_sheet && sheet_ != kNoWindow)))
            for (std::uint32_t k = 0; k < 4; ++k) add_nodes(level - 1, 4 * node + k, inner);
        if (chart)
            found.push_back(append(std::move(*chart), begin, end, around, inner));
        else
            found.insert(found.end(), inner.begin(), inner.end());
    }

    std::vector<std::uint32_t> around_of(std::uint32_t begin, std::uint32_t end) const
    {
        std::vector<std::uint32_t> around;
        for (std::uint32_t node = begin; node < end; ++node)
            for (const std::uint32_t other : touching_[node])
                if (other < begin || other >= end) around.push_back(other);
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        return around;
    }

    std::vector<std::uint32_t> held_by(std::uint32_t begin, std::uint32_t end,
                                       std::span<const std::uint32_t> around) const
    {
        std::vector<std::uint32_t> held;
        for (std::uint32_t node = begin; node < end; ++node)
            held.insert(held.end(), faces_of_[node].begin(), faces_of_[node].end());
        for (const std::uint32_t node : around) held.insert(held.end(), faces_of_[node].begin(), faces_of_[node].end());
        return held;
    }

    // Nodes without faces that follow belong to any window.
    std::uint32_t append(ChartWindow chart, std::uint32_t begin, std::uint32_t end,
                         const std::vector<std::uint32_t>& around, const std::vector<std::uint32_t>& inner)
    {
        while (end > begin && end < faces_of_.size() && faces_of_[end].empty()) ++end;
        proof_.windows_.push_back({std::move(chart), begin, end, around, inner});
        return static_cast<std::uint32_t>(proof_.windows_.size() - 1);
    }

    ChartProof& proof_;
    ChartBuilder charts_;
    std::vector<std::vector<std::uint32_t>> faces_of_, touching_;  // of each node of level 1
    std::uint32_t first_ = 0, end_ = 0;                            // nodes of the sheet
    std::uint32_t sheet_ = kNoWindow;                              // its window
};

ChartProof::ChartProof(const TreeLayout& layout, std::span<const glm::vec3> rest_positions,
                       std::span<const glm::uvec3> faces)
{
    Builder builder(*this, layout, rest_positions, faces);
    for (const NodeRun run : layout.meshes) builder.add_sheet(run, layout);
    is_proven_.resize(windows_.size());
    of_node_.resize(std::max<std::size_t>(layout.levels.size(), 2));
    for (std::size_t level = 0; level < layout.levels.size(); ++level)
        of_node_[level].assign(layout.levels[level].size(), kNoWindow);
    of_node_[1].resize((layout.levels[0].size() + 3) / 4, kNoWindow);
    for (const Window& window : windows_) around_of_.push_back(window.around);
    for (std::size_t level = 0; level < of_node_.size(); ++level) levels_.of_node[level] = of_node_[level].data();
    levels_.around = around_of_.data();
}

}  // namespace nuno
