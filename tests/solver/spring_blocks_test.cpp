// The blocks that the CPU reads hold what the entries hold.
#include "solver/base/spring_blocks.h"

#include <gtest/gtest.h>

#include <compare>
#include <set>

#include "support/sheets.h"

namespace nuno {
namespace {

struct Entry
{
    std::uint32_t vertex, neighbour;
    float stiffness, tension, axial;
    auto operator<=>(const Entry&) const = default;
};

SimParams with_plate()
{
    SimParams params;
    params.bending_warp = 1e-4f;
    params.bending_weft = 2e-4f;
    params.bending_bias = 3e-4f;
    return params;
}

TEST(SpringBlocks, hold_every_spring_of_the_model_as_run_or_gather)
{
    const SimParams params = with_plate();
    for (const SheetSource& source : {square_sheet(17, 1), square_mesh(12, 1), square_mesh(12, 1, 16)}) {
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        const SpringBlocks blocks = make_spring_blocks(spring_entries(model, params));
        const std::vector<SpringWeight> weights = spring_weights(model, params);
        std::multiset<Entry> expected, found;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const Spring& s = model.springs[i];
            const float stiffness = weights[i].axial + weights[i].plate, tension = weights[i].axial * s.rest_length;
            expected.insert({s.a, s.b, stiffness, tension, weights[i].axial});
            expected.insert({s.b, s.a, stiffness, tension, weights[i].axial});
        }
        for (std::uint32_t block = 0; block + 1 < blocks.first_slot.size(); ++block)
            for (std::uint32_t slot = blocks.first_slot[block]; slot < blocks.first_slot[block + 1]; ++slot)
                for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
                    const std::size_t i = slot * kLanes + lane;
                    if (blocks.stiffness[i] == 0 && blocks.tension[i] == 0) continue;
                    const std::int32_t first = blocks.runs[slot];
                    const std::uint32_t neighbour = first == SpringBlocks::kGather
                                                        ? blocks.neighbours[i]
                                                        : std::uint32_t(first + std::int32_t(lane));
                    found.insert(
                        {block * kLanes + lane, neighbour, blocks.stiffness[i], blocks.tension[i], blocks.axial[i]});
                }
        EXPECT_EQ(found, expected);
    }
}

TEST(SpringBlocks, a_grid_is_read_in_runs_only)
{
    const ClothModel model = square_cloth(33, 1);
    for (const std::int32_t first : make_spring_blocks(spring_entries(model, SimParams())).runs)
        EXPECT_NE(first, SpringBlocks::kGather);
}

TEST(SpringBlocks, springs_without_a_force_are_left_out)
{
    const ClothModel model = square_cloth(17, 1);
    SimParams params;
    const std::size_t all = make_spring_blocks(spring_entries(model, params)).runs.size();
    params.bend_stiffness = 0;
    const std::size_t without_bend = make_spring_blocks(spring_entries(model, params)).runs.size();
    EXPECT_LT(without_bend, all);
    params.internal_model = InternalModel::continuum;
    EXPECT_EQ(make_spring_blocks(spring_entries(model, params)).runs.size(), 0u);
}

}  // namespace
}  // namespace nuno
