// Cloth at rest against closed forms: its own weight, the elastic catenary, bending, and the same cloth at other
// resolutions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "support/equilibrium.h"
#include "support/sheets.h"
#include "support/verification.h"

namespace nuno {
namespace {

SimParams fabric(InternalModel internal)
{
    SimParams params;
    params.internal_model = internal;
    params.warp_stiffness = params.weft_stiffness = 200;
    params.shear_modulus = 50;
    params.cross_stiffness = internal == InternalModel::continuum ? 50 : 0;
    return params;
}

// `columns` x `rows` vertices; `across` along x, `down` along -y or -z.
SheetSource strip(int columns, int rows, glm::vec3 across, glm::vec3 down)
{
    SheetSource source;
    source.name = "strip";
    source.mesh = grid_mesh(columns, rows, {0, 0, 0}, across, down);
    source.columns = columns;
    source.rows = rows;
    return source;
}

std::vector<std::uint32_t> first_row(int columns)
{
    std::vector<std::uint32_t> pins;
    for (int i = 0; i < columns; ++i) pins.push_back(static_cast<std::uint32_t>(i));
    return pins;
}

// u = sigma g L^2 / (2 Y) at the tip of a strip, and what its rows of masses make of it. Free to contract, a
// membrane has Y = C11 - C12^2 / C22; a grid of springs has C12 = G.
TEST(Weight, stretches_a_hanging_strip_as_the_closed_form_says)
{
    for (const InternalModel internal : {InternalModel::fabric_springs, InternalModel::continuum}) {
        SheetSource source = strip(5, 41, {0.1f, 0, 0}, {0, -1, 0});
        source.pins = first_row(5);
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        SimParams params = fabric(internal);
        params.areal_density = 0.1f;
        params.gravity_y = -1;
        const double c12 = 50, young = 200 - c12 * c12 / 200;
        const std::vector<glm::dvec3> x = equilibrium(model, params);
        const double stretch = -x[40 * 5 + 2].y - 1;
        const double expected = 0.1 * 1 / (2 * young);
        // The held row and the lumped masses of the rim are worth half a cell, 1/80, each.
        expect_measured(fmt::format("strip under its own weight, {}: tip stretch, m",
                                    choice_names(InternalModel{})[std::size_t(internal)]),
                        stretch, expected, 0.03 * expected);
    }
}

// Irvine, Cable Structures, 1.3: a chain of n springs between two points 0.8 m apart, L = 1 m, w = 2 N/m, EA = 50 N:
// mid sag 0.278248 m. The chain is the middle thread of a sheet of three that carry the load of one, with nothing
// across.
TEST(ElasticCatenary, the_sag_of_a_chain_converges_as_one_over_n_squared)
{
    double errors[3];
    const int counts[] = {20, 40, 80};
    for (int i = 0; i < 3; ++i) {
        const int n = counts[i];
        SheetSource source = strip(n + 1, 2, {1, 0, 0}, {0, 0, -0.1f});
        for (const glm::vec3& p : source.mesh.positions)
            source.start.emplace_back(0.8f * p.x, -1.2f * p.x * (1 - p.x), p.z);
        for (const int j : {0, 1})
            for (const int column : {0, n}) source.pins.push_back(static_cast<std::uint32_t>(j * (n + 1) + column));
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        SimParams params = fabric(InternalModel::fabric_springs);
        // Both rows are at the rim, so half springs: a strip of width 0.1 m, w = sigma g 0.1, EA = C22 0.1.
        params.weft_stiffness = 500;
        params.shear_modulus = 0;
        params.gravity_y = -10;
        params.areal_density = 2;
        const std::vector<glm::dvec3> x = equilibrium(model, params);
        errors[i] = std::abs(-x[std::size_t(n / 2)].y - 0.278248);
        if (n == 80) expect_measured("elastic catenary of 80 springs: mid sag, m", -x[40].y, 0.278248, 1e-4);
    }
    expect_measured("elastic catenary, 20 to 40 springs: order", std::log2(errors[0] / errors[1]), 2, 0.15);
    expect_measured("elastic catenary, 40 to 80 springs: order", std::log2(errors[1] / errors[2]), 2, 0.2);
}

// H/W of the heavy elastica, drop over reach of the tip of a strip of bending stiffness D: theta'' = Gamma s cos theta,
// Gamma = sigma g L^3 / D, by shooting; it agrees with the master curve of Romero et al. 2021.
struct Elastica
{
    double gamma, ratio;
};
constexpr std::array<Elastica, 5> kElastica{
    {{0.1, 0.0125}, {1, 0.124562}, {8, 0.884330}, {50, 3.70556}, {300, 11.1831}}};

SimParams elastica_params(double gamma, double length)
{
    SimParams params = fabric(InternalModel::continuum);
    params.areal_density = 0.1f;
    const double stiffness = 0.1 * 9.81 * length * length * length / gamma;
    params.bending_warp = params.bending_weft = params.bending_bias = static_cast<float>(stiffness);
    return params;
}

// Clamped by its first two columns: the clamp is half way between them, since the curvature at the second counts only
// on its free side.
double drop_over_reach(int cells, double gamma, bool along_warp)
{
    const float cell = 0.1f / (static_cast<float>(cells) - 0.5f), width = 0.02f;
    const int across = 4;
    SheetSource source = strip(cells + 1, across, {cell * static_cast<float>(cells), 0, 0}, {0, 0, -width});
    if (along_warp) {
        // The same strip, columns and rows exchanged.
        source = strip(across, cells + 1, {0, 0, -width}, {cell * static_cast<float>(cells), 0, 0});
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < across; ++i) source.pins.push_back(static_cast<std::uint32_t>(j * across + i));
    } else {
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < 2; ++i) source.pins.push_back(static_cast<std::uint32_t>(j * (cells + 1) + i));
    }
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    const std::vector<glm::dvec3> x = equilibrium(model, elastica_params(gamma, 0.1));
    const std::size_t tip = along_warp ? std::size_t(cells * across + across / 2) : std::size_t(2 * (cells + 1) - 1);
    return -x[tip].y / (x[tip].x - double(cell) / 2);
}

