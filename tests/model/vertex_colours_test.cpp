// Colours of vertices: valid, complete, and in whole blocks.
#include "model/vertex_colours.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/sheets.h"

namespace nuno {
namespace {

constexpr std::uint32_t kGrain = 8;

std::vector<int> colour_of_places(const VertexColours& colours)
{
    std::vector<int> of(colours.place_count());
    for (int c = 0; c < colours.colour_count(); ++c)
        for (std::uint32_t p = colours.first_place[std::size_t(c)]; p < colours.first_place[std::size_t(c) + 1]; ++p)
            of[p] = c;
    return of;
}

void expect_valid(const ClothModel& model, const VertexColours& colours)
{
    const std::vector<int> colour = colour_of_places(colours);
    for (const Spring& spring : model.springs)
        ASSERT_NE(colour[colours.places[spring.a]], colour[colours.places[spring.b]])
            << "vertices " << spring.a << " and " << spring.b << " share a spring";
    std::vector<int> met(model.vertex_count());
    for (std::uint32_t place = 0; place < colours.place_count(); ++place) {
        const std::uint32_t vertex = colours.vertices[place];
        if (vertex == VertexColours::kNoVertex) continue;
        ++met[vertex];
        ASSERT_EQ(colours.places[vertex], place);
    }
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), std::ptrdiff_t(model.vertex_count())) << "each vertex has a place";
    for (const std::uint32_t first : colours.first_place) EXPECT_EQ(first % kGrain, 0u);
}

TEST(VertexColours, of_a_grid_are_five_and_no_two_neighbours_share_one)
{
    for (const int count : {2, 3, 17, 20}) {
        const ClothModel model = square_cloth(count, 1);
        const VertexColours colours = colour_vertices(model, kGrain);
        EXPECT_EQ(colours.colour_count(), 5);
        expect_valid(model, colours);
    }
}

TEST(VertexColours, of_meshes_and_of_several_sheets_are_valid)
{
    const SheetSource mesh = square_mesh(19, 1, 64), grid = square_sheet(9, 1);
    const std::vector<SheetSource> sheets{mesh, grid, square_mesh(5, 1)};
    for (const std::span<const SheetSource> chosen : {std::span(sheets).first(1), std::span(sheets)}) {
        const ClothModel model = build_cloth_model(chosen, MassLumping::area);
        const VertexColours colours = colour_vertices(model, kGrain);
        EXPECT_LE(colours.colour_count(), 12);
        expect_valid(model, colours);
    }
}

// The springs of a vertex, as (other end, number), are the same in both models.
TEST(VertexColours, place_the_model_without_changing_its_springs_and_faces)
{
    const SheetSource source = square_mesh(12, 1, 32);
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    const VertexColours colours = colour_vertices(model, kGrain);
    const ClothModel placed = placed_model(model, colours);
    const SpringTable &from = model.spring_table, &to = placed.spring_table;
    ASSERT_EQ(to.slot_count(), from.slot_count());
    for (int slot = 0; slot < from.slot_count(); ++slot)
        for (std::uint32_t v = 0; v < model.vertex_count(); ++v) {
            const std::size_t entry = std::size_t(slot) * from.vertex_count + v;
            const std::size_t place = std::size_t(slot) * to.vertex_count + colours.places[v];
            ASSERT_EQ(to.springs[place], from.springs[entry]);
            ASSERT_EQ(to.neighbours[place], colours.places[from.neighbours[entry]]);
        }
    for (std::size_t f = 0; f < model.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) ASSERT_EQ(colours.vertices[placed.faces[f][k]], model.faces[f][k]);
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v) ASSERT_EQ(placed.areas[colours.places[v]], model.areas[v]);
}

}  // namespace
}  // namespace nuno
