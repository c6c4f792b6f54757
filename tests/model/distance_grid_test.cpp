// Closed meshes as grids of distances, against closed forms; and meshes that are refused.
#include "model/distance_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "model/formulas.h"
#include "model/triangle_tree.h"
#include "support/body_meshes.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// The grid read as the solvers do.
formulas::Surface surface_at(const DistanceGrid& grid, glm::vec3 q)
{
    const formulas::GridPlace place =
        formulas::grid_place(q, grid.origin, grid.cell, 1 / grid.cell, glm::vec3(grid.cells));
    const int row = grid.cells.x + 1, layer = row * (grid.cells.y + 1);
    const int node = int(place.cell.z) * layer + int(place.cell.y) * row + int(place.cell.x);
    const float* v = grid.values.data() + node;
    return formulas::grid_surface(
        place, {{v[0], v[1]}, {v[row], v[row + 1]}, {v[layer], v[layer + 1]}, {v[layer + row], v[layer + row + 1]}});
}

template <class Visit>
void for_each_node(const DistanceGrid& grid, Visit visit)
{
    std::size_t number = 0;
    for (int k = 0; k <= grid.cells.z; ++k)
        for (int j = 0; j <= grid.cells.y; ++j)
            for (int i = 0; i <= grid.cells.x; ++i)
                visit(glm::dvec3(grid.origin) + double(grid.cell) * glm::dvec3(i, j, k), grid.values[number++]);
    EXPECT_EQ(number, grid.values.size());
}

TEST(DistanceGrid, nodes_of_a_box_are_exact)
{
    const glm::vec3 size(1, 0.6f, 0.4f);
    const DistanceGrid grid = make_distance_grid(box_mesh(size), 0, "box");
    for_each_node(grid, [&](const glm::dvec3& p, float value) {
        EXPECT_NEAR(value, formulas_f64::box_surface(p, 0.5 * glm::dvec3(size)).distance, 2e-7);
    });
}

TEST(DistanceGrid, between_the_nodes_a_box_is_exact_away_from_its_edges_and_round_by_a_part_of_a_cell_at_them)
{
    const glm::vec3 size(1, 0.6f, 0.4f);
    const DistanceGrid grid = make_distance_grid(box_mesh(size), 0.02f, "box");
    std::mt19937 random(4);
    std::uniform_real_distribution<float> at(-1, 1);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 q = 0.52f * size * glm::vec3(at(random), at(random), at(random));
        const formulas::Surface exact = formulas::box_surface(q, 0.5f * size), read = surface_at(grid, q);
        EXPECT_NEAR(read.distance, exact.distance, 0.75f * grid.cell);
        const glm::vec3 depth = 0.5f * size - glm::abs(q);
        float sorted[3] = {depth.x, depth.y, depth.z};
        std::sort(sorted, sorted + 3);
        // Distances are linear where one face is nearer than every other, also the opposite one, by more than the
        // cell's diagonal.
        if (sorted[1] - std::max(sorted[0], 0.0f) < 1.8f * grid.cell || sorted[0] > 0.2f - 0.9f * grid.cell) continue;
        EXPECT_NEAR(read.distance, exact.distance, 1e-6f);
        EXPECT_LE(glm::distance(read.normal, exact.normal), 1e-4f);
    }
}

TEST(DistanceGrid, far_outside_it_is_further_than_the_grid_and_never_inside)
{
    const DistanceGrid grid = make_distance_grid(box_mesh({1, 1, 1}), 0.1f, "box");
    EXPECT_NEAR(surface_at(grid, {3, 0, 0}).distance, 2.5f, 1e-4f);
    for (const float x : {-50.0f, 0.9f, 1e6f}) EXPECT_GT(surface_at(grid, {x, 0.7f * x, 2 * x}).distance, 0.2f);
}

// Solid angle of a triangle seen from p, over 4 pi (van Oosterom and Strackee 1983): the sum is 1 inside, 0 outside.
double winding_number(const TriangleMesh& mesh, const glm::dvec3& p)
{
    double sum = 0;
    for (const glm::uvec3& face : mesh.faces) {
        const glm::dvec3 a = glm::dvec3(mesh.positions[face.x]) - p, b = glm::dvec3(mesh.positions[face.y]) - p,
                         c = glm::dvec3(mesh.positions[face.z]) - p;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        sum += std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return sum / (2 * 3.14159265358979323846);
}

TEST(DistanceGrid, the_sign_agrees_with_the_winding_number_where_edges_and_corners_turn_inwards)
{
    const TriangleMesh mesh = dented_box_mesh({1, 0.8f, 0.6f}, 0.7f);
    const DistanceGrid grid = make_distance_grid(mesh, 0.045f, "dented");
    int inside = 0;
    for_each_node(grid, [&](const glm::dvec3& p, float value) {
        if (std::abs(value) < 1e-6f) return;
        EXPECT_EQ(value<0, winding_number(mesh, p)> 0.5) << p.x << " " << p.y << " " << p.z;
        inside += value < 0;
    });
    EXPECT_GT(inside, 1000);
}

TEST(TriangleTree, finds_what_looking_at_every_face_finds)
{
    const TriangleMesh mesh = dented_box_mesh({1, 0.8f, 0.6f}, 0.5f);
    const TriangleTree tree(mesh);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(-1, 1);
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 p(at(random), at(random), at(random));
        double least = 1e9;
        for (const glm::uvec3& f : mesh.faces)
            least = std::min(
                least,
                nearest_on_triangle(p, mesh.positions[f.x], mesh.positions[f.y], mesh.positions[f.z]).distance_sq);
        EXPECT_NEAR(tree.nearest(p).distance_sq, least, 1e-14);
    }
}

std::string refusal(const TriangleMesh& mesh, float cell = 0)
{
    try {
        make_distance_grid(mesh, cell, "m.obj");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "accepted";
}

TEST(DistanceGrid, a_mesh_with_a_hole_is_refused_with_its_first_open_edge)
{
    TriangleMesh mesh = box_mesh({1, 1, 1});
    mesh.faces.pop_back();  // 4 7 6
    EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("m.obj: a body must be a closed mesh"),
                                     HasSubstr("vertex 4 to vertex 6"), HasSubstr("one side only")));
}

TEST(DistanceGrid, faces_that_disagree_or_look_inwards_are_refused)
{
    TriangleMesh one_turned = box_mesh({1, 1, 1});
    std::swap(one_turned.faces[3].x, one_turned.faces[3].y);
    EXPECT_THAT(refusal(one_turned), HasSubstr("turn one of them round"));
    TriangleMesh inside_out = box_mesh({1, 1, 1});
    for (glm::uvec3& face : inside_out.faces) std::swap(face.x, face.y);
    EXPECT_THAT(refusal(inside_out), AllOf(HasSubstr("look inwards"), HasSubstr("turn them all")));
    TriangleMesh twice = box_mesh({1, 1, 1});
    twice.faces.push_back(twice.faces[0]);
    EXPECT_THAT(refusal(twice), HasSubstr("has 3 faces"));
}

TEST(DistanceGrid, cells_too_small_to_hold_are_refused_with_a_size_that_holds)
{
    EXPECT_THAT(refusal(box_mesh({1, 1, 1}), 1e-3f), AllOf(HasSubstr("16 million"), HasSubstr("cell = 0.0041")));
}

}  // namespace
}  // namespace nuno
