// Places the cells of all sheets in one tree.
#include "collision/tree/tree_layout.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <utility>

#include "collision/tree/cell_pairing.h"

namespace nuno {
namespace {

constexpr int kTileBits = 5;  // a square of a grid has 2^5 x 2^5 nodes of level 0

// The bits of the low half of v, one apart.
std::uint32_t spread(std::uint32_t v)
{
    std::uint32_t spread = 0;
    for (int bit = 0; bit < 16; ++bit) spread |= (v >> bit & 1u) << (2 * bit);
    return spread;
}

std::uint32_t morton(std::uint32_t x, std::uint32_t y) { return spread(x) | spread(y) << 1; }

// What one sheet brings.
struct Part
{
    std::optional<GridPatch> grid;
    std::vector<Cell> cells;       // of a mesh, in order
    std::uint32_t node_count = 0;  // of level 0
    int tile_bits = 0;             // log2 of the side of its squares [nodes]
};

Cell grid_cell(const GridPatch& grid, std::span<const glm::uvec3> faces, int i, int j)
{
    const std::size_t at = std::size_t(j) * std::size_t(grid.face_stride()) + std::size_t(i);
    const std::uint32_t face0 = grid.faces[0][at], face1 = grid.faces[1][at];
    const std::uint32_t a = grid.vertex(i, j), b = grid.vertex(i + 1, j), c = grid.vertex(i, j + 1),
                        d = grid.vertex(i + 1, j + 1);
    const glm::uvec3 corners = faces[face0];
    const bool has_d = corners.x == d || corners.y == d || corners.z == d;
    return has_d ? Cell::of_two({a, d, c, b}, face0, face1) : Cell::of_two({b, c, a, d}, face0, face1);
}

int bits_for(std::uint32_t count) { return static_cast<int>(std::bit_width(count - 1)); }

Part part_of_sheet(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces, const Sheet& sheet)
{
    Part part;
    part.grid = make_grid_patch(sheet, faces);
    if (part.grid) {
        const auto side = static_cast<std::uint32_t>(std::max(part.grid->node_columns(), part.grid->node_rows()));
        part.tile_bits = std::min(kTileBits, bits_for(side));
        const auto tiles = [&](int nodes) {
            return (static_cast<std::uint32_t>(nodes) + (1u << part.tile_bits) - 1) >> part.tile_bits;
        };
        part.node_count = tiles(part.grid->node_columns()) * tiles(part.grid->node_rows()) << (2 * part.tile_bits);
        return part;
    }
    part.cells = pair_faces({rest_positions, faces, sheet.first_face, sheet.face_count});
    order_cells(part.cells, rest_positions);
    part.node_count = static_cast<std::uint32_t>((part.cells.size() + 3) / 4);
    part.tile_bits = std::min(kTileBits, (bits_for(part.node_count) + 1) / 2);
    return part;
}

class Builder
{
  public:
    Builder(TreeLayout& layout, std::span<const glm::uvec3> faces) : layout_(layout), faces_(faces) {}

    void append_mesh(const Part& part)
    {
        const std::uint32_t first = start(part);
        std::copy(part.cells.begin(), part.cells.end(), layout_.cells.begin() + 4 * std::ptrdiff_t(first));
        layout_.mesh_nodes.push_back({first, first + part.node_count});
        layout_.meshes.push_back({first, first + part.node_count});
    }

    void append_grid(const Part& part)
    {
        const std::uint32_t first = start(part);
        const auto number = static_cast<std::uint32_t>(layout_.grids.size());
        GridPatch& grid = layout_.grids.emplace_back(*part.grid);
        grid.node_of.resize(std::size_t(grid.node_columns()) * std::size_t(grid.node_rows()));
        const std::uint32_t side = 1u << part.tile_bits;
        std::uint32_t node = first;
        for (const auto& [x0, y0] : tiles_of(grid, side))
            for (std::uint32_t k = 0; k < side * side; ++k, ++node) {
                const std::uint32_t x = x0 + squeezed(k), y = y0 + squeezed(k >> 1);
                place_node(grid, number, node, x, y);
            }
        if (!grid.is_regular) layout_.mesh_nodes.push_back({first, first + part.node_count});
    }

  private:
    struct Corner
    {
        std::uint32_t x, y;
    };

    static std::uint32_t squeezed(std::uint32_t v)
    {
        std::uint32_t squeezed = 0;
        for (int bit = 0; bit < 16; ++bit) squeezed |= (v >> (2 * bit) & 1u) << bit;
        return squeezed;
    }

