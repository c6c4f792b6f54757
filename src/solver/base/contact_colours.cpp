// Each contact gets the first colour that is free at its four vertices.
#include "solver/base/contact_colours.h"

#include <bit>
#include <numeric>

namespace nuno {
namespace {

// Colours are given out in batches of 64, the bits of a mask at every vertex; what a batch has no room for waits for the
// next.
constexpr std::uint32_t kBatch = 64;

}  // namespace

ContactColours colour_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count)
{
    std::vector<std::uint32_t> colours(contacts.size()), waiting(contacts.size()), later;
    std::vector<std::uint64_t> used(vertex_count);
    std::iota(waiting.begin(), waiting.end(), 0u);
    std::uint32_t colour_count = 0;
    for (std::uint32_t first = 0; !waiting.empty(); first += kBatch) {
        later.clear();
        for (const std::uint32_t i : waiting) {
            const glm::uvec4& v = contacts[i].vertices;
            const std::uint64_t taken = used[v.x] | used[v.y] | used[v.z] | used[v.w];
            if (~taken == 0) {
                later.push_back(i);
                continue;
            }
            const auto free = static_cast<std::uint32_t>(std::countr_one(taken));
            for (int corner = 0; corner < 4; ++corner) used[v[corner]] |= std::uint64_t{1} << free;
            colours[i] = first + free;
            colour_count = std::max(colour_count, colours[i] + 1);
        }
        waiting.swap(later);
        if (!waiting.empty()) std::fill(used.begin(), used.end(), std::uint64_t{0});
    }

    ContactColours sorted{std::vector<LayerContact>(contacts.size()), std::vector<std::uint32_t>(colour_count + 1)};
    for (const std::uint32_t colour : colours) ++sorted.starts[colour + 1];
    std::partial_sum(sorted.starts.begin(), sorted.starts.end(), sorted.starts.begin());
    std::vector<std::uint32_t> next(sorted.starts.begin(), sorted.starts.end() - 1);
    for (std::size_t i = 0; i < contacts.size(); ++i) sorted.contacts[next[colours[i]]++] = contacts[i];
    return sorted;
}

}  // namespace nuno
