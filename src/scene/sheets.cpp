// Makes the meshes and pins of a scene's sheets.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "model/grid_recovery.h"
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
    if (resolution == 1)
        throw Error(fmt::format("{}: resolution = 1 is no grid; give 2 or more vertices, or 0 for the scene's own",
                                sheet.where));
    const auto scaled = [&](int side) {
        const double cells = double(side - 1) / double(std::max(sheet.columns, sheet.rows) - 1) * (resolution - 1);
        return std::max(2, static_cast<int>(std::lround(cells)) + 1);
    };
    return {scaled(sheet.columns), scaled(sheet.rows)};
}

struct Place
{
    std::string_view name;
    double i0, i1, j0, j1;  // part of the grid, 0 .. 1
};

// The vertex of a grid that is nearest to a part (0 .. 1) of a side.
int at_part(double part, int count) { return static_cast<int>(std::lround(part * (count - 1))); }

void add_pins_at(std::string_view text, const std::string& where, GridSize size, std::vector<std::uint32_t>& pins)
{
    static constexpr Place places[] = {
        {"top_left", 0, 0, 0, 0},     {"top_right", 1, 1, 0, 0}, {"bottom_left", 0, 0, 1, 1},
        {"bottom_right", 1, 1, 1, 1}, {"top", 0, 1, 0, 0},       {"bottom", 0, 1, 1, 1},
        {"left", 0, 0, 0, 1},         {"right", 1, 1, 0, 1},     {"centre", 0.5, 0.5, 0.5, 0.5}};
    const std::size_t mark = text.find('@');
    const std::string_view name = text.substr(0, mark);
    const double part = mark == text.npos ? 0 : parse_number(text.substr(mark + 1)).value_or(-1);
    if (!(part >= 0 && part <= 1))
        throw Error(fmt::format("{}: pin {}: the part of the edge after @ must be a number from 0 to 1", where, text));
    std::vector<std::string_view> names;
    for (Place p : places) {
        names.push_back(p.name);
        if (p.name != name) continue;
        if (mark != text.npos && p.i0 == p.i1 && p.j0 == p.j1)
            throw Error(fmt::format("{}: pin {}: {} is one vertex, which has no parts; @ goes after an edge", where,
                                    text, name));
        if (mark != text.npos && p.i0 != p.i1) p.i0 = p.i1 = part;
        if (mark != text.npos && p.j0 != p.j1) p.j0 = p.j1 = part;
        for (int j = at_part(p.j0, size.rows); j <= at_part(p.j1, size.rows); ++j)
            for (int i = at_part(p.i0, size.columns); i <= at_part(p.i1, size.columns); ++i)
                pins.push_back(static_cast<std::uint32_t>(j * size.columns + i));
        return;
    }
    throw Error(fmt::format(
        "{}: pin place {} is unknown; the nearest is {}; possible are {}, and top@0.25 for a part of an edge", where,
        name, nearest_name(name, names), join_choices(names)));
}

// Start positions folded like an accordion along the grid's columns: `pleats` plane strips, each tilted by the angle
// against the flat sheet, so that no thread is stretched. The middle stays where it is.
std::vector<glm::vec3> pleated(const SheetSpec& sheet, const TriangleMesh& mesh)
{
    const float width = glm::length(sheet.across), strip = width / static_cast<float>(sheet.pleats);
    const glm::vec3 along = sheet.across / width, up = glm::normalize(glm::cross(sheet.down, sheet.across));
    const float angle = glm::radians(sheet.pleat_angle), c = std::cos(angle), s = std::sin(angle);
    std::vector<glm::vec3> start;
    for (const glm::vec3& p : mesh.positions) {
        const float u = glm::dot(p - sheet.origin, along);
        const int number = std::min(sheet.pleats - 1, static_cast<int>(u / strip));
        const float rest = u - static_cast<float>(number) * strip;
        const float height = (number % 2 == 0 ? rest : strip - rest) * s;
        start.push_back(p + (u * c + width * (1 - c) / 2 - u) * along + height * up);
    }
    return start;
}

