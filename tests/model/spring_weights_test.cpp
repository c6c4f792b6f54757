// Springs and plate from fabric constants, against the energy of the continuum.
#include "model/spring_weights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <tuple>

#include <glm/geometric.hpp>

#include "model/force_model.h"
#include "support/sheets.h"
#include "support/verification.h"

namespace nuno {
namespace {

// Elastic energy of a model whose vertices are moved by `move`.
template <class Move>
double energy(const ClothModel& model, const SimParams& params, Move move)
{
    std::vector<glm::dvec3> x;
    for (const glm::vec3& rest : model.rest_positions) x.push_back(move(glm::dvec3(rest)));
    return ForceModel(model, params).elastic_energy(x);
}

// `count` x `count` cells of width dx and height dy in the X-Y plane.
ClothModel grid(int count, float dx, float dy)
{
    SheetSource source;
    const float n = static_cast<float>(count);
    source.mesh = grid_mesh(count + 1, count + 1, {0, 0, 0}, {n * dx, 0, 0}, {0, -n * dy, 0});
    source.columns = source.rows = count + 1;
    return build_cloth_model(std::span(&source, 1), MassLumping::area);
}

// The same as a mesh of equal, equal-sided triangles (irregular: its vertices shifted), `side` m long.
ClothModel triangles(int count, float side, float irregular)
{
    SheetSource source;
    const float edge = side / static_cast<float>(count), height = edge * std::sqrt(0.75f);
    const int rows = static_cast<int>(side / height);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> shift(-irregular * edge, irregular * edge);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= count; ++i) {
            const float x = edge * (static_cast<float>(i) + 0.5f * static_cast<float>(j % 2)) + shift(random);
            const float y = -height * static_cast<float>(j) + shift(random);
            source.mesh.positions.emplace_back(x, y, 0);
            source.mesh.uvs.emplace_back(x, y);
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (count + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < count; ++i) {
            const int odd = j % 2;
            source.mesh.faces.emplace_back(at(i, j), at(i + odd, j + 1), at(i + 1, j));
            source.mesh.faces.emplace_back(at(i + 1 - odd, j), at(i, j + 1), at(i + 1, j + 1));
        }
    return build_cloth_model(std::span(&source, 1), MassLumping::area);
}

double area_of(const ClothModel& model)
{
    double area = 0;
    for (const float a : model.areas) area += double(a);
    return area;
}

// Energy per area of a uniform small strain: 1/2 (C11 E11^2 + C22 E22^2) + C12 E11 E22 + 1/2 G (2 E12)^2, warp along y.
double strain_energy(const SimParams& p, double warp, double weft, double angle)
{
    return 0.5 * (double(p.warp_stiffness) * warp * warp + double(p.weft_stiffness) * weft * weft +
                  double(p.shear_modulus) * angle * angle) +
           double(p.cross_stiffness) * warp * weft;
}

// Half springs at the rim make a uniform strain cost the same at any cell, square or not. C12 is that of the springs,
// G.
TEST(FabricSprings, a_grid_of_any_cell_resists_small_strain_as_the_fabric_does)
{
    SimParams params;
    params.internal_model = InternalModel::fabric_springs;
    params.warp_stiffness = 300;
    params.weft_stiffness = 200;
    params.shear_modulus = params.cross_stiffness = 40;
    constexpr double e = 1e-5;
    for (const auto& [count, dx, dy] :
         {std::tuple(4, 0.1f, 0.1f), std::tuple(16, 0.025f, 0.025f), std::tuple(8, 0.1f, 0.13f)})
    {
        const ClothModel model = grid(count, dx, dy);
        const double area = area_of(model);
        for (const auto& [warp, weft, angle] :
             {std::tuple(1.0, 0.0, 0.0), std::tuple(0.0, 1.0, 0.0), std::tuple(1.0, -2.0, 0.0),
              std::tuple(0.0, 0.0, 1.0), std::tuple(1.0, 1.0, 1.0)})
        {
            const double found = energy(model, params, [&, w = warp, f = weft, a = angle](const glm::dvec3& x) {
                return glm::dvec3(x.x * (1 + e * f) + e * a / 2 * x.y, x.y * (1 + e * w) + e * a / 2 * x.x, 0);
            });
            const double expected = e * e * strain_energy(params, warp, weft, angle) * area;
            EXPECT_NEAR(found, expected, 1e-2 * expected) << count << ": " << warp << " " << weft << " " << angle;
        }
    }
}

// Rigid turns cost nothing; the plate resists a cylinder of curvature kappa with D kappa^2 / 2 per area, in any
// direction.
double bending_of(const std::array<ClothModel, 2>& patches, const SimParams& params, double degrees)
{
    // The plate is quadratic in the positions, so the curvature need not be small; it is far above what rounding of the
    // weights to float leaves of a flat sheet.
    const double kappa = 1;
    const glm::dvec2 across(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
    double energies[2], areas[2];
    for (std::size_t i = 0; i < 2; ++i) {
        energies[i] = energy(patches[i], params, [&](const glm::dvec3& x) {
            const double s = across.x * x.x + across.y * x.y;
            return glm::dvec3(x.x, x.y, kappa * s * s / 2);
        });
        areas[i] = area_of(patches[i]);
    }
    // The rim, which bends less, falls out of E2 - ratio E1 when the second patch has sides `ratio` times as long.
    const double ratio = std::sqrt(areas[1] / areas[0]);
    return 2 * (energies[1] - ratio * energies[0]) / (areas[1] - ratio * areas[0]) / (kappa * kappa);
}

std::string fmt_plate(std::string_view mesh, double degrees)
{
    return fmt::format("bending: D_eff / D of {} at {} degrees to the weft", mesh, degrees);
}

SimParams plate_only()
{
    SimParams params;
    params.internal_model = InternalModel::continuum;
    params.warp_stiffness = params.weft_stiffness = params.cross_stiffness = params.shear_modulus = 0;
    params.bending_warp = params.bending_weft = params.bending_bias = 1e-4f;
    return params;
}

TEST(Plate, a_grid_resists_bending_with_d_in_every_direction)
{
    const std::array patches{grid(20, 0.05f, 0.05f), grid(40, 0.05f, 0.05f)};
    for (const double degrees : {0.0, 30.0, 45.0, 70.0, 90.0})
        expect_measured(fmt_plate("grid", degrees), bending_of(patches, plate_only(), degrees) / 1e-4, 1, 0.01);
}

TEST(Plate, a_grid_has_the_stiffness_of_each_thread_and_of_the_bias)
{
    SimParams params = plate_only();
    params.bending_warp = 3e-4f;
    params.bending_bias = 1.5e-4f;
    const std::array patches{grid(20, 0.05f, 0.04f), grid(40, 0.05f, 0.04f)};
    expect_measured("bending: D_eff / D of a grid, the warp bent", bending_of(patches, params, 90) / 3e-4, 1, 0.01);
    expect_measured("bending: D_eff / D of a grid, the weft bent", bending_of(patches, params, 0) / 1e-4, 1, 0.01);
    expect_measured("bending: D_eff / D of a grid, the bias bent", bending_of(patches, params, 45) / 1.5e-4, 1, 0.01);
}

TEST(Plate, triangles_resist_bending_nearly_alike_in_every_direction)
{
    for (const float irregular : {0.0f, 0.15f}) {
        const std::array patches{triangles(20, 1, irregular), triangles(40, 2, irregular)};
        for (const double degrees : {0.0, 30.0, 45.0, 90.0})
            expect_measured(fmt_plate(irregular > 0 ? "irregular triangles" : "equal triangles", degrees),
                            bending_of(patches, plate_only(), degrees) / 1e-4, 1, 0.1);
    }
}

// A mesh made of a grid, all cells cut alike, is not alike in every direction (Grinspun et al. 2006 say so of hinges).
TEST(Plate, a_mesh_with_one_way_diagonals_is_three_times_too_stiff_across_them)
{
    std::vector<ClothModel> patches;
    for (const int count : {21, 41}) {
        const SheetSource source = square_mesh(count, 0.05f * static_cast<float>(count - 1));
        patches.push_back(build_cloth_model(std::span(&source, 1), MassLumping::area));
    }
    const std::array pair{patches[0], patches[1]};
    EXPECT_NEAR(bending_of(pair, plate_only(), 0) / 1e-4, 1, 0.05);
    const double one = bending_of(pair, plate_only(), 45) / 1e-4, other = bending_of(pair, plate_only(), 135) / 1e-4;
    expect_measured("bending: D_eff / D of a mesh cut one way, across the cuts", std::max(one, other), 3, 0.2);
}

TEST(Plate, a_turned_sheet_feels_nothing)
{
    const ClothModel model = grid(6, 0.1f, 0.1f);
    SimParams params = plate_only();
    EXPECT_NEAR(energy(model, params, [](const glm::dvec3& x) { return glm::dvec3(x.y, 0.6 * x.x, 0.8 * x.x); }), 0,
                1e-15);
}

}  // namespace
}  // namespace nuno
