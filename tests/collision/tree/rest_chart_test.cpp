// Which meshes have a chart, and that what it proves apart is apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "collision/tree/rest_chart.h"
#include "collision/tree/rest_rim.h"
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

bool has_chart(const TreeCase& cloth) { return RestChart::make(cloth.rest, cloth.faces, cloth.sheets[0]).has_value(); }

TEST(RestChart, flat_convex_sheets_without_holes_have_one)
{
    EXPECT_TRUE(has_chart(disc(5, 0)));
    EXPECT_TRUE(has_chart(in_random_order(disc(5, 0), 1)));
    EXPECT_TRUE(has_chart(cut_at_random(as_mesh("flat", flat_sheet(9)), 1)));
}

TEST(RestChart, others_have_none)
{
    EXPECT_FALSE(has_chart(disc(5, 0.05f))) << "a notch";
    TreeCase hole = as_mesh("hole", flat_sheet(9));
    hole.faces.erase(hole.faces.begin() + 60);
    hole.sheets[0].face_count -= 1;
    EXPECT_FALSE(has_chart(hole));
    TreeCase corner = as_mesh("without a corner", flat_sheet(9));
    corner.faces.erase(corner.faces.begin(), corner.faces.begin() + 2);
    corner.sheets[0].face_count -= 2;
    EXPECT_FALSE(has_chart(corner)) << "not convex";
    TreeCase bent = as_mesh("bent", flat_sheet(9));
    bent.rest[40].z = 0.01f;
    EXPECT_FALSE(has_chart(bent));
    TreeCase turned = as_mesh("turned over", flat_sheet(9));
    std::swap(turned.faces[7].x, turned.faces[7].y);
    EXPECT_FALSE(has_chart(turned));
    const TreeCase twice = together(as_mesh("two", flat_sheet(5)), as_mesh("two", flat_sheet(5)));
    TreeCase one_sheet = twice;
    one_sheet.sheets = {{"both", 0, 50, 0, 64, 0, 0, {}}};
    EXPECT_FALSE(has_chart(one_sheet));
    EXPECT_FALSE(has_chart(as_mesh("soup", face_soup(30, 1))));
}

// The rim of a polygon with one vertex pressed in: the angle of the two edges beside it.
TEST(RestChart, the_rim_is_as_rough_as_its_edges_turn_inwards)
{
    const std::vector<glm::dvec2> places{{0, 0}, {1, 1e-4}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    const std::vector<glm::uvec3> faces{{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}};
    const std::optional<double> roughness = rim_roughness(places, faces);
    ASSERT_TRUE(roughness);
    EXPECT_NEAR(*roughness, 1e-4, 1e-9);
}

// All elements against all, those of neighbouring faces too: where the tree says that a mesh is apart, it is.
TEST(RestChart, what_is_proven_apart_is_apart)
{
    ThreadPool pool(1);
    int proven = 0, open = 0;
    for (const TreeCase& flat : {disc(5, 0), in_random_order(disc(4, 0), 3), as_mesh("flat", flat_sheet(8)),
                                 as_grid("grid", flat_sheet(8), 8, 8)})
        for (int k = 0; k < 8; ++k) {
            TreeCase cloth = flat;
            const float height = 0.045f * static_cast<float>(k);
            for (std::size_t v = 0; v < cloth.t0.size(); ++v) {
                const glm::vec3 p = cloth.rest[v];
                cloth.t0[v] = glm::vec4(p.y, 0.8f * p.x, height * std::sin(5 * p.x) * std::cos(4 * p.y), 1);
                cloth.t1[v] = cloth.t0[v] + glm::vec4(1, 0, -height * std::sin(6 * p.y), 0);
            }
            constexpr float kDistance = 0.01f;
            FaceTree tree = cloth.tree();
            tree.refit(cloth.moving(), {kDistance, Culling::sound}, pool);
            (tree.is_proven_apart() ? proven : open)++;
            if (!tree.is_proven_apart()) continue;
            const double t = 0.25 * (k % 5);
            EXPECT_GT(element_distance(cloth, cloth.moving(), t), kDistance) << cloth.name << " " << k << " at " << t;
        }
    EXPECT_GT(proven, 6);
    EXPECT_GT(open, 3);
}

}  // namespace
}  // namespace nuno
