// Distances along sheets at rest.
#include "model/tethers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "model/distance_transform.h"
#include "support/sheets.h"

namespace nuno {
namespace {

std::vector<std::uint8_t> held_at(const ClothModel& model, std::initializer_list<std::uint32_t> vertices)
{
    std::vector<std::uint8_t> held(model.vertex_count());
    for (const std::uint32_t v : vertices) held[v] = 1;
    return held;
}

TEST(Tethers, on_a_flat_sheet_are_straight_and_exact)
{
    const ClothModel model = square_cloth(20, 2);
    const std::vector<Tether> tethers = SheetGeodesics(model, model.sheets[0]).pin_tethers(held_at(model, {0, 19}));
    for (std::uint32_t v = 1; v < 400; ++v) {
        if (v == 19) continue;
        for (std::uint32_t slot : {0u, 1u}) {
            const Tether& tether = tethers[slot * 400 + v];
            EXPECT_EQ(tether.anchor, slot == 0 ? 0u : 19u) << "the same pin in the same slot everywhere";
            EXPECT_FLOAT_EQ(tether.length, glm::distance(model.rest_positions[v], model.rest_positions[tether.anchor]));
        }
    }
    EXPECT_EQ(tethers[0].anchor, Tether::kNone);
}

TEST(Tethers, to_a_row_of_pins_count_the_row_as_one_and_lead_to_its_nearest_pin)
{
    const ClothModel model = square_cloth(16, 1);
    std::vector<std::uint8_t> held(256);
    for (std::uint32_t i = 0; i < 16; ++i) held[i] = 1;
    const std::vector<Tether> tethers = SheetGeodesics(model, model.sheets[0]).pin_tethers(held);
    for (std::uint32_t v = 16; v < 256; ++v) {
        EXPECT_EQ(tethers[v].anchor, v % 16) << v;
        EXPECT_EQ(tethers[256 + v].anchor, Tether::kNone);
    }
}

TEST(Tethers, of_three_supports_the_two_nearest_hold)
{
    const ClothModel model = square_cloth(9, 1);
    const std::vector<Tether> tethers = SheetGeodesics(model, model.sheets[0]).pin_tethers(held_at(model, {0, 8, 72}));
    const std::uint32_t v = 9 * 7 + 1;  // near the lower left corner, 72
    EXPECT_EQ(tethers[v].anchor, 0u);
    EXPECT_EQ(tethers[81 + v].anchor, 72u);
}

// Half a cylinder: along it the distance is that of the flat sheet it was rolled from, through the air it is shorter.
TEST(Tethers, on_a_curved_sheet_follow_the_cloth)
{
    SheetSource source = square_mesh(41, 1);
    for (glm::vec3& p : source.mesh.positions) {
        const float angle = p.x * float(M_PI);
        p = {-std::cos(angle) / float(M_PI), p.y, std::sin(angle) / float(M_PI)};
    }
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    EXPECT_FALSE(is_flat_and_convex(model, model.sheets[0]));
    const std::vector<Tether> tethers = SheetGeodesics(model, model.sheets[0]).pin_tethers(held_at(model, {0}));
    double worst = 0;
    for (std::uint32_t j = 0; j < 41; ++j)
        for (std::uint32_t i = 0; i < 41; ++i) {
            if (i + j == 0) continue;
            const double exact = std::hypot(i, j) / 40;
            worst = std::max(worst, std::abs(double(tethers[j * 41 + i].length) / exact - 1));
        }
    // The chords of 40 segments are short by (pi / 40)^2 / 24 = 0.03 %; fast marching from a point over edges of 1/40
    // errs most in the first rings, by a few per cent.
    EXPECT_LT(worst, 0.04);
    EXPECT_NEAR(double(tethers[40].length), 1, 0.001);
    EXPECT_NEAR(double(tethers[40 * 41].length), 1, 0.001);
}

TEST(Tethers, around_a_slit_are_longer_than_straight_ones)
{
    // A sheet of 21 x 21 without the faces that touch the middle column in its upper half.
    SheetSource source = square_mesh(21, 1);
    std::erase_if(source.mesh.faces, [](const glm::uvec3& face) {
        for (int k = 0; k < 3; ++k)
            if (face[k] % 21 == 10 && face[k] / 21 < 10) return true;
        return false;
    });
    // Vertices in no face are no cloth: renumber.
    std::vector<std::uint32_t> place(441, ~0u);
    TriangleMesh mesh;
    for (glm::uvec3& face : source.mesh.faces)
        for (int k = 0; k < 3; ++k) {
            if (place[face[k]] == ~0u) {
                place[face[k]] = std::uint32_t(mesh.positions.size());
                mesh.positions.push_back(source.mesh.positions[face[k]]);
            }
            face[k] = place[face[k]];
        }
    mesh.uvs.resize(mesh.positions.size());
    mesh.faces = source.mesh.faces;
    source.mesh = mesh;
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    const Sheet& sheet = model.sheets[0];
    EXPECT_FALSE(is_flat_and_convex(model, sheet));
    const std::uint32_t left = place[0], right = place[20];
    const std::vector<Tether> tethers = SheetGeodesics(model, sheet).pin_tethers(held_at(model, {left}));
    // From one upper corner to the other: round the lower end of the slit, (0.5, -0.5), 0.707 each way.
    EXPECT_NEAR(double(tethers[right].length), 2 * std::sqrt(0.5), 0.08);
}

TEST(DistanceTransform, agrees_with_trying_every_mark)
{
    const GridSpacing grid{23, 17, 0.3f, 0.7f};
    std::mt19937 random(5);
    std::vector<std::uint8_t> marked(23 * 17);
    for (int n = 0; n < 12; ++n) marked[random() % marked.size()] = 1;
    const std::vector<std::uint32_t> nearest = nearest_marked(grid, marked);
    const auto distance = [&](std::uint32_t a, std::uint32_t b) {
        return std::hypot((double(a % 23) - double(b % 23)) * 0.3, (double(a / 23) - double(b / 23)) * 0.7);
    };
    for (std::uint32_t p = 0; p < marked.size(); ++p) {
        ASSERT_TRUE(marked[nearest[p]]);
        double best = 1e9;
        for (std::uint32_t q = 0; q < marked.size(); ++q)
            if (marked[q]) best = std::min(best, distance(p, q));
        EXPECT_NEAR(distance(p, nearest[p]), best, 1e-9) << p;
    }
    EXPECT_EQ(nearest_marked(grid, std::vector<std::uint8_t>(23 * 17))[5], kNoneMarked);
}

}  // namespace
}  // namespace nuno
