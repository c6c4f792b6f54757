// Makes the meshes and pins of a scene's sheets.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "scene/scene.h"

namespace nuno {
namespace {

struct GridSize
{
    int columns, rows;
};

// The scene's grid, or one whose longer side has `resolution` vertices and whose cells keep their shape.
GridSize grid_size(const SheetSpec& sheet, int resolution)
{
    if (resolution == 0) return {sheet.columns, sheet.rows};
    const auto scaled = [&](int side) {
        const double cells = double(side - 1) / double(std::max(sheet.columns, sheet.rows) - 1) * (resolution - 1);
        return std::max(2, static_cast<int>(std::lround(cells)) + 1);
    };
    return {scaled(sheet.columns), scaled(sheet.rows)};
}

void add_pins_at(std::string_view place, const SheetSpec& sheet, GridSize size, std::vector<std::uint32_t>& pins)
{
    struct Place
    {
        std::string_view name;
        double i0, i1, j0, j1;  // part of the grid, 0 .. 1
    };
    static constexpr Place places[] = {
        {"top_left", 0, 0, 0, 0},     {"top_right", 1, 1, 0, 0}, {"bottom_left", 0, 0, 1, 1},
        {"bottom_right", 1, 1, 1, 1}, {"top", 0, 1, 0, 0},       {"bottom", 0, 1, 1, 1},
        {"left", 0, 0, 0, 1},         {"right", 1, 1, 0, 1},     {"top_middle", 0.5, 0.5, 0, 0}};
    std::vector<std::string_view> names;
    for (const Place& p : places) {
        names.push_back(p.name);
        if (p.name != place) continue;
        const auto at = [](double part, int count) { return static_cast<int>(std::lround(part * (count - 1))); };
        for (int j = at(p.j0, size.rows); j <= at(p.j1, size.rows); ++j)
            for (int i = at(p.i0, size.columns); i <= at(p.i1, size.columns); ++i)
                pins.push_back(static_cast<std::uint32_t>(j * size.columns + i));
        return;
    }
    throw Error(fmt::format("{}: pin place {} is unknown; the nearest is {}; possible are {}", sheet.where, place,
                            nearest_name(place, names), join_choices(names)));
}

}  // namespace

std::vector<SheetSource> make_sheets(const Scene& scene, const SimParams& params)
{
    std::vector<SheetSource> sources;
    for (const SheetSpec& sheet : scene.sheets) {
        SheetSource source;
        source.name = sheet.name;
        if (sheet.mesh.empty()) {
            const GridSize size = grid_size(sheet, params.resolution);
            source.mesh = grid_mesh(size.columns, size.rows, sheet.origin, sheet.across, sheet.down);
            source.columns = size.columns;
            source.rows = size.rows;
            for (const std::string& place : sheet.pin_places) add_pins_at(place, sheet, size, source.pins);
            check_mesh(source.mesh, sheet.where);
        } else {
            source.mesh = load_obj(sheet.mesh);
            if (!sheet.pin_places.empty())
                throw Error(fmt::format("{}: pin {} is a place of a grid; a mesh is pinned by vertex numbers",
                                        sheet.where, sheet.pin_places.front()));
        }
        source.pins.insert(source.pins.end(), sheet.pin_vertices.begin(), sheet.pin_vertices.end());
        sources.push_back(std::move(source));
    }
    return sources;
}

}  // namespace nuno
