// Cloth that several tests start from.
#include "support/sheets.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace nuno {

SheetSource square_sheet(int count, float side, std::vector<std::uint32_t> pins)
{
    SheetSource source;
    source.name = "square";
    source.mesh = grid_mesh(count, count, {0, 0, 0}, {side, 0, 0}, {0, -side, 0});
    source.columns = source.rows = count;
    source.pins = std::move(pins);
    return source;
}

ClothModel square_cloth(int count, float side, std::vector<std::uint32_t> pins, MassLumping lumping)
{
    const SheetSource source = square_sheet(count, side, std::move(pins));
    return build_cloth_model(std::span(&source, 1), lumping);
}

SheetSource square_mesh(int count, float side, std::size_t window)
{
    SheetSource source = square_sheet(count, side);
    source.columns = source.rows = 0;
    const TriangleMesh ordered = source.mesh;
    std::vector<std::uint32_t> place(ordered.positions.size());
    std::iota(place.begin(), place.end(), 0u);
    std::mt19937 random(7);
    for (std::size_t i = 0; window > 1 && i + window <= place.size(); i += window)
        std::shuffle(place.begin() + std::ptrdiff_t(i), place.begin() + std::ptrdiff_t(i + window), random);
    for (std::size_t i = 0; i < place.size(); ++i) {
        source.mesh.positions[place[i]] = ordered.positions[i];
        source.mesh.uvs[place[i]] = ordered.uvs[i];
    }
    for (glm::uvec3& face : source.mesh.faces) face = {place[face.x], place[face.y], place[face.z]};
    return source;
}

TriangleMesh cut_at_random(TriangleMesh grid, int columns, int rows)
{
    std::mt19937 random(5);
    grid.faces.clear();
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const auto a = static_cast<std::uint32_t>(j * columns + i), b = a + 1;
            const std::uint32_t c = a + static_cast<std::uint32_t>(columns), d = c + 1;
            const bool falls = random() % 2 == 0;
            grid.faces.emplace_back(a, c, falls ? d : b);
            grid.faces.emplace_back(falls ? a : b, falls ? d : c, falls ? b : d);
        }
    return grid;
}

}  // namespace nuno