TEST(Cantilever, a_grid_hangs_as_the_heavy_elastica_along_either_thread)
{
    for (const Elastica& e : kElastica)
        for (const bool along_warp : {false, true}) {
            const double ratio = drop_over_reach(30, e.gamma, along_warp);
            expect_measured(fmt::format("cantilever, grid, {}, Gamma {}: ln(H/W) - ln(elastica)",
                                        along_warp ? "warp" : "weft", e.gamma),
                            std::log(ratio / e.ratio), 0, 0.05);
        }
}

TEST(Cantilever, converges_with_the_grid)
{
    const double coarse = std::abs(std::log(drop_over_reach(10, 8, false) / 0.884330));
    const double fine = std::abs(std::log(drop_over_reach(40, 8, false) / 0.884330));
    EXPECT_LT(fine, 2e-3);
    EXPECT_LE(fine, coarse);
}

// Peirce: at Gamma = 8 the chord hangs at 41.5 degrees, the standard test of bending length (c = L / 2).
TEST(Cantilever, peirces_chord_at_gamma_8_is_41_5_degrees)
{
    const double chord = std::atan(drop_over_reach(40, 8, false)) * 180 / M_PI;
    expect_measured("Peirce chord at Gamma = 8, degrees", chord, 41.487, 0.1);
}

// Nearly equal triangles without rows or columns, clamped at x <= 0. The hinges of equal triangles make a plate with
// Poisson's ratio 1/3 (Seung and Nelson 1988): a strip that is free to curl across bends with (1 - 1/9) D, not D, so it
// is given 9/8 of the elastica's.
TEST(Cantilever, an_irregular_mesh_hangs_as_the_heavy_elastica)
{
    constexpr float length = 0.1f, width = 0.02f;
    constexpr int count = 24;
    const float edge = length / (count + 0.5f), height = edge * std::sqrt(0.75f);
    SheetSource source;
    source.name = "irregular";
    std::mt19937 random(4);
    std::uniform_real_distribution<float> shift(-0.15f * edge, 0.15f * edge);
    const int rows = static_cast<int>(width / height), columns = count + 4;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const float x = edge * (static_cast<float>(i - 2) + 0.5f * static_cast<float>(j % 2));
            const bool inner = i > 2 && i + 1 < columns;
            source.mesh.positions.emplace_back(x + (inner ? shift(random) : 0), 0,
                                               height * static_cast<float>(j) + (inner ? shift(random) : 0));
            if (i <= 2) source.pins.push_back(static_cast<std::uint32_t>(j * columns + i));
        }
    source.mesh.uvs.resize(source.mesh.positions.size());
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * columns + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const int odd = j % 2;
            source.mesh.faces.emplace_back(at(i, j), at(i + odd, j + 1), at(i + 1, j));
            source.mesh.faces.emplace_back(at(i + 1 - odd, j), at(i, j + 1), at(i + 1, j + 1));
        }
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    // Free from a quarter of an edge (the rows are held up to 0 and to half an edge) to the tip.
    const double clamp = 0.25 * double(edge), free = double(edge) * (columns - 3 + 0.25) - clamp;
    for (const Elastica& e : kElastica) {
        if (e.gamma > 100) continue;  // folds over less than an edge
        const std::vector<glm::dvec3> x = equilibrium(model, elastica_params(8.0 / 9.0 * e.gamma, free));
        double drop = 0, reach = 0;
        for (const int j : {rows / 2, rows / 2 + 1}) {
            drop -= x[at(columns - 1, j)].y / 2;
            reach += (x[at(columns - 1, j)].x - clamp) / 2;
        }
        expect_measured(
            fmt::format("cantilever, irregular triangles with 9/8 D, Gamma {}: ln(H/W) - ln(elastica)", e.gamma),
            std::log(drop / reach / e.ratio), 0, 0.05);
    }
}

