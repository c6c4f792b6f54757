// Cells proven apart from those around them, where the squares they are in are not: swept, on sheets creased here and
// there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "collision/tree/face_tree.h"
#include "collision/tree/grid_proof.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

constexpr int kSide = 35;  // vertices; 34 cells: the last squares are not full
constexpr float kSpacing = 1.0f / (kSide - 1), kDistance = 0.3f * kSpacing;
constexpr int kTimes = 4;  // steps of a way that are looked at

// Pushes single vertices towards others, over more than a cell.
void dent(std::vector<glm::vec4>& positions, int count, std::uint32_t seed)
{
    std::mt19937 bits(seed);
    for (int k = 0; k < count; ++k) {
        glm::vec4& p = positions[bits() % positions.size()];
        const float angle = static_cast<float>(bits() % 628) * 0.01f;
        p += kSpacing * glm::vec4(1.1f * std::cos(angle), 1.1f * std::sin(angle), 0.2f, 0);
    }
}

// A sheet in gentle waves that creases along one line on its way; single vertices are dented at its start and others at
// its end.
TreeCase creased(std::uint32_t seed)
{
    TreeCase cloth = as_grid("creased", flat_sheet(kSide), kSide, kSide);
    for (std::size_t v = 0; v < cloth.t0.size(); ++v) {
        const glm::vec3 p = cloth.rest[v];
        const float across = std::abs(p.x - 0.4f + 0.1f * p.y), wave = 0.02f * std::sin(7 * p.x + 3 * p.y);
        cloth.t0[v] = {0.9f * p.x, 0.9f * p.y, wave + 0.3f * across, 1};
        cloth.t1[v] = {0.6f * p.x, 0.9f * p.y, 2 - wave + 1.2f * across, 1};
    }
    dent(cloth.t0, 4, seed);
    dent(cloth.t1, 4, seed + 1);
    return cloth;
}

// A sheet at rest in its plane, its cells ever larger from one corner to the other: at the diagonal those that are just
// far enough apart are next to those that are not.
TreeCase graded(float growth)
{
    TreeCase cloth = as_grid("graded", flat_sheet(kSide), kSide, kSide);
    std::vector<float> places{0};
    for (int i = 1; i < kSide; ++i)
        places.push_back(places.back() +
                         1.41421356f * kDistance * (1 + growth * (static_cast<float>(i) - 0.5f * kSide)));
    for (std::size_t v = 0; v < cloth.t0.size(); ++v) cloth.t0[v] = {places[v % kSide], places[v / kSide], 0, 1};
    cloth.t1 = cloth.t0;
    return cloth;
}

std::vector<TreeCase> cases()
{
    std::vector<TreeCase> list;
    for (const TreeCase& cloth : {creased(1), creased(3), moved_to(graded(0.006f), graded(0.012f).t0), graded(0.003f)})
        for (const TreeCase& form : {cloth, in_random_order(cut_at_random(cloth, 1), 2)}) list.push_back(form);
    return list;
}

std::vector<bool> apart_faces(const TreeCase& cloth, int lanes)
{
    ThreadPool pool(1);
    FaceTree tree = cloth.tree();
    tree.use_lanes(lanes);
    tree.refit(cloth.moving(), {kDistance, Culling::sound}, pool);
    std::vector<bool> apart;
    for (std::uint32_t f = 0; f < cloth.faces.size(); ++f) apart.push_back(tree.is_apart_from_neighbours(f));
    return apart;
}

// Those that larger squares prove apart.
std::vector<bool> apart_by_squares(const TreeCase& cloth)
{
    const std::optional<GridPatch> grid = make_grid_patch(cloth.sheets[0], cloth.faces);
    const TreeKernels& kernels = tree_kernels(4);
    GridProof proof(*grid, cloth.rest);
    RowScratch rows;
    rows.resize(grid->columns);
    const GridBand band{&*grid, 0, grid->rows, false, nullptr, 0, nullptr};
    for (const auto* positions : {&cloth.t0, &cloth.t1})
        kernels.edge_bounds(positions->data(), band, proof.base(), rows);
    proof.prove({kDistance, Culling::sound}, kernels);
    std::vector<bool> apart(cloth.faces.size());
    for (int j = 0; j < grid->rows; ++j)
        for (int i = 0; i < grid->columns; ++i)
            for (const auto& faces : grid->faces)
                apart[faces[std::size_t(j * grid->face_stride() + i)]] = proof.is_apart_from_neighbours(i, j);
    return apart;
}

// Of the pairs of a face proven apart and a face that shares a vertex with it, the nearest elements on the way.
double nearest_proven(const TreeCase& cloth, const std::vector<bool>& apart)
{
    double nearest = 1e30;
    for (std::uint32_t a = 0; a < cloth.faces.size(); ++a)
        for (std::uint32_t b = 0; apart[a] && b < cloth.faces.size(); ++b) {
            if (a == b || !share_vertex(cloth.faces[a], cloth.faces[b])) continue;
            for (int k = 0; k <= kTimes; ++k)
                nearest = std::min(nearest, face_elements_distance(cloth, cloth.moving(), {a, b}, double(k) / kTimes));
        }
    return nearest;
}

TEST(CellProof, cells_proven_apart_from_those_around_them_are_so_at_all_times_of_a_way)
{
    for (const TreeCase& cloth : cases()) {
        SCOPED_TRACE(cloth.name);
        const std::vector<bool> apart = apart_faces(cloth, 16), by_squares = apart_by_squares(cloth);
        std::size_t by_cells = 0, open = 0;
        for (std::size_t f = 0; f < apart.size(); ++f) {
            EXPECT_TRUE(apart[f] || !by_squares[f]);
            by_cells += apart[f] && !by_squares[f];
            open += !apart[f];
        }
        EXPECT_GT(by_cells, 50u);
        EXPECT_GT(open, 50u);
        const double nearest = nearest_proven(cloth, apart);
        EXPECT_GT(nearest, kDistance);
        std::cout << cloth.name << ": cells prove " << by_cells << " faces apart, " << open << " are open; nearest "
                  << nearest / kDistance << " of the distance\n";
    }
}

TEST(CellProof, lists_of_faces_lack_none_that_come_within_the_distance)
{
    ThreadPool pool(1);
    std::size_t near = 0;
    for (const TreeCase& cloth : cases()) {
        SCOPED_TRACE(cloth.name);
        FaceTree tree = cloth.tree();
        tree.refit(cloth.moving(), {kDistance, Culling::sound}, pool);
        tree.query(pool);
        const std::vector<FacePair> found = sorted_pairs(tree);
        for (const FacePair pair : brute_force_pairs(tree)) {
            double least = 1e30;
            for (int k = 0; k <= kTimes; ++k)
                least = std::min(least, face_distance(cloth, cloth.moving(), pair, double(k) / kTimes));
            if (least > kDistance) continue;
            ++near;
            EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair)) << pair.a << " and " << pair.b;
        }
    }
    EXPECT_GT(near, 1000u);
}

TEST(CellProof, is_the_same_for_every_width_of_vectors)
{
    for (const TreeCase& cloth : cases()) {
        const std::vector<bool> narrow = apart_faces(cloth, 4);
        EXPECT_TRUE(apart_faces(cloth, 8) == narrow);
        EXPECT_TRUE(apart_faces(cloth, 16) == narrow);
    }
}

}  // namespace
}  // namespace nuno
