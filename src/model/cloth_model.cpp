// Puts the sheets of a scene together.
#include "model/cloth_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "model/springs.h"

namespace nuno {
namespace {

std::vector<float> vertex_areas(const TriangleMesh& mesh, MassLumping lumping)
{
    std::vector<float> areas(mesh.positions.size());
    for (const glm::uvec3& face : mesh.faces) {
        const float third = face_area(mesh, face) / 3;
        for (int k = 0; k < 3; ++k) areas[face[k]] += third;
    }
    if (lumping == MassLumping::equal) {
        const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
        areas.assign(areas.size(), static_cast<float>(total / double(areas.size())));
    }
    return areas;
}

void check_source(const SheetSource& source, const std::string& where)
{
    check_mesh(source.mesh, where);
    if (!source.start.empty() && source.start.size() != source.mesh.positions.size())
        throw Error(fmt::format("{}: {} start positions for {} vertices; give one for each", where, source.start.size(),
                                source.mesh.positions.size()));
    std::vector<std::uint32_t> pins = source.pins;
    for (const HandlePin& pin : source.handle_pins) pins.push_back(pin.vertex);
    for (const std::uint32_t pin : pins)
        if (pin >= source.mesh.positions.size())
            throw Error(fmt::format("{}: pin {} names no vertex; there are {} (0 to {})", where, pin,
                                    source.mesh.positions.size(), source.mesh.positions.size() - 1));
}

// The warp of a grid runs along its columns.
glm::vec3 grid_warp(const SheetSource& source)
{
    const std::size_t below = static_cast<std::size_t>(source.columns);
    const std::uint32_t top = source.grid_order.empty() ? 0 : source.grid_order[0];
    const std::uint32_t next = source.grid_order.empty() ? static_cast<std::uint32_t>(below) : source.grid_order[below];
    return glm::normalize(source.mesh.positions[next] - source.mesh.positions[top]);
}

void append_handle_pins(ClothModel& model, const SheetSource& source, std::uint32_t first)
{
    const auto added = static_cast<std::ptrdiff_t>(model.handle_pins.size());
    for (const HandlePin& pin : source.handle_pins) {
        model.pinned[first + pin.vertex] = 1;
        model.handle_pins.push_back({first + pin.vertex, pin.handle});
    }
    std::stable_sort(model.handle_pins.begin() + added, model.handle_pins.end(),
                     [](const HandlePin& a, const HandlePin& b) { return a.vertex < b.vertex; });
    const auto same = [](const HandlePin& a, const HandlePin& b) { return a.vertex == b.vertex; };
    model.handle_pins.erase(std::unique(model.handle_pins.begin() + added, model.handle_pins.end(), same),
                            model.handle_pins.end());
}

void append_sheet(ClothModel& model, const SheetSource& source, MassLumping lumping)
{
    check_source(source, fmt::format("sheet {}", source.name));
    const TriangleMesh& mesh = source.mesh;
    const std::uint32_t first = model.vertex_count();
    model.sheets.push_back({source.name, first, static_cast<std::uint32_t>(mesh.positions.size()),
                            static_cast<std::uint32_t>(model.faces.size()),
                            static_cast<std::uint32_t>(mesh.faces.size()), source.columns, source.rows,
                            source.grid_order});

    const std::vector<glm::vec3>& start = source.start.empty() ? mesh.positions : source.start;
    const std::vector<float> areas = vertex_areas(mesh, lumping);
    model.rest_positions.insert(model.rest_positions.end(), mesh.positions.begin(), mesh.positions.end());
    model.start_positions.insert(model.start_positions.end(), start.begin(), start.end());
    model.uvs.insert(model.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    model.uvs.resize(model.rest_positions.size());
    model.areas.insert(model.areas.end(), areas.begin(), areas.end());
    model.pinned.resize(model.rest_positions.size());
    for (const std::uint32_t pin : source.pins) model.pinned[first + pin] = 1;
    append_handle_pins(model, source, first);
    for (const glm::uvec3& face : mesh.faces) {
        model.faces.push_back(face + first);
        model.face_warps.push_back(source.columns > 0 ? grid_warp(source) : face_warp(mesh, face));
    }

    const Sheet& sheet = model.sheets.back();
    if (sheet.is_grid())
        append_grid_springs(model.springs, model.rest_positions, sheet);
    else
        append_mesh_springs(model.springs, model.rest_positions, std::span(model.faces).last(mesh.faces.size()),
                            std::span(model.face_warps).last(mesh.faces.size()));
}

// Copies count on from the vertices of all sheets.
TextureSeams joined_seams(const ClothModel& model, std::span<const SheetSource> sources)
{
    TextureSeams seams;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const TriangleMesh& mesh = sources[s].mesh;
        const Sheet& sheet = model.sheets[s];
        const auto first_copy = static_cast<std::uint32_t>(model.vertex_count() + seams.vertices.size());
        for (glm::uvec3 face : mesh.seams.empty() ? mesh.faces : mesh.seams.faces) {
            for (int k = 0; k < 3; ++k)
                face[k] = face[k] < sheet.vertex_count ? sheet.first_vertex + face[k]
                                                       : first_copy + face[k] - sheet.vertex_count;
            seams.faces.push_back(face);
        }
        for (const std::uint32_t vertex : mesh.seams.vertices) seams.vertices.push_back(sheet.first_vertex + vertex);
        seams.uvs.insert(seams.uvs.end(), mesh.seams.uvs.begin(), mesh.seams.uvs.end());
    }
    if (seams.vertices.empty()) seams.faces.clear();
    return seams;
}

}  // namespace

ClothModel build_cloth_model(std::span<const SheetSource> sheets, MassLumping lumping)
{
    ClothModel model;
    for (const SheetSource& source : sheets) append_sheet(model, source, lumping);
    model.spring_table = make_spring_table(model.springs, model.vertex_count());
    model.seams = joined_seams(model, sheets);
    return model;
}

TriangleMesh grid_mesh(int columns, int rows, glm::vec3 origin, glm::vec3 across, glm::vec3 down)
{
    TriangleMesh mesh;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const glm::vec2 place(float(i) / float(columns - 1), float(j) / float(rows - 1));
            mesh.positions.push_back(origin + place.x * across + place.y * down);
            mesh.uvs.emplace_back(place.x, 1 - place.y);
        }
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const auto a = static_cast<std::uint32_t>(j * columns + i);
            const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(columns), d = c + 1;
            mesh.faces.emplace_back(a, c, d);
            mesh.faces.emplace_back(a, d, b);
        }
    return mesh;
}

}  // namespace nuno
