// Grids found again in their triangles.
#include "model/grid_recovery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "model/cloth_model.h"

namespace nuno {
namespace {

// A grid of columns x rows with its vertices and faces in random order, its cells cut along random diagonals.
struct Shuffled
{
    TriangleMesh mesh;
    std::vector<std::uint32_t> place;  // where vertex j columns + i went
};

Shuffled shuffled_grid(int columns, int rows, bool with_texture, unsigned seed)
{
    TriangleMesh grid = grid_mesh(columns, rows, {1, 2, 3}, {1.5f, 0, 0}, {0, -0.8f, 0.6f});
    std::mt19937 random(seed);
    for (std::size_t f = 0; f + 1 < grid.faces.size(); f += 2) {
        const glm::uvec3 first = grid.faces[f], second = grid.faces[f + 1];  // a c d, a d b
        if (random() % 2)
            grid.faces[f] = {first[0], first[1], second[2]}, grid.faces[f + 1] = {second[2], first[1], first[2]};
    }
    Shuffled result;
    result.place.resize(grid.positions.size());
    std::iota(result.place.begin(), result.place.end(), 0u);
    std::shuffle(result.place.begin(), result.place.end(), random);
    std::shuffle(grid.faces.begin(), grid.faces.end(), random);
    result.mesh = grid;
    for (std::size_t v = 0; v < grid.positions.size(); ++v) {
        result.mesh.positions[result.place[v]] = grid.positions[v];
        result.mesh.uvs[result.place[v]] = grid.uvs[v];
    }
    if (!with_texture) result.mesh.uvs.clear();
    for (glm::uvec3& face : result.mesh.faces)
        face = {result.place[face.x], result.place[face.y], result.place[face.z]};
    return result;
}

TEST(GridRecovery, finds_rows_and_columns_in_any_order_of_vertices_and_any_diagonals)
{
    for (const auto& [columns, rows] : {std::pair{2, 2}, {2, 7}, {13, 5}, {31, 33}, {64, 64}})
        for (const bool with_texture : {true, false}) {
            const Shuffled shuffled = shuffled_grid(columns, rows, with_texture, 3);
            const auto grid = recover_grid(shuffled.mesh);
            ASSERT_TRUE(grid) << columns << " x " << rows;
            EXPECT_EQ(grid->columns, columns);
            EXPECT_EQ(grid->rows, rows);
            EXPECT_EQ(grid->order, shuffled.place) << (with_texture ? "texture" : "no texture");
        }
}

TEST(GridRecovery, a_rolled_sheet_is_a_grid_too)
{
    TriangleMesh cylinder = grid_mesh(20, 20, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
    for (glm::vec3& p : cylinder.positions) p = {std::sin(p.x), p.y, std::cos(p.x)};
    EXPECT_TRUE(recover_grid(cylinder));
}

TEST(GridRecovery, refuses_what_is_no_regular_grid)
{
    const auto refused = [](TriangleMesh mesh, const char* why) { EXPECT_FALSE(recover_grid(mesh)) << why; };
    const TriangleMesh grid = grid_mesh(6, 6, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
    TriangleMesh hole = grid;
    hole.faces.erase(hole.faces.begin() + 24, hole.faces.begin() + 26);
    refused(hole, "a cell is missing");
    TriangleMesh half = grid;
    half.faces.pop_back();
    refused(half, "half a cell is missing");
    TriangleMesh uneven = grid;
    uneven.positions[14].x += 0.01f;
    refused(uneven, "one vertex out of place");
    TriangleMesh fan;
    fan.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}};
    fan.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    refused(fan, "a fan");
    TriangleMesh triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.faces = {{0, 1, 2}};
    refused(triangle, "one triangle");
}

}  // namespace
}  // namespace nuno