// The sheet of 17 x 17 and its refinements are one cloth: the lowest point and the strain at the pegs' row converge.
TEST(Resolution, refining_a_hanging_sheet_keeps_the_cloth)
{
    for (const InternalModel internal : {InternalModel::fabric_springs, InternalModel::continuum}) {
        SimParams params = fabric(internal);
        params.bending_warp = params.bending_weft = params.bending_bias = 1e-4f;
        double sag[3];
        const int counts[] = {17, 33, 65};
        for (int i = 0; i < 3; ++i) {
            SheetSource source = square_sheet(counts[i], 1, first_row(counts[i]));
            const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
            sag[i] = -equilibrium(model, params)[std::size_t(counts[i] * (counts[i] - 1) + counts[i] / 2)].y - 1;
        }
        const double expected = 0.2 * 9.81 / (2 * (200 - 50 * 50 / 200.0));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(sag[i], expected, 0.06 * expected) << counts[i];
        expect_measured(fmt::format("hanging sheet, {}: stretch at 65 over that at 17 a side",
                                    choice_names(InternalModel{})[std::size_t(internal)]),
                        sag[2] / sag[0], 1, 0.04);
    }
}

// Columns and rows of a strip of 1 m by 0.25 m that hangs between its two short sides, and where its vertices are.
struct Shape
{
    int columns, rows;
    std::vector<glm::dvec3> x;
};

// From the shape with half as many cells, every new vertex between its neighbours.
Shape refined(const SimParams& params, const Shape& coarse)
{
    const int columns = 2 * coarse.columns - 1, rows = 2 * coarse.rows - 1;
    SheetSource source = strip(columns, rows, {1, 0, 0}, {0, 0, 0.25f});
    const auto place = [&](int i, int j) { return static_cast<std::uint32_t>(j * columns + i); };
    for (int j = 0; j < rows; ++j)
        for (const int i : {0, columns - 1}) source.pins.push_back(place(i, j));
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    std::vector<glm::dvec3> x(model.vertex_count());
    const auto known = [&](int i, int j) { return coarse.x[std::size_t(j * coarse.columns + i)]; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            x[place(i, j)] = (known(i / 2, j / 2) + known((i + 1) / 2, j / 2) + known(i / 2, (j + 1) / 2) +
                              known((i + 1) / 2, (j + 1) / 2)) /
                             4.0;
    for (const std::uint32_t pin : source.pins) x[pin] = model.start_positions[pin];
    return {columns, rows, equilibrium(model, params, std::move(x), 1e-6)};
}

// Mean distance between the vertices that both have.
double change(const Shape& coarse, const Shape& fine)
{
    double sum = 0;
    for (int j = 0; j < coarse.rows; ++j)
        for (int i = 0; i < coarse.columns; ++i)
            sum += glm::distance(coarse.x[std::size_t(j * coarse.columns + i)],
                                 fine.x[std::size_t(2 * j * fine.columns + 2 * i)]);
    return sum / double(coarse.x.size());
}

class ResolutionTest : public testing::TestWithParam<InternalModel>
{};

// The same fabric at 17, 33, 65 and 129 vertices along: each refinement changes the shape half as much as the one
// before, or less; springs and plate are of second order in the cell, which is a quarter.
TEST_P(ResolutionTest, from_17_to_129_vertices_the_shape_converges)
{
    SimParams params = fabric(GetParam());
    params.bending_warp = params.bending_weft = params.bending_bias = 1e-3f;
    Shape shape{9, 3, {}};
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 9; ++i) {
            const double at = i / 8.0;
            shape.x.emplace_back(at, -0.3 * at * (1 - at), 0.125 * j);
        }
    shape = refined(params, shape);
    double last = 0;
    while (shape.columns < 129) {
        Shape finer = refined(params, shape);
        const double changed = change(shape, finer);
        if (last > 0)
            expect_measured(
                fmt::format("hammock, {}: change of the shape from {} to {} vertices over the last one",
                            choice_names(GetParam())[std::size_t(GetParam())], shape.columns, finer.columns),
                changed / last, 0.25, 0.25);
        last = changed;
        shape = std::move(finer);
    }
    // Of a sag of 5 cm.
    EXPECT_LT(last, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Models, ResolutionTest,
                         testing::Values(InternalModel::fabric_springs, InternalModel::continuum),
                         [](const auto& test) {
                             return std::string(choice_names(test.param)[std::size_t(test.param)]);
                         });

}  // namespace
}  // namespace nuno
