// A sheet with folds, hung by its upper edge: the cloth that the pictures of these tests show.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/files.h"
#include "render/cloth_renderer.h"

namespace nuno {

struct BentSheet
{
    std::vector<glm::vec4> positions;
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> faces;
    std::vector<DrawnSheet> sheets;

    ClothTopology topology() const { return {static_cast<std::uint32_t>(positions.size()), faces, uvs, sheets, {}}; }
};

inline std::filesystem::path texture_path(const char* name) { return root_directory() / "assets/textures" / name; }

// About 1 m wide and high around (0, 0.5, 0), `side` x `side` vertices, its front towards +z.
inline BentSheet bent_sheet(std::uint32_t side, const std::filesystem::path& texture)
{
    BentSheet sheet;
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const float u = float(column) / float(side - 1), down = float(row) / float(side - 1);
            const float fold = 0.10f * std::sin(14 * u + 1.5f * down) + 0.05f * std::sin(5 * u + 3 * down);
            sheet.positions.emplace_back((u - 0.5f) * (1 - 0.18f * down * down), 1 - 0.95f * down,
                                         down * (fold + 0.2f * down), 1);
            sheet.uvs.emplace_back(u, 1 - down);
        }
    for (std::uint32_t row = 0; row + 1 < side; ++row)
        for (std::uint32_t column = 0; column + 1 < side; ++column) {
            const std::uint32_t a = row * side + column, b = a + side;
            sheet.faces.emplace_back(a, b, a + 1);
            sheet.faces.emplace_back(a + 1, b, b + 1);
        }
    sheet.sheets = {{0, static_cast<std::uint32_t>(sheet.faces.size()), texture}};
    return sheet;
}

}  // namespace nuno
