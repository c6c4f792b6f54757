// Colours vertices and gives them places.
#include "model/vertex_colours.h"

#include <algorithm>

namespace nuno {
namespace {

constexpr int kGridColours = 5;

// The vertices of one sheet by colour.
using ByColour = std::vector<std::vector<std::uint32_t>>;

// Colour, then row mod 5, then row: the vertices of a colour lie alike in rows that are 5 apart, so that the way to a
// neighbour is the same number of places all through such rows.
ByColour coloured_grid(const Sheet& sheet)
{
    const int width = (sheet.columns + kGridColours - 1) / kGridColours;
    ByColour colours(kGridColours);
    for (int colour = 0; colour < kGridColours; ++colour)
        for (int phase = 0; phase < kGridColours; ++phase)
            for (int j = phase; j < sheet.rows; j += kGridColours)
                for (int t = 0; t < width; ++t) {
                    const int i = (colour + 3 * j) % kGridColours + kGridColours * t;  // i + 2 j = colour (mod 5)
                    colours[static_cast<std::size_t>(colour)].push_back(i < sheet.columns ? sheet.grid_vertex(i, j)
                                                                                          : VertexColours::kNoVertex);
                }
    return colours;
}

ByColour coloured_greedily(const SpringTable& table, const Sheet& sheet)
{
    ByColour colours;
    std::vector<std::size_t> colour_of(sheet.vertex_count, ~std::size_t(0));
    for (std::uint32_t v = sheet.first_vertex; v < sheet.first_vertex + sheet.vertex_count; ++v) {
        std::vector<bool> taken(colours.size() + 1);
        for (int slot = 0; slot < table.slot_count(); ++slot) {
            const std::uint32_t other = table.neighbours[static_cast<std::size_t>(slot) * table.vertex_count + v];
            const std::size_t colour = colour_of[other - sheet.first_vertex];
            if (colour < taken.size()) taken[colour] = true;
        }
        const auto free = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
        if (free == colours.size()) colours.emplace_back();
        colours[free].push_back(v);
        colour_of[v - sheet.first_vertex] = free;
    }
    return colours;
}

SpringTable placed_table(const SpringTable& from, const VertexColours& colours)
{
    SpringTable table;
    table.vertex_count = colours.place_count();
    table.first_slot = from.first_slot;
    for (int slot = 0; slot < from.slot_count(); ++slot)
        for (std::uint32_t place = 0; place < table.vertex_count; ++place) {
            const std::uint32_t vertex = colours.vertices[place];
            const bool fills = vertex == VertexColours::kNoVertex;
            const std::size_t entry = static_cast<std::size_t>(slot) * from.vertex_count + vertex;
            table.neighbours.push_back(fills ? place : colours.places[from.neighbours[entry]]);
            table.springs.push_back(fills ? SpringTable::kNoSpring : from.springs[entry]);
        }
    return table;
}

// `values` by vertex, in their places.
template <class T>
std::vector<T> placed(const std::vector<T>& values, const VertexColours& colours)
{
    std::vector<T> by_place(colours.place_count(), T{});
    for (std::size_t vertex = 0; vertex < values.size(); ++vertex) by_place[colours.places[vertex]] = values[vertex];
    return by_place;
}

}  // namespace

VertexColours colour_vertices(const ClothModel& model, std::uint32_t grain)
{
    std::vector<ByColour> sheets;
    std::size_t colour_count = 0;
    for (const Sheet& sheet : model.sheets) {
        sheets.push_back(sheet.is_grid() ? coloured_grid(sheet) : coloured_greedily(model.spring_table, sheet));
        colour_count = std::max(colour_count, sheets.back().size());
    }
    VertexColours colours;
    colours.places.resize(model.vertex_count());
    for (std::size_t colour = 0; colour < colour_count; ++colour) {
        colours.first_place.push_back(colours.place_count());
        for (const ByColour& sheet : sheets)
            if (colour < sheet.size())
                colours.vertices.insert(colours.vertices.end(), sheet[colour].begin(), sheet[colour].end());
        colours.vertices.resize((colours.vertices.size() + grain - 1) / grain * grain, VertexColours::kNoVertex);
    }
    colours.first_place.push_back(colours.place_count());
    for (std::uint32_t place = 0; place < colours.place_count(); ++place)
        if (colours.vertices[place] != VertexColours::kNoVertex) colours.places[colours.vertices[place]] = place;
    return colours;
}

ClothModel placed_model(const ClothModel& model, const VertexColours& colours)
{
    ClothModel result = model;
    result.rest_positions = placed(model.rest_positions, colours);
    result.start_positions = placed(model.start_positions, colours);
    result.uvs = placed(model.uvs, colours);
    result.areas = placed(model.areas, colours);
    result.pinned = placed(model.pinned, colours);
    for (glm::uvec3& face : result.faces)
        for (int k = 0; k < 3; ++k) face[k] = colours.places[face[k]];
    for (HandlePin& pin : result.handle_pins) pin.vertex = colours.places[pin.vertex];
    std::sort(result.handle_pins.begin(), result.handle_pins.end(),
              [](const HandlePin& a, const HandlePin& b) { return a.vertex < b.vertex; });
    for (Spring& spring : result.springs) {
        spring.a = colours.places[spring.a];
        spring.b = colours.places[spring.b];
    }
    result.spring_table = placed_table(model.spring_table, colours);
    result.sheets.clear();
    result.seams = {};
    return result;
}

}  // namespace nuno