    // Squares of the grid as a quadtree has them.
    static std::vector<Corner> tiles_of(const GridPatch& grid, std::uint32_t side)
    {
        std::vector<Corner> tiles;
        for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(grid.node_rows()); y += side)
            for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(grid.node_columns()); x += side)
                tiles.push_back({x, y});
        std::sort(tiles.begin(), tiles.end(), [&](const Corner& a, const Corner& b) {
            return morton(a.x / side, a.y / side) < morton(b.x / side, b.y / side);
        });
        return tiles;
    }

    // The number of the part's first node. Parts come in order of falling tile_bits, so squares stay aligned.
    std::uint32_t start(const Part& part)
    {
        std::vector<TreeNode>& nodes = layout_.levels[0];
        const std::uint32_t square = 1u << (2 * part.tile_bits);
        const auto first = (static_cast<std::uint32_t>(nodes.size()) + square - 1) / square * square;
        nodes.resize(std::size_t(first) + part.node_count, kEmptyNode);
        layout_.cells.resize(4 * nodes.size());
        return first;
    }

    void place_node(GridPatch& grid, std::uint32_t number, std::uint32_t node, std::uint32_t x, std::uint32_t y)
    {
        TreeNode& placed = layout_.levels[0][node];
        placed.x = static_cast<std::uint16_t>(x);
        placed.y = static_cast<std::uint16_t>(y);
        placed.grid = number;
        placed.meets_neighbours = grid.is_regular ? 0 : 3;
        if (x >= std::uint32_t(grid.node_columns()) || y >= std::uint32_t(grid.node_rows())) return;
        grid.node_of[std::size_t(y) * std::size_t(grid.node_columns()) + x] = node;
        for (int k = 0; k < 4; ++k) {
            const int i = 2 * int(x) + (k & 1), j = 2 * int(y) + (k >> 1);
            if (i >= grid.columns || j >= grid.rows) continue;
            layout_.cells[4 * std::size_t(node) + std::size_t(k)] = grid_cell(grid, faces_, i, j);
        }
    }

    TreeLayout& layout_;
    std::span<const glm::uvec3> faces_;
};

// A node whose children are one square of a grid is a square of it too.
void place_parent(TreeNode& parent, const TreeNode* children)
{
    const TreeNode& first = children[0];
    for (std::uint32_t k = 0; k < 4; ++k)
        if (children[k].grid != first.grid || children[k].x != first.x + (k & 1) || children[k].y != first.y + (k >> 1))
            return;
    if (first.grid >= kNoGrid || first.x % 2 != 0 || first.y % 2 != 0) return;
    parent.grid = first.grid;
    parent.meets_neighbours = first.meets_neighbours;
    parent.x = first.x / 2;
    parent.y = first.y / 2;
}

void add_upper_levels(TreeLayout& layout)
{
    while (layout.levels.back().size() > 1) {
        std::vector<TreeNode>& below = layout.levels.back();
        below.resize((below.size() + 3) / 4 * 4, kEmptyNode);
        std::vector<TreeNode> level(below.size() / 4, kEmptyNode);
        for (std::size_t n = 0; n < level.size(); ++n) place_parent(level[n], &below[4 * n]);
        layout.levels.push_back(std::move(level));
    }
    // The cells of an irregular grid meet their neighbours like those of a mesh.
    for (const NodeRun run : layout.mesh_nodes)
        for (std::uint32_t n = run.begin; n < run.end; ++n) layout.levels[0][n].grid = kNoGrid;
    std::uint32_t number = 0;
    for (std::vector<TreeNode>& level : layout.levels)
        for (TreeNode& node : level)
            if (node.grid >= kNoGrid) node.grid = kNoGrid + number++;
    layout.cells.resize(4 * layout.levels[0].size());
}

}  // namespace

TreeLayout make_tree_layout(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                            std::span<const Sheet> sheets)
{
    std::vector<Part> parts;
    for (const Sheet& sheet : sheets) parts.push_back(part_of_sheet(rest_positions, faces, sheet));
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return parts[a].tile_bits > parts[b].tile_bits; });

    TreeLayout layout;
    layout.levels.emplace_back();
    Builder builder(layout, faces);
    for (const std::size_t p : order) {
        if (parts[p].grid)
            builder.append_grid(parts[p]);
        else
            builder.append_mesh(parts[p]);
    }
    add_upper_levels(layout);
    return layout;
}

}  // namespace nuno
