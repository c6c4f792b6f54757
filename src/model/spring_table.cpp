// Lays springs out by vertex and slot.
#include "model/spring_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/error.h"

namespace nuno {
namespace {

constexpr int kMostSlots = 256;

int round_up_to_4(int count) { return (count + 3) / 4 * 4; }

// The way from a vertex to a neighbour, as vertex numbers differ.
using Offset = std::int64_t;

// The offsets that most springs of a group have, at most `count` of them, most frequent first.
std::vector<Offset> frequent_offsets(std::span<const Spring> springs, int group, int count)
{
    std::map<Offset, int> uses;
    for (const Spring& spring : springs) {
        if (spring_group(spring.kind) != group) continue;
        ++uses[Offset(spring.b) - Offset(spring.a)];
        ++uses[Offset(spring.a) - Offset(spring.b)];
    }
    std::vector<std::pair<int, Offset>> ranked;
    for (const auto& [offset, use] : uses) ranked.emplace_back(-use, offset);
    std::sort(ranked.begin(), ranked.end());
    std::vector<Offset> offsets;
    for (std::size_t i = 0; i < ranked.size() && i < static_cast<std::size_t>(count); ++i)
        offsets.push_back(ranked[i].second);
    return offsets;
}

// Fills the slots of a group: a frequent offset has a slot of its own, so that in rows of a grid the neighbours in one
// slot follow one another from vertex to vertex; the other springs take the slots that are left, in the order of
// `springs`.
void place_springs(SpringTable& table, std::span<const Spring> springs, int group)
{
    const int first = table.first_slot[group], end = table.first_slot[group + 1];
    const std::vector<Offset> own_slot = frequent_offsets(springs, group, end - first);
    const auto entry = [&](int slot, std::uint32_t v) {
        return static_cast<std::size_t>(slot) * table.vertex_count + v;
    };
    for (const bool frequent : {true, false})
        for (std::uint32_t index = 0; index < springs.size(); ++index) {
            const Spring& spring = springs[index];
            if (spring_group(spring.kind) != group) continue;
            for (const auto& [from, to] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
                const auto own = std::find(own_slot.begin(), own_slot.end(), Offset(to) - Offset(from));
                if ((own != own_slot.end()) != frequent) continue;
                int slot = first + static_cast<int>(own - own_slot.begin());
                if (!frequent)
                    for (slot = first; table.springs[entry(slot, from)] != SpringTable::kNoSpring;) ++slot;
                table.neighbours[entry(slot, from)] = to;
                table.springs[entry(slot, from)] = index;
            }
        }
}

}  // namespace

int spring_group(SpringKind kind)
{
    switch (kind) {
    case SpringKind::weft:
    case SpringKind::warp:
    case SpringKind::edge: return 0;
    case SpringKind::shear: return 1;
    default: return 2;
    }
}

SpringTable make_spring_table(std::span<const Spring> springs, std::uint32_t vertex_count)
{
    using Counts = std::array<int, kSpringGroupCount>;
    std::vector<Counts> counts(vertex_count, Counts{});
    Counts widest{};
    for (const Spring& spring : springs)
        for (const std::uint32_t v : {spring.a, spring.b}) {
            const std::size_t group = static_cast<std::size_t>(spring_group(spring.kind));
            widest[group] = std::max(widest[group], ++counts[v][group]);
        }

    SpringTable table;
    table.vertex_count = vertex_count;
    for (int group = 0; group < kSpringGroupCount; ++group)
        table.first_slot[group + 1] = table.first_slot[group] + round_up_to_4(widest[group]);
    if (table.slot_count() > kMostSlots)
        throw Error(
            fmt::format("mesh: a vertex has so many neighbours that {} spring slots are needed; at most {} are "
                        "possible; split the faces around it",
                        table.slot_count(), kMostSlots));

    const std::size_t size = static_cast<std::size_t>(table.slot_count()) * vertex_count;
    table.neighbours.resize(size);
    table.springs.assign(size, SpringTable::kNoSpring);
    for (std::size_t i = 0; i < size; ++i) table.neighbours[i] = static_cast<std::uint32_t>(i % vertex_count);
    for (int group = 0; group < kSpringGroupCount; ++group) place_springs(table, springs, group);
    return table;
}

}  // namespace nuno
