// Cuts the springs of the vertices into blocks.
#include "solver/base/spring_blocks.h"

#include <algorithm>
#include <array>

namespace nuno {
namespace {

// One slot of a block: entry of each lane, or kNone where it has no spring.
constexpr std::size_t kNone = ~std::size_t(0);
using Slot = std::array<std::size_t, kLanes>;

bool has_force(const SpringEntries& entries, std::size_t i)
{
    return entries.stiffness[i] != 0 || entries.tension[i] != 0;
}

// The neighbour of lane 0 if the lanes that have a spring step by one, else kGather.
Run run_of(const SpringEntries& entries, const Slot& slot)
{
    bool found = false;
    Run run = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
        const std::size_t i = slot[static_cast<std::size_t>(lane)];
        if (i == kNone) continue;
        const Run start = static_cast<Run>(entries.neighbours[i]) - lane;
        if (found && start != run) return SpringBlocks::kGather;
        run = start;
        found = true;
    }
    return run;
}

void append_slot(SpringBlocks& blocks, const SpringEntries& entries, const Slot& slot, std::uint32_t first_vertex)
{
    blocks.runs.push_back(run_of(entries, slot));
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t i = slot[lane];
        const bool present = i != kNone;
        const std::uint32_t itself = std::min(first_vertex + lane, entries.vertex_count - 1);
        blocks.neighbours.push_back(present ? entries.neighbours[i] : itself);
        blocks.stiffness.push_back(present ? entries.stiffness[i] : 0);
        blocks.tension.push_back(present ? entries.tension[i] : 0);
        blocks.axial.push_back(present ? entries.axial[i] : 0);
    }
}

}  // namespace

SpringBlocks make_spring_blocks(const SpringEntries& entries)
{
    SpringBlocks blocks;
    const std::uint32_t n = entries.vertex_count;
    for (std::uint32_t first = 0; first < n; first += kLanes) {
        blocks.first_slot.push_back(static_cast<std::uint32_t>(blocks.runs.size()));
        for (int slot = 0; slot < entries.slot_count; ++slot) {
            Slot lanes;
            for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
                const std::size_t i = static_cast<std::size_t>(slot) * n + first + lane;
                lanes[lane] = first + lane < n && has_force(entries, i) ? i : kNone;
            }
            if (std::any_of(lanes.begin(), lanes.end(), [](std::size_t i) { return i != kNone; }))
                append_slot(blocks, entries, lanes, first);
        }
    }
    blocks.first_slot.push_back(static_cast<std::uint32_t>(blocks.runs.size()));
    return blocks;
}

}  // namespace nuno