// Index of a handle by its name.
std::uint32_t handle_number(const Scene& scene, const PinSpec& spec)
{
    std::vector<std::string_view> names;
    for (const Handle& handle : scene.bodies.handles) {
        if (handle.name == spec.handle) return static_cast<std::uint32_t>(names.size());
        names.push_back(handle.name);
    }
    if (names.empty())
        throw Error(fmt::format("{}: there is no [[handle]]; add one named {}", spec.where, spec.handle));
    throw Error(fmt::format("{}: handle {} is unknown; the nearest is {}; there are {}", spec.where, spec.handle,
                            nearest_name(spec.handle, names), join_choices(names)));
}

// Pins the vertices of a group of the mesh file.
void add_group(const std::string& name, const std::string& where, const SheetSpec& sheet, const TriangleMesh& mesh,
               std::vector<std::uint32_t>& pins)
{
    if (const auto group = mesh.groups.find(name); group != mesh.groups.end()) {
        pins.insert(pins.end(), group->second.begin(), group->second.end());
        return;
    }
    std::vector<std::string_view> names;
    for (const auto& [other, vertices] : mesh.groups) names.push_back(other);
    const std::string there =
        names.empty() ? "it has no groups, so give vertex numbers"
                      : fmt::format("the nearest is {}; there are {}", nearest_name(name, names), join_choices(names));
    throw Error(
        fmt::format("{}: pin {} is no group (a line `g {}`) of {}; {}", where, name, name, sheet.mesh.string(), there));
}

// Vertex numbers from 0, separated by spaces, commas or lines; # begins a comment.
void add_pins_of_file(const std::filesystem::path& path, std::vector<std::uint32_t>& pins)
{
    std::istringstream lines(read_text(path));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        line.resize(std::min(line.size(), line.find('#')));
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            const double vertex = parse_number(word).value_or(-1);
            if (!(vertex >= 0 && vertex <= 0xffffffff) || vertex != std::floor(vertex))
                throw Error(fmt::format("{}:{}: '{}' is no vertex number; give whole numbers from 0", path.string(),
                                        number, word));
            pins.push_back(static_cast<std::uint32_t>(vertex));
        }
    }
    if (pins.empty()) throw Error(fmt::format("{}: names no vertex; give their numbers, from 0", path.string()));
}

// Stores the vertices that a sheet's file names as pinned. `size` is that of a grid, 0 x 0 of a mesh.
void add_pins(const Scene& scene, const SheetSpec& sheet, GridSize size, SheetSource& source)
{
    std::map<std::uint32_t, const PinSpec*> taken;
    for (const PinSpec& spec : sheet.pins) {
        std::vector<std::uint32_t> pins;
        if (!spec.file.empty()) add_pins_of_file(spec.file, pins);
        pins.insert(pins.end(), spec.vertices.begin(), spec.vertices.end());
        for (const std::string& place : spec.places)
            if (size.columns > 0)
                add_pins_at(place, spec.where, size, pins);
            else
                add_group(place, spec.where, sheet, source.mesh, pins);
        for (const std::uint32_t vertex : pins) {
            const PinSpec* other = taken.emplace(vertex, &spec).first->second;
            if (other->handle != spec.handle)
                throw Error(fmt::format("{}: vertex {} is pinned by {} already; leave it to one of them", spec.where,
                                        vertex, other->where));
            if (spec.handle.empty())
                source.pins.push_back(vertex);
            else
                source.handle_pins.push_back({vertex, handle_number(scene, spec)});
        }
    }
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
            add_pins(scene, sheet, size, source);
            check_mesh(source.mesh, sheet.where);
            if (sheet.pleats > 0) source.start = pleated(sheet, source.mesh);
        } else {
            source.mesh = load_obj(sheet.mesh);
            if (std::optional<RecoveredGrid> grid = recover_grid(source.mesh)) {
                source.columns = grid->columns;
                source.rows = grid->rows;
                source.grid_order = std::move(grid->order);
            }
            add_pins(scene, sheet, {0, 0}, source);
        }
        sources.push_back(std::move(source));
    }
    return sources;
}

}  // namespace nuno
