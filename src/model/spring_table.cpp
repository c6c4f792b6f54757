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

// The offsets that most springs of a kind have, at most `count` of them, most frequent first.
std::vector<Offset> frequent_offsets(std::span<const Spring> springs, SpringKind kind, int count)
{
    std::map<Offset, int> uses;
    for (const Spring& spring : springs) {
        if (spring.kind != kind) continue;
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

// Fills the slots of a kind: a frequent offset has a slot of its own, so that in rows of a grid the neighbours in one
// slot follow one another from vertex to vertex; the other springs take the slots that are left, in the order of
// `springs`.
void place_springs(SpringTable& table, std::span<const Spring> springs, SpringKind kind)
{
    const int first = table.first_slot[static_cast<int>(kind)], end = table.first_slot[static_cast<int>(kind) + 1];
    const std::vector<Offset> own_slot = frequent_offsets(springs, kind, end - first);
    const auto entry = [&](int slot, std::uint32_t v) {
        return static_cast<std::size_t>(slot) * table.vertex_count + v;
    };
    const auto put = [&](int slot, std::uint32_t from, std::uint32_t to, float rest_length) {
        table.neighbours[entry(slot, from)] = to;
        table.rest_lengths[entry(slot, from)] = rest_length;
    };
    for (const bool frequent : {true, false})
        for (const Spring& spring : springs) {
            if (spring.kind != kind) continue;
            for (const auto& [from, to] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
                const auto own = std::find(own_slot.begin(), own_slot.end(), Offset(to) - Offset(from));
                if ((own != own_slot.end()) != frequent) continue;
                int slot = first + static_cast<int>(own - own_slot.begin());
                if (!frequent)
                    for (slot = first; table.rest_lengths[entry(slot, from)] >= 0;) ++slot;
                put(slot, from, to, spring.rest_length);
            }
        }
}

}  // namespace

SpringTable make_spring_table(std::span<const Spring> springs, std::uint32_t vertex_count)
{
    using Counts = std::array<int, kSpringKindCount>;
    std::vector<Counts> counts(vertex_count, Counts{});
    Counts widest{};
    for (const Spring& spring : springs)
        for (const std::uint32_t v : {spring.a, spring.b}) {
            int& count = counts[v][static_cast<int>(spring.kind)];
            widest[static_cast<int>(spring.kind)] = std::max(widest[static_cast<int>(spring.kind)], ++count);
        }

    SpringTable table;
    table.vertex_count = vertex_count;
    for (int kind = 0; kind < kSpringKindCount; ++kind)
        table.first_slot[kind + 1] = table.first_slot[kind] + round_up_to_4(widest[kind]);
    if (table.slot_count() > kMostSlots)
        throw Error(
            fmt::format("mesh: a vertex has so many neighbours that {} spring slots are needed; at most {} are "
                        "possible; split the faces around it",
                        table.slot_count(), kMostSlots));

    const std::size_t size = static_cast<std::size_t>(table.slot_count()) * vertex_count;
    table.neighbours.resize(size);
    table.rest_lengths.assign(size, kNoSpring);
    for (std::size_t i = 0; i < size; ++i) table.neighbours[i] = static_cast<std::uint32_t>(i % vertex_count);
    for (int kind = 0; kind < kSpringKindCount; ++kind) place_springs(table, springs, static_cast<SpringKind>(kind));
    return table;
}

}  // namespace nuno
