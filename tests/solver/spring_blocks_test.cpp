// The blocks that the CPU reads hold what the table holds.
#include "solver/spring_blocks.h"

#include <gtest/gtest.h>

#include <compare>
#include <set>

#include "support/sheets.h"

namespace nuno {
namespace {

struct Entry
{
    std::uint32_t vertex, neighbour;
    int kind;
    float rest_length;
    auto operator<=>(const Entry&) const = default;
};

TEST(SpringBlocks, hold_every_spring_of_the_table_as_run_or_gather)
{
    for (const SheetSource& source : {square_sheet(17, 1), square_mesh(12, 1), square_mesh(12, 1, 16)}) {
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        const SpringBlocks blocks = make_spring_blocks(model.spring_table);
        std::multiset<Entry> expected, found;
        for (const Spring& s : model.springs) {
            expected.insert({s.a, s.b, int(s.kind), s.rest_length});
            expected.insert({s.b, s.a, int(s.kind), s.rest_length});
        }
        for (std::uint32_t block = 0; block + 1 < blocks.first_slot.size(); ++block)
            for (std::uint32_t slot = blocks.first_slot[block]; slot < blocks.first_slot[block + 1]; ++slot)
                for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
                    const float rest_length = blocks.rest_lengths[slot * kLanes + lane];
                    if (rest_length < 0) continue;
                    const SpringBlockSlot info = blocks.slots[slot];
                    const std::uint32_t neighbour = info.run == SpringBlocks::kGather
                                                        ? blocks.neighbours[slot * kLanes + lane]
                                                        : std::uint32_t(info.run + std::int32_t(lane));
                    found.insert({block * kLanes + lane, neighbour, info.kind, rest_length});
                }
        EXPECT_EQ(found, expected);
    }
}

TEST(SpringBlocks, a_grid_is_read_in_runs_only)
{
    const ClothModel model = square_cloth(33, 1);
    for (const SpringBlockSlot& slot : make_spring_blocks(model.spring_table).slots)
        EXPECT_NE(slot.run, SpringBlocks::kGather);
}

}  // namespace
}  // namespace nuno
