// Lays springs out by vertex and slot.
#include "model/spring_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace nuno {
namespace {

constexpr int kMostSlots = 256;

int round_up_to_4(int count) { return (count + 3) / 4 * 4; }

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
    std::fill(counts.begin(), counts.end(), Counts{});
    for (const Spring& spring : springs) {
        const int kind = static_cast<int>(spring.kind);
        for (const auto& [from, to] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
            const auto slot = static_cast<std::size_t>(table.first_slot[kind] + counts[from][kind]++);
            table.neighbours[slot * vertex_count + from] = to;
            table.rest_lengths[slot * vertex_count + from] = spring.rest_length;
        }
    }
    return table;
}

}  // namespace nuno
