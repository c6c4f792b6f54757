// Springs by fours: every spring once, no vertex twice in a group, and the order of colours kept.
#include "solver/xpbd/spring_quads.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/xpbd/mesh_constraints.h"
#include "support/sheets.h"

namespace nuno {
namespace {

// The springs of the first sheet of a model as its colours have them, in the sheet's own numbering.
ColouredSprings coloured(const ClothModel& model)
{
    MeshConstraints constraints(model, model.sheets[0]);
    const std::vector<SpringWeight> weights(model.springs.size(), SpringWeight{1, 0});
    const std::uint32_t vertex_count = model.vertex_count();
    constraints.choose(weights, vertex_count, MeshConstraints::Layout::springs);
    ColouredSprings springs;
    springs.first.push_back(0);
    const ConstraintColours& colours = constraints.springs();
    for (int colour = 0; colour < colours.colour_count(); ++colour) {
        for (int batch = colours.batches(colour).begin; batch < colours.batches(colour).end; ++batch)
            for (int lane = 0; lane < kColourBatch; ++lane) {
                const auto vertex = [&](int end) {
                    const std::uint32_t v = colours.ends(batch)[end * kColourBatch + lane] / 4;
                    return v < vertex_count ? static_cast<std::int32_t>(v) : -1;
                };
                springs.ends.emplace_back(vertex(0), vertex(1));
            }
        springs.first.push_back(static_cast<std::int32_t>(springs.ends.size()));
    }
    return springs;
}

// The springs in the order in which the groups take them; expects their ends at the corners that their sides join.
std::vector<std::int32_t> order_of(const ColouredSprings& springs, const SpringQuads& quads)
{
    std::vector<std::int32_t> order;
    for (const QuadGroup& group : quads.groups)
        for (int c = 0; c < group.colour_count; ++c)
            for (std::int32_t q = 0; q < group.count; ++q)
                for (int side = 0; side < 2; ++side) {
                    const auto place = static_cast<std::size_t>(group.first_sides + c * group.count + q);
                    const std::int32_t spring = quads.sides[place][side];
                    if (spring < 0) continue;
                    const auto& joined = kQuadSides[std::size_t(c)][std::size_t(side)];
                    const glm::ivec4 corners = quads.corners[static_cast<std::size_t>(group.first + q)];
                    EXPECT_EQ(springs.ends[std::size_t(spring)], glm::ivec2(corners[joined[0]], corners[joined[1]]));
                    order.push_back(spring);
                }
    return order;
}

void expect_valid(const ColouredSprings& springs, std::uint32_t vertex_count)
{
    const SpringQuads quads = make_spring_quads(springs, vertex_count);
    const std::vector<std::int32_t> order = order_of(springs, quads);
    std::vector<std::int32_t> all, sorted = order;
    for (std::size_t n = 0; n < springs.ends.size(); ++n)
        if (springs.ends[n].x >= 0) all.push_back(static_cast<std::int32_t>(n));
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, all) << "each spring once";
    const auto colour_of = [&](std::int32_t n) {
        return std::upper_bound(springs.first.begin(), springs.first.end(), n) - springs.first.begin();
    };
    for (std::size_t k = 1; k < order.size(); ++k) ASSERT_LE(colour_of(order[k - 1]), colour_of(order[k]));
    for (const QuadGroup& group : quads.groups) {
        std::vector<int> met(vertex_count);
        for (std::int32_t q = group.first; q < group.first + group.count; ++q)
            for (int k = 0; k < 4; ++k)
                if (const std::int32_t v = quads.corners[std::size_t(q)][k]; v >= 0) ++met[std::size_t(v)];
        EXPECT_LE(*std::max_element(met.begin(), met.end()), 1) << "a vertex in two quads of a group";
    }
}

TEST(SpringQuads, hold_every_spring_of_grids_and_meshes_once_in_the_order_of_colours)
{
    for (const int count : {2, 3, 8, 17}) {
        const ClothModel grid = square_cloth(count, 1, {0});
        expect_valid(coloured(grid), grid.vertex_count());
        const SheetSource source = square_mesh(count, 1);
        const ClothModel mesh = build_cloth_model(std::span(&source, 1), MassLumping::area);
        expect_valid(coloured(mesh), mesh.vertex_count());
    }
}

TEST(SpringQuads, take_the_twelve_colours_of_a_grid_in_six)
{
    for (const int count : {8, 17, 30}) {
        const ClothModel model = square_cloth(count, 1, {0});
        const ColouredSprings springs = coloured(model);
        EXPECT_EQ(springs.first.size(), 13u);
        EXPECT_EQ(make_spring_quads(springs, model.vertex_count()).groups.size(), 6u) << count;
    }
}

TEST(SpringQuads, leave_colours_apart_that_do_not_fit)
{
    const ColouredSprings chain{{0, 2, 3}, {{0, 1}, {2, 3}, {1, 2}}};
    EXPECT_EQ(make_spring_quads(chain, 4).groups.size(), 2u) << "the third joins corners 1 and 2, no side of colour 1";
    const ColouredSprings long_chain{{0, 2, 4}, {{0, 1}, {2, 3}, {1, 2}, {3, 4}}};
    EXPECT_EQ(make_spring_quads(long_chain, 5).groups.size(), 2u) << "five vertices hang together";
    const ColouredSprings star{{0, 1, 2, 3}, {{0, 1}, {0, 2}, {0, 3}}};
    EXPECT_EQ(make_spring_quads(star, 4).groups.size(), 1u) << "these fit";
    for (const ColouredSprings& springs : {chain, long_chain, star}) expect_valid(springs, 5);
}

}  // namespace
}  // namespace nuno
