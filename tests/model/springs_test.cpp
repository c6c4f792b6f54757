// Which vertices springs join, and the table they are gathered from.
#include "model/springs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "support/sheets.h"

namespace nuno {
namespace {

std::map<SpringKind, int> springs_of(const ClothModel& model, std::uint32_t vertex)
{
    std::map<SpringKind, int> counts;
    for (const Spring& spring : model.springs)
        if (spring.a == vertex || spring.b == vertex) ++counts[spring.kind];
    return counts;
}

TEST(GridSprings, an_inner_vertex_has_the_seeds_twelve)
{
    const ClothModel model = square_cloth(17, 1);
    const auto inner = springs_of(model, 8 * 17 + 8);
    EXPECT_EQ(inner.at(SpringKind::weft), 2);
    EXPECT_EQ(inner.at(SpringKind::warp), 2);
    EXPECT_EQ(inner.at(SpringKind::shear), 4);
    EXPECT_EQ(inner.at(SpringKind::bend_weft), 2);
    EXPECT_EQ(inner.at(SpringKind::bend_warp), 2);
    const auto corner = springs_of(model, 0);
    EXPECT_EQ(corner.at(SpringKind::weft), 1);
    EXPECT_EQ(corner.at(SpringKind::warp), 1);
    EXPECT_EQ(corner.at(SpringKind::shear), 1);
    EXPECT_EQ(corner.at(SpringKind::bend_weft), 1);
    EXPECT_EQ(corner.at(SpringKind::bend_warp), 1);
    // 2 n (n-1) threads, 2 (n-1)^2 shear, 2 n (n-2) bend.
    EXPECT_EQ(model.springs.size(), 2u * 17 * 16 + 2 * 16 * 16 + 2 * 17 * 15);
}

TEST(GridSprings, the_twelve_neighbours_are_those_of_figure_2_1)
{
    const ClothModel model = square_cloth(5, 1);
    const int middle = 2 * 5 + 2;
    std::set<std::pair<int, int>> offsets;
    for (const Spring& spring : model.springs) {
        if (int(spring.a) != middle && int(spring.b) != middle) continue;
        const int other = int(spring.a) == middle ? int(spring.b) : int(spring.a);
        offsets.insert({other % 5 - 2, other / 5 - 2});
    }
    const std::set<std::pair<int, int>> expected{{1, 0},  {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1},
                                                 {1, -1}, {-1, 1}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}};
    EXPECT_EQ(offsets, expected);
}

TEST(MeshSprings, join_every_edge_once_and_the_corners_across_it)
{
    // Two triangles: five edges, one of them inner.
    std::vector<Spring> springs;
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<glm::uvec3> faces{{0, 1, 2}, {0, 2, 3}};
    append_mesh_springs(springs, positions, faces, std::vector<glm::vec3>(2, {0, 1, 0}));
    ASSERT_EQ(springs.size(), 6u);
    EXPECT_EQ(springs.back().kind, SpringKind::hinge);
    EXPECT_EQ(std::set<std::uint32_t>({springs.back().a, springs.back().b}), std::set<std::uint32_t>({1, 3}));
}

// The plate's energy of a flat sheet is 0, but for rounding. A cell as narrow as `t` has cotangents of 1 / t, and weights
// of their squares over its area; past what a float holds of them, the hinges of such cells have no weight at all.
TEST(MeshSprings, a_flat_mesh_stores_no_bending_however_narrow_a_row_of_it)
{
    for (const float t : {1.0f, 1e-1f, 1e-2f, 1e-4f, 1e-5f, 1e-6f}) {
        SheetSource sheet = square_mesh(9, 1);
        for (glm::vec3& p : sheet.mesh.positions)
            if (p.y == -0.125f) p.y *= t;
        const ClothModel model = build_cloth_model(std::span(&sheet, 1), MassLumping::area);
        double energy = 0;  // over D
        for (const Spring& spring : model.springs)
            energy += double(spring.plate.x + spring.plate.y) * double(spring.rest_length) * spring.rest_length / 2;
        if (t > 1e-3f)
            EXPECT_LT(std::abs(energy), 1) << t;
        else
            EXPECT_LT(std::abs(energy), 1e-4) << t;
    }
}

TEST(SpringTable, holds_every_spring_from_both_ends_and_nothing_else)
{
    for (const SheetSource& source : {square_sheet(7, 1), square_mesh(7, 1, 49)}) {
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        const SpringTable& table = model.spring_table;
        std::size_t found = 0;
        for (int group = 0; group < kSpringGroupCount; ++group) {
            EXPECT_EQ(table.first_slot[group] % 4, 0);
            for (int slot = table.first_slot[group]; slot < table.first_slot[group + 1]; ++slot)
                for (std::uint32_t v = 0; v < table.vertex_count; ++v) {
                    const std::size_t entry = std::size_t(slot) * table.vertex_count + v;
                    const std::uint32_t neighbour = table.neighbours[entry], index = table.springs[entry];
                    if (index == SpringTable::kNoSpring) {
                        EXPECT_EQ(neighbour, v);
                        continue;
                    }
                    ++found;
                    const Spring& spring = model.springs[index];
                    EXPECT_EQ(spring_group(spring.kind), group);
                    EXPECT_TRUE((spring.a == v && spring.b == neighbour) || (spring.b == v && spring.a == neighbour));
                    EXPECT_FLOAT_EQ(spring.rest_length,
                                    glm::distance(model.rest_positions[v], model.rest_positions[neighbour]));
                }
        }
        EXPECT_EQ(found, 2 * model.springs.size());
    }
}

TEST(SpringTable, a_vertex_with_too_many_neighbours_is_refused)
{
    SheetSource fan;
    fan.mesh.positions.emplace_back(0, 0, 0);
    constexpr std::uint32_t kSpokes = 300;
    for (std::uint32_t i = 0; i < kSpokes; ++i) {
        const float angle = 6.2831853f * float(i) / kSpokes;
        fan.mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
        fan.mesh.faces.emplace_back(0, 1 + i, 1 + (i + 1) % kSpokes);
    }
    EXPECT_THROW(build_cloth_model(std::span(&fan, 1), MassLumping::area), Error);
}

}  // namespace
}  // namespace nuno
