// Cuts the spring table into blocks.
#include "solver/spring_blocks.h"

#include <algorithm>

namespace nuno {
namespace {

// The neighbour of lane 0 if the lanes that have a spring step by one, else kGather.
std::int32_t run_of(const std::uint32_t* neighbours, const float* rest_lengths)
{
    bool found = false;
    std::int32_t run = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
        if (rest_lengths[lane] < 0) continue;
        const std::int32_t start = static_cast<std::int32_t>(neighbours[lane]) - lane;
        if (found && start != run) return SpringBlocks::kGather;
        run = start;
        found = true;
    }
    return run;
}

}  // namespace

SpringBlocks make_spring_blocks(const SpringTable& table)
{
    SpringBlocks blocks;
    const std::uint32_t n = table.vertex_count;
    for (std::uint32_t first = 0; first < n; first += kLanes) {
        blocks.first_slot.push_back(static_cast<std::uint32_t>(blocks.slots.size()));
        for (int kind = 0; kind < kSpringKindCount; ++kind) {
            for (int slot = table.first_slot[kind]; slot < table.first_slot[kind + 1]; ++slot) {
                std::uint32_t neighbours[kLanes];
                float rest_lengths[kLanes];
                for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
                    const std::uint32_t v = std::min(first + lane, n - 1);
                    const std::size_t entry = static_cast<std::size_t>(slot) * n + v;
                    neighbours[lane] = table.neighbours[entry];
                    rest_lengths[lane] = first + lane < n ? table.rest_lengths[entry] : kNoSpring;
                }
                if (std::all_of(rest_lengths, rest_lengths + kLanes, [](float l) { return l < 0; })) continue;
                blocks.slots.push_back({run_of(neighbours, rest_lengths), kind});
                blocks.neighbours.insert(blocks.neighbours.end(), neighbours, neighbours + kLanes);
                blocks.rest_lengths.insert(blocks.rest_lengths.end(), rest_lengths, rest_lengths + kLanes);
            }
        }
    }
    blocks.first_slot.push_back(static_cast<std::uint32_t>(blocks.slots.size()));
    return blocks;
}

}  // namespace nuno
