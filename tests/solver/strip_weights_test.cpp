// The springs and plates of a sheet in strips against those of its model: each is there once, and their sum is exact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

#include <glm/geometric.hpp>

#include "solver/solver_runs.h"
#include "solver/xpbd/strip_shares.h"

namespace nuno {
namespace {

struct Case
{
    int columns, rows;
};

class StripWeightsTest : public testing::TestWithParam<Case>
{
  protected:
    static ClothModel model()
    {
        SheetSource source;
        const auto [columns, rows] = GetParam();
        source.mesh =
            grid_mesh(columns, rows, {0, 0, 0}, {0.05f * float(columns - 1), 0, 0}, {0, -0.04f * float(rows - 1), 0});
        source.columns = columns;
        source.rows = rows;
        return build_cloth_model(std::span(&source, 1), MassLumping::area);
    }

    static SimParams params()
    {
        SimParams params = on_cpu(Method::xpbd);
        params.internal_model = InternalModel::fabric_springs;
        params.warp_stiffness = 30, params.weft_stiffness = 50, params.shear_modulus = 10;
        params.bend_stiffness = 3;
        params.bending_warp = 1e-3f, params.bending_weft = 2e-3f, params.bending_bias = 3e-3f;
        return params;
    }
};

// The tables hold s = (1 - kept^(1/n)) / W with kept = 1 / (1 + k h^2 W), so k can be read back from them.
TEST_P(StripWeightsTest, every_spring_is_there_once_with_its_own_stiffness)
{
    const ClothModel cloth = model();
    const Sheet& sheet = cloth.sheets[0];
    const StripLayout layout = make_strip_layout(sheet.columns, sheet.rows);
    const std::vector<SpringWeight> weights = spring_weights(cloth, params());
    ASSERT_TRUE(suits_strips(cloth, sheet));
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> expected;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i].axial > 0)
            expected[std::minmax(cloth.springs[i].a, cloth.springs[i].b)] += double(weights[i].axial);

    const double h = 0.01, inverse_mass = 2;
    constexpr int sweeps = 2;
    const std::vector<float> mobility(layout.lane_floats(), 1.0f);
    StripShareTables tables;
    tables.make(layout, mobility.data(), float(inverse_mass), strip_stiffnesses(cloth, sheet, layout, weights),
                float(h), sweeps, 0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> found;
    for (int j = 0; j < layout.rows; ++j)
        for (int kind = 0; kind < kStripSpringCount; ++kind)
            for (int i = 0; i < layout.columns; ++i) {
                const StripReach& reach = kStripReach[std::size_t(kind)];
                const int c = i % layout.width, strip = i / layout.width;
                const int i0 = i + reach.first_column, i1 = i + reach.second_column, j1 = j + reach.second_row;
                const StripShares& shares = tables.rows[std::size_t(j)]->springs[std::size_t(kind)];
                const float* lanes = shares.lanes + c * kStripShareFloats;
                const double share = double(lanes[strip]);
                EXPECT_EQ(lanes[strip], lanes[kStrips + strip]);
                if (std::max(i0, i1) >= layout.columns || j1 >= layout.rows) {
                    EXPECT_EQ(share, 0) << "past the rim";
                    continue;
                }
                if (share == 0) continue;
                const double kept = std::pow(1 - share * 2, sweeps * kStripPasses[std::size_t(kind)]);
                found[std::minmax(layout.vertex(sheet, i0, j), layout.vertex(sheet, i1, j1))] +=
                    (1 / kept - 1) / (h * h * inverse_mass * 2);
            }
    ASSERT_EQ(found.size(), expected.size());
    // A share is a float, 6e-8 off; the least of them is k h^2 w = 1e-3.
    for (const auto& [ends, stiffness] : expected)
        EXPECT_NEAR(found[ends], stiffness, 2e-4 * stiffness) << ends.first << " to " << ends.second;
}

// 1/2 sum over plates of b |C|^2 = 1/2 sum over springs of the linear weight |d|^2, for any positions.
TEST_P(StripWeightsTest, the_plates_sum_to_the_bending_energy_of_the_model)
{
    const ClothModel cloth = model();
    const Sheet& sheet = cloth.sheets[0];
    const StripLayout layout = make_strip_layout(sheet.columns, sheet.rows);
    const std::vector<SpringWeight> weights = spring_weights(cloth, params());
    const StripStiffnesses stiffnesses = strip_stiffnesses(cloth, sheet, layout, weights);
    std::mt19937 random(3);
    std::normal_distribution<double> at(0, 1);
    std::vector<glm::dvec3> x(cloth.vertex_count());
    for (glm::dvec3& p : x) p = {at(random), at(random), at(random)};

    double expected = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const glm::dvec3 d = x[cloth.springs[i].b] - x[cloth.springs[i].a];
        expected += 0.5 * double(weights[i].plate) * glm::dot(d, d);
    }
    const auto place = [&](int i, int j) { return x[layout.vertex(sheet, i, j)]; };
    double found = 0;
    const auto add = [&](StripPlate plate, bool rim, const glm::dvec3& c) {
        const StripPlateStiffness& b = stiffnesses.plates[std::size_t(plate)];
        found += 0.5 * double(rim ? b.rim : b.inside) * glm::dot(c, c);
    };
    for (int j = 0; j < layout.rows; ++j)
        for (int i = 0; i < layout.columns; ++i) {
            if (i + 2 < layout.columns)
                add(kPlateAcross, j == 0 || j == layout.rows - 1,
                    place(i, j) - 2.0 * place(i + 1, j) + place(i + 2, j));
            if (j + 2 < layout.rows)
                add(kPlateDown, i == 0 || i == layout.columns - 1,
                    place(i, j) - 2.0 * place(i, j + 1) + place(i, j + 2));
            if (i + 1 < layout.columns && j + 1 < layout.rows)
                add(kPlateTwist, false, place(i, j) - place(i + 1, j) - place(i, j + 1) + place(i + 1, j + 1));
        }
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(found, expected, 1e-5 * expected);
}

INSTANTIATE_TEST_SUITE_P(Sizes, StripWeightsTest, testing::Values(Case{10, 10}, Case{23, 5}, Case{60, 7}, Case{3, 40}),
                         [](const auto& test) {
                             return std::to_string(test.param.columns) + "_by_" + std::to_string(test.param.rows);
                         });

}  // namespace
}  // namespace nuno
