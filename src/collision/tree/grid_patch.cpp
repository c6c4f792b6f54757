// Finds the faces of each cell of a grid sheet.
#include "collision/tree/grid_patch.h"

#include <algorithm>
#include <utility>

namespace nuno {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr int kMostColumns = 1 << 16;  // a node's place has 16 bits
constexpr std::size_t kReadAhead = 32;

// Column and row of every vertex of the sheet.
struct Place
{
    int i, j;
};

std::vector<Place> places_of(const GridPatch& patch, const Sheet& sheet)
{
    std::vector<Place> places(sheet.vertex_count);
    for (int j = 0; j <= patch.rows; ++j)
        for (int i = 0; i <= patch.columns; ++i) places[patch.vertex(i, j) - sheet.first_vertex] = {i, j};
    return places;
}

// Which corner of its cell a face misses, as 2 (row) + (column); 4 where it is no half of a cell.
struct Half
{
    int i, j, missing;
};

Half half_of(const glm::uvec3& face, const Sheet& sheet, const std::vector<Place>& places)
{
    const Place a = places[face.x - sheet.first_vertex], b = places[face.y - sheet.first_vertex],
                c = places[face.z - sheet.first_vertex];
    const int i = std::min({a.i, b.i, c.i}), j = std::min({a.j, b.j, c.j});
    int corners = 0;
    for (const Place& p : {a, b, c}) {
        if (p.i - i > 1 || p.j - j > 1) return {i, j, 4};
        corners |= 1 << (2 * (p.j - j) + (p.i - i));
    }
    for (int missing = 0; missing < 4; ++missing)
        if (corners == (0xf & ~(1 << missing))) return {i, j, missing};
    return {i, j, 4};
}

// Fills in the faces; false where some cell has not two that are halves of it. Face 0 is the one that misses b, or,
// where the cell is cut from b to c, the one that misses d.
bool find_faces(GridPatch& patch, const Sheet& sheet, std::span<const glm::uvec3> faces)
{
    const std::size_t count = std::size_t(patch.columns) * std::size_t(patch.rows);
    for (auto& list : patch.faces) list.assign(count, kNone);
    const std::vector<Place> places = places_of(patch, sheet);
    std::size_t cut_from_a = 0;
    std::vector<int> missing_first(count, 4);
    for (std::uint32_t f = sheet.first_face; f < sheet.first_face + sheet.face_count; ++f) {
        const Half half = half_of(faces[f], sheet, places);
        if (half.missing == 4 || half.i >= patch.columns || half.j >= patch.rows) return false;
        const std::size_t cell = std::size_t(half.j) * std::size_t(patch.columns) + std::size_t(half.i);
        std::uint32_t& slot = patch.faces[half.missing == 1 || half.missing == 3 ? 0 : 1][cell];
        if (slot != kNone) return false;
        if (missing_first[cell] != 4 && missing_first[cell] + half.missing != 3) return false;
        slot = f;
        missing_first[cell] = half.missing;
        cut_from_a += half.missing == 1;
    }
    if (sheet.face_count != 2 * count) return false;
    patch.is_regular = cut_from_a == count;
    return true;
}

}  // namespace

std::optional<GridPatch> make_grid_patch(const Sheet& sheet, std::span<const glm::uvec3> faces)
{
    if (!sheet.is_grid() || sheet.columns < 2 || sheet.rows < 2 || sheet.columns > kMostColumns ||
        sheet.rows > kMostColumns || std::uint64_t(sheet.columns) * std::uint64_t(sheet.rows) != sheet.vertex_count)
        return std::nullopt;
    std::optional<GridPatch> irregular;
    for (const bool mirrored : {false, true}) {
        GridPatch patch;
        patch.columns = sheet.columns - 1;
        patch.rows = sheet.rows - 1;
        patch.first_vertex = sheet.first_vertex;
        patch.is_in_order = sheet.grid_order.empty() && !mirrored;
        patch.first_face = sheet.first_face;
        patch.face_count = sheet.face_count;
        for (int j = 0; j < sheet.rows; ++j)
            for (int i = 0; i < sheet.columns; ++i)
                patch.vertices.push_back(sheet.grid_vertex(mirrored ? patch.columns - i : i, j));
        if (!find_faces(patch, sheet, faces)) return std::nullopt;
        for (auto& list : patch.faces) list.resize(list.size() + kReadAhead, 0);
        if (patch.is_regular) return patch;
        if (!irregular) irregular = std::move(patch);
    }
    return irregular;
}

}  // namespace nuno
