// Which meshes have a plane that takes them in, and that what is proven apart over it is apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "collision/tree/chart_builder.h"
#include "collision/tree/curved_cases.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

// A round sheet of rings around a centre, in the plane z = 0; the rim pressed in at one place by `notch`.
TreeCase disc(int rings, float notch)
{
    Pose pose;
    pose.rest.emplace_back(0, 0, 0);
    const int around = 6 * rings;
    for (int ring = 1; ring <= rings; ++ring)
        for (int k = 0; k < around; ++k) {
            const float angle = 6.2831853f * static_cast<float>(k) / static_cast<float>(around);
            const bool pressed = ring == rings && k == 5;
            const float r = static_cast<float>(ring) / static_cast<float>(rings) - (pressed ? notch : 0);
            pose.rest.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
        }
    const auto at = [&](int ring, int k) { return static_cast<std::uint32_t>(1 + (ring - 1) * around + k % around); };
    for (int k = 0; k < around; ++k) {
        pose.faces.emplace_back(0u, at(1, k), at(1, k + 1));
        for (int ring = 1; ring < rings; ++ring) {
            pose.faces.emplace_back(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
            pose.faces.emplace_back(at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
        }
    }
    for (const glm::vec3& p : pose.rest) pose.positions.emplace_back(p, 1);
    return as_mesh("disc", pose);
}

// Of the whole mesh, or of the faces of which `is_held` holds.
std::optional<ChartWindow> window_of(const TreeCase& cloth, bool (*is_held)(glm::vec3 middle) = nullptr)
{
    std::vector<std::uint32_t> held;
    for (std::uint32_t f = 0; f < cloth.faces.size(); ++f) {
        const glm::uvec3 v = cloth.faces[f];
        if (is_held == nullptr || is_held((cloth.rest[v.x] + cloth.rest[v.y] + cloth.rest[v.z]) / 3.0f))
            held.push_back(f);
    }
    return ChartBuilder(cloth.rest, cloth.faces).window_of(held);
}

bool has_window(const TreeCase& cloth) { return window_of(cloth).has_value(); }

TEST(ChartBuilder, flat_convex_sheets_without_holes_have_a_window)
{
    EXPECT_TRUE(has_window(disc(5, 0)));
    EXPECT_TRUE(has_window(in_random_order(disc(5, 0), 1)));
    EXPECT_TRUE(has_window(cut_at_random(as_mesh("flat", flat_sheet(9)), 1)));
}

TEST(ChartBuilder, sheets_that_are_curved_or_notched_by_little_have_one)
{
    TreeCase bent = as_mesh("bent", flat_sheet(9));
    bent.rest[40].z = 0.1f;
    EXPECT_TRUE(has_window(bent));
    EXPECT_TRUE(has_window(notched(9, 0.1f)));
    EXPECT_TRUE(has_window(saddle(9)));
}

TEST(ChartBuilder, others_have_none)
{
    EXPECT_FALSE(has_window(disc(5, 0.19f))) << "a notch";
    EXPECT_FALSE(has_window(notched(9, 0.3f)));
    TreeCase hole = as_mesh("hole", flat_sheet(9));
    hole.faces.erase(hole.faces.begin() + 60);
    hole.sheets[0].face_count -= 1;
    EXPECT_FALSE(has_window(hole));
    EXPECT_FALSE(has_window(l_shape(9)));
    EXPECT_FALSE(has_window(sleeve(9)));
    TreeCase turned = as_mesh("turned over", flat_sheet(9));
    std::swap(turned.faces[7].x, turned.faces[7].y);
    EXPECT_FALSE(has_window(turned));
    const TreeCase two = together(as_mesh("two", flat_sheet(5)), as_mesh("two", flat_sheet(5)));
    EXPECT_FALSE(has_window(two)) << "two layers";
    TreeCase ramp = as_mesh("ramp", spiral_ramp(9, 0.01f));
    for (std::size_t v = 0; v < ramp.rest.size(); ++v) ramp.rest[v] = glm::vec3(ramp.t0[v]);
    EXPECT_FALSE(has_window(ramp)) << "of two turns";
    EXPECT_FALSE(has_window(as_mesh("soup", face_soup(30, 1))));
}

// A window takes in what lies between the faces that it is to hold, and no more.
TEST(ChartBuilder, a_part_of_a_mesh_has_a_window_where_the_hull_of_its_places_is_covered)
{
    const auto face_count = [](const ChartWindow& window) {
        return std::accumulate(window.parts.begin(), window.parts.end(), std::size_t{0},
                               [](std::size_t sum, const ChartPart& part) { return sum + part.corners.size() / 3; });
    };
    const auto upper_half = [](glm::vec3 middle) { return middle.z > 0.15f; };
    const std::optional<ChartWindow> part = window_of(sleeve(24), upper_half);
    ASSERT_TRUE(part);
    EXPECT_LT(face_count(*part), sleeve(24).faces.size() / 2);
    EXPECT_GT(part->stretch, 1.2);
    EXPECT_LT(part->stretch, 2.5);
    const auto two_strips = [](glm::vec3 middle) { return middle.x < 0.2f || middle.x > 0.8f; };
    const std::optional<ChartWindow> between = window_of(as_mesh("flat", flat_sheet(16)), two_strips);
    ASSERT_TRUE(between);
    EXPECT_GE(face_count(*between), std::size_t{2 * 15 * 15});
    EXPECT_FALSE(window_of(plate_with_hole(16), two_strips)) << "a hole between them";
    EXPECT_TRUE(window_of(plate_with_hole(16), [](glm::vec3 middle) { return middle.x > 0.8f; })) << "beside the hole";
}

// The least height of its faces, and less where a rim is notched.
TEST(ChartBuilder, distances_in_the_plane_are_those_of_heights)
{
    EXPECT_NEAR(window_of(as_mesh("flat", flat_sheet(9)))->least_distance, 0.125 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(window_of(as_mesh("flat", flat_sheet(9)))->stretch, 1, 1e-6);
    const std::optional<ChartWindow> notch = window_of(notched(9, 0.1f));
    ASSERT_TRUE(notch);
    EXPECT_LT(notch->least_distance, 0.125 * std::sqrt(0.5) * std::cos(std::atan(0.4)) + 1e-6);
    EXPECT_GT(notch->stretch, 1 / std::cos(std::atan(0.4)) - 1e-6);
}

// All elements against all, those of neighbouring faces too: where the tree says that a mesh is apart, it is.
TEST(ChartProof, what_is_proven_apart_is_apart)
{
    ThreadPool pool(1);
    int proven = 0, open = 0;
    for (const TreeCase& flat : {disc(5, 0), in_random_order(disc(4, 0), 3), as_mesh("flat", flat_sheet(8)),
                                 as_grid("grid", flat_sheet(8), 8, 8), notched(8, 0.06f), saddle(8)})
        for (int k = 0; k < 8; ++k) {
            TreeCase cloth = flat;
            const float height = 0.08f * static_cast<float>(k);
            for (std::size_t v = 0; v < cloth.t0.size(); ++v) {
                const glm::vec3 p = cloth.rest[v];
                cloth.t0[v] = glm::vec4(p.y, 0.8f * p.x, height * std::sin(5 * p.x) * std::cos(4 * p.y), 1);
                cloth.t1[v] = cloth.t0[v] + glm::vec4(1, 0, -height * std::sin(6 * p.y), 0);
            }
            constexpr float distance = 0.01f;
            FaceTree tree = cloth.tree();
            tree.refit(cloth.moving(), {distance, Culling::sound}, pool);
            (tree.is_proven_apart() ? proven : open)++;
            if (!tree.is_proven_apart()) continue;
            const double t = 0.25 * (k % 5);
            EXPECT_GT(element_distance(cloth, cloth.moving(), t), distance) << cloth.name << " " << k << " at " << t;
        }
    EXPECT_GT(proven, 6);
    EXPECT_GT(open, 3);
}

// A face and one of its sides as a rim, turned in their plane by an angle t. With L = 1 and lambda = 0.1 the face holds
// where cos t > 0.1, and the rim, which is 0.5 = tan A from straight, where s.z = cos t - 0.1 > 0.5 |sin t| = |s x z| tan A.
TEST(ChartProof, a_rim_is_to_turn_less_than_a_face)
{
    ChartPart part{{0, 1, 2}, {{0, 0}, {1, 0}, {0, 1}}, {}, {{{0, 1}, {1, 0}, 0.5f}}};
    for (std::size_t k = 0; k < ChartPart::kGroup; ++k) part.corners.insert(part.corners.end(), {0, 1, 2});
    const ChartFace face{{0, 1, 2}, {{{0, 0}, {1, 0}, {0, 1}}}};
    const ChartTest test{{{{0, 0, 1, 0}, {0, 0, 0, 1}, {0, 0, 0, 0}}}, {1, 1, -0.1f, -0.1f}, 0, 10, 0};
    ChartPart without_rim = part;
    without_rim.rims.clear();
    for (const int lanes : {4, 8, 16})
        for (int degrees = -100; degrees <= 100; degrees += 5) {
            const float t = 3.14159265f * static_cast<float>(degrees) / 180, c = std::cos(t), s = std::sin(t);
            const std::vector<glm::vec4> x{{7, 2, 3, 1}, {7 + c, 2 + s, 4, 1}, {7 - s, 2 + c, 1, 1}};
            const TreeKernels& kernels = tree_kernels(lanes);
            EXPECT_EQ(kernels.prove_face(x.data(), face, test), c > 0.1f) << degrees;
            EXPECT_EQ(kernels.prove_part(x.data(), without_rim, test).holds, c > 0.1f) << degrees;
            EXPECT_EQ(kernels.prove_part(x.data(), part, test).holds, c - 0.1f > 0.5f * std::abs(s)) << degrees;
        }
}

// The lips of a notch close in the plane, while every face is turned and stretched and none is pressed together: it is
// the rim alone that comes near itself, at last through itself.
TEST(ChartProof, a_notch_whose_lips_meet_is_not_proven_apart)
{
    ThreadPool pool(1);
    constexpr float distance = 0.002f, pi = 3.14159265f;
    double nearest_proven = 1e30, nearest = 1e30;
    int proven = 0, open = 0;
    for (int k = 0; k <= 26; ++k) {
        TreeCase cloth = notched(9, 0.17f);
        const float lip = std::atan2(0.25f, 0.17f), closed = lip * (1 - static_cast<float>(k) / 24);
        for (std::size_t v = 0; v < cloth.t0.size(); ++v) {
            const glm::vec3 p = cloth.rest[v] - glm::vec3(0.5f, 0.83f, 0);  // from the bottom of the notch
            const float angle = std::atan2(p.x, p.y), r = std::hypot(p.x, p.y);
            const float turned = pi - (pi - std::abs(angle)) * (pi - closed) / (pi - lip);
            cloth.t1[v] = glm::vec4(std::copysign(r, angle) * std::sin(turned), r * std::cos(turned), 0, 1);
        }
        FaceTree tree = cloth.tree();
        tree.refit({cloth.t1, cloth.t1}, {distance, Culling::sound}, pool);
        const double least = element_distance(cloth, {cloth.t1, cloth.t1}, 0);
        nearest = std::min(nearest, least);
        (tree.is_proven_apart() ? proven : open)++;
        if (tree.is_proven_apart()) nearest_proven = std::min(nearest_proven, least);
    }
    EXPECT_GT(proven, 3);
    EXPECT_GT(open, 3);
    EXPECT_GT(nearest_proven, double(distance));
    EXPECT_LT(nearest, double(distance));
}

}  // namespace
}  // namespace nuno
