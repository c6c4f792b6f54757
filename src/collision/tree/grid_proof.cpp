// Levels of bounds of edges, and their flags.
#include "collision/tree/grid_proof.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kNoEdge = 1e30f;
constexpr int kReadAhead = 32;

// Faces of a grid without a common vertex are at least half a diagonal of a unit cell apart at rest, so a surface with
// |f(p) - f(q)| >= lambda |p - q|, lengths at rest in cells, has them lambda / sqrt 2 apart.
constexpr float kCellsApart = 1.41421357f;

void forget_edges(const EdgeLevel& level)
{
    const std::size_t size = std::size_t(level.stride) * std::size_t(level.height + 1);
    for (std::size_t bound = 0; bound < 12; ++bound)
        std::fill_n(level.bound[bound], size, bound / 3 % 2 == 1 ? -kNoEdge : kNoEdge);
}

// The largest norm of the rest shape's gradient, lengths in cells. Its square in one triangle, with sides u and v, is
// the larger solution of s^2 - (u.u + v.v) s + (u.u v.v - (u.v)^2) = 0.
float largest_spacing(const GridPatch& grid, std::span<const glm::vec3> rest_positions)
{
    double largest = 0;
    const auto at = [&](int i, int j) { return glm::dvec3(rest_positions[grid.vertex(i, j)]); };
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            // Whichever way the cell is cut, its triangles have one of two rows and one of two columns as sides.
            for (int corner = 0; corner < 4; ++corner) {
                const int di = corner & 1, dj = corner >> 1;
                const glm::dvec3 u = at(i + 1, j + dj) - at(i, j + dj), v = at(i + di, j + 1) - at(i + di, j);
                const double a = glm::dot(u, u), b = glm::dot(v, v), c = glm::dot(u, v);
                largest = std::max(largest, 0.5 * (a + b + std::sqrt((a - b) * (a - b) + 4 * c * c)));
            }
    return static_cast<float>(std::sqrt(largest));
}

}  // namespace

GridProof::GridProof(const GridPatch& grid, std::span<const glm::vec3> rest_positions)
    : cell_groups_(cell_groups(grid.columns)), rest_spacing_(largest_spacing(grid, rest_positions))
{
    int width = (grid.columns + 3) / 4, height = (grid.rows + 3) / 4;
    while (levels_.empty() || levels_.back().width > 1 || levels_.back().height > 1) {
        EdgeLevel level;
        level.width = width;
        level.height = height;
        level.stride = width + kReadAhead;
        const std::size_t size = std::size_t(level.stride) * std::size_t(height + 1);
        storage_.emplace_back(12 * size);
        for (std::size_t bound = 0; bound < 12; ++bound) level.bound[bound] = storage_.back().data() + bound * size;
        levels_.push_back(level);
        flags_.emplace_back(std::size_t(width) * std::size_t(height));
        forget_edges(level);
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
    open_.assign(flags_.front().size() + 4, 0);
    apart_cells_.assign(std::size_t(cell_groups_) * std::size_t(grid.rows), 0);
}

void GridProof::clear() { forget_edges(levels_.front()); }

// Points p, q are at most rest_spacing_ |p - q| apart at rest: lambda above rest_share rest_spacing_ is enough, and
// above that and kCellsApart margin for the margin too.
void GridProof::prove(const TreeSettings& settings, const TreeKernels& kernels)
{
    const float asked = std::min(kCellsApart * settings.distance, settings.rest_share * rest_spacing_);
    need_ = (asked + kCellsApart * settings.margin) * 1.0001f + 1e-6f;
    for (std::size_t n = 1; n < levels_.size(); ++n) kernels.merge_edges(levels_[n - 1], levels_[n]);
    kernels.prove_blocks(levels_.back(), need_, kEdgeSlack, flags_.back().data());
    if (holds_for_all()) {
        for (std::vector<std::uint8_t>& flags : flags_) std::fill(flags.begin(), flags.end(), std::uint8_t{0xf});
        std::fill(open_.begin(), open_.end(), std::uint8_t{0});
        return;
    }
    for (std::size_t n = 0; n + 1 < levels_.size(); ++n)
        kernels.prove_blocks(levels_[n], need_, kEdgeSlack, flags_[n].data());
    find_open_blocks();
}

ProofLevel GridProof::level(int level) const
{
    const std::size_t n = std::min(std::size_t(level) - 1, levels_.size() - 1);
    return {flags_[n].data(), static_cast<std::uint32_t>(levels_[n].width)};
}

void GridProof::find_open_blocks()
{
    const int width = base().width, height = base().height;
    const std::vector<std::uint8_t>& flags = flags_.front();
    // Whether the window of the flag `bit` with the corner (x, y) exists and is not proven.
    const auto is_open = [&](int x, int y, int bit, int across, int down) {
        if (x < 0 || y < 0 || x + across >= width || y + down >= height) return false;
        return (flags[std::size_t(y) * std::size_t(width) + std::size_t(x)] & bit) == 0;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int open = 0;
            if (is_open(x, y, 1, 0, 0)) open |= kOpenSelf;
            if (is_open(x, y, 2, 1, 0)) open |= kOpenRight;
            if (is_open(x - 1, y, 2, 1, 0)) open |= kOpenLeft;
            if (is_open(x, y - 1, 4, 0, 1)) open |= kOpenAbove;
            if (is_open(x, y - 1, 8, 1, 1)) open |= kOpenAboveRight;
            if (is_open(x - 1, y - 1, 8, 1, 1)) open |= kOpenAboveLeft;
            open_[std::size_t(y) * std::size_t(width) + std::size_t(x)] = static_cast<std::uint8_t>(open);
        }
}

bool GridProof::is_open_row(int block_row) const
{
    // Some are written down with the row below.
    const auto begin = open_.begin() + std::ptrdiff_t(block_row) * base().width;
    const auto end = begin + (block_row + 1 < base().height ? 2 : 1) * base().width;
    return std::any_of(begin, end, [](std::uint8_t open) { return open != 0; });
}

void GridProof::prove_cells(const BoxFrame& frame, const GridBand& band, const TreeKernels& kernels, RowScratch& rows)
{
    GridBand open = band;
    for (int row = band.first_row; row < band.end_row; row = open.end_row) {
        const bool is_open = is_open_row(row / 4);
        open.first_row = row;
        for (open.end_row = row; open.end_row < band.end_row && is_open_row(open.end_row / 4) == is_open;)
            open.end_row = std::min(open.end_row + 4, band.end_row);
        if (is_open) kernels.prove_cells(frame, open, need_, kEdgeSlack, rows, apart_cells_.data());
    }
}

bool GridProof::is_apart_from_neighbours(int i, int j) const
{
    const int x = i / 4, y = j / 4, width = base().width;
    const auto open = [&](int across, int down) {
        if (x + across < 0 || x + across >= width || y + down >= base().height) return 0;
        return int{open_[std::size_t(y + down) * std::size_t(width) + std::size_t(x + across)]};
    };
    if (open(0, 0) == 0 && (open(0, 1) & kOpenAbove) == 0 && (open(1, 1) & kOpenAboveLeft) == 0 &&
        (open(-1, 1) & kOpenAboveRight) == 0)
        return true;
    return (apart_cells_[std::size_t(j) * std::size_t(cell_groups_) + std::size_t(i / 16)] >> (i % 16) & 1) != 0;
}

}  // namespace nuno
