// Springs in stars: each is in one star or left over, and a star holds what it says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/xpbd/mesh_stars.h"
#include "support/sheets.h"

namespace nuno {
namespace {

ClothModel mesh_of_any_valence(int columns, int rows)
{
    SheetSource source;
    source.mesh = cut_at_random(grid_mesh(columns, rows, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), columns, rows);
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

std::vector<std::uint32_t> ends_of(const ClothModel& model)
{
    std::vector<std::uint32_t> ends;
    for (const Spring& spring : model.springs) ends.insert(ends.end(), {spring.a, spring.b});
    return ends;
}

using Pair = std::set<std::uint32_t>;

TEST(MeshStars, hold_every_spring_once_between_the_vertices_that_they_say)
{
    const ClothModel model = mesh_of_any_valence(30, 20);
    const std::vector<std::uint32_t> ends = ends_of(model);
    const Stars found = find_stars(ends, model.faces, model.vertex_count());
    std::vector<int> count(model.springs.size());
    std::set<int> rings;
    for (const Star& star : found.stars) {
        const auto ring = static_cast<std::size_t>(star.ring());
        rings.insert(star.ring());
        EXPECT_EQ(std::set(star.vertices.begin(), star.vertices.end()).size(), ring + 1) << "all different";
        ASSERT_EQ(star.springs.size(), 3 * ring);
        for (std::size_t k = 0; k < 3 * ring; ++k) {
            if (star.springs[k] == Star::kNoSpring) continue;
            ++count[star.springs[k]];
            const auto at = [&](std::size_t place) { return star.vertices[1 + place % ring]; };
            const Pair said = k < ring       ? Pair{star.vertices[0], at(k)}
                              : k < 2 * ring ? Pair{at(k - ring), at(k - ring + 1)}
                                             : Pair{at(k - 2 * ring), at(k - 2 * ring + 2)};
            const Spring& spring = model.springs[star.springs[k]];
            EXPECT_EQ((Pair{spring.a, spring.b}), said);
        }
    }
    for (const std::size_t spring : found.left_over) ++count[spring];
    EXPECT_TRUE(std::all_of(count.begin(), count.end(), [](int c) { return c == 1; }));
    EXPECT_TRUE(std::is_sorted(found.left_over.begin(), found.left_over.end()));
    EXPECT_EQ(rings, (std::set{4, 5, 6, 7})) << "every size is there to be tested";
    EXPECT_LT(found.left_over.size(), model.springs.size() * 2 / 5);
}

TEST(MeshStars, of_a_regular_mesh_hold_three_springs_of_four)
{
    const SheetSource source = square_mesh(40, 1);
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    const Stars found = find_stars(ends_of(model), model.faces, model.vertex_count());
    EXPECT_LT(found.left_over.size(), model.springs.size() * 27 / 100);
}

// A disk around one vertex puts more stars there than a word has bits.
TEST(MeshStars, of_one_colour_share_no_vertex)
{
    constexpr std::uint32_t around = 126;
    SheetSource disk;
    disk.mesh.positions.emplace_back(0, 0, 0);
    for (const float radius : {1.0f, 2.0f})
        for (std::uint32_t k = 0; k < around; ++k) {
            const float angle = 6.2831853f * float(k) / float(around);
            disk.mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
    for (std::uint32_t k = 0; k < around; ++k) {
        const std::uint32_t a = 1 + k, b = 1 + (k + 1) % around;
        for (const glm::uvec3 face : {glm::uvec3(0, a, b), {a, a + around, b}, {b, a + around, b + around}})
            disk.mesh.faces.push_back(face);
    }
    disk.mesh.uvs.resize(disk.mesh.positions.size());
    for (const ClothModel& model :
         {build_cloth_model(std::span(&disk, 1), MassLumping::equal), mesh_of_any_valence(30, 20)})
    {
        const Stars found = find_stars(ends_of(model), model.faces, model.vertex_count());
        const std::vector<std::size_t> colours = colour_stars(found.stars, model.vertex_count());
        ASSERT_EQ(colours.size(), found.stars.size());
        std::set<std::pair<std::size_t, std::uint32_t>> seen;
        for (std::size_t n = 0; n < colours.size(); ++n)
            for (const std::uint32_t v : found.stars[n].vertices)
                EXPECT_TRUE(seen.emplace(colours[n], v).second) << "star " << n << ", vertex " << v;
    }
    const ClothModel model = build_cloth_model(std::span(&disk, 1), MassLumping::equal);
    EXPECT_GT(find_stars(ends_of(model), model.faces, model.vertex_count()).stars.size(), 64u);
}

TEST(MeshStars, leave_a_mesh_too_small_for_them_as_it_is)
{
    SheetSource source;
    source.mesh = grid_mesh(2, 2, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    const Stars found = find_stars(ends_of(model), model.faces, model.vertex_count());
    EXPECT_TRUE(found.stars.empty());
    EXPECT_EQ(found.left_over.size(), model.springs.size());
}

}  // namespace
}  // namespace nuno
