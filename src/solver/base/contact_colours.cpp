// Each contact gets a colour that is free at its four vertices, the first one or its own one if that is.
#include "solver/base/contact_colours.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/hash.h"

namespace nuno {
namespace {

// Colours are given out in batches of 64, the bits of a mask at every vertex; what a batch has no room for waits for the
// next.
constexpr std::uint32_t kBatch = 64;

// The colour of a batch that a contact takes first. It is as good as random, and depends on nothing else: where a few
// contacts come and go, nearly all others keep their colours. The first free one instead would give most of them a new
// one, and layers at rest never come to rest where contacts are answered in another order in each pass.
std::uint32_t own_colour(const LayerContact& contact)
{
    Fnv1a hash;
    hash.add(&contact.vertices, sizeof contact.vertices);
    hash.add(&contact.kind, sizeof contact.kind);
    return static_cast<std::uint32_t>(hash.value() >> 32) % kBatch;
}

}  // namespace

ContactColours colour_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count, ContactOrder order)
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
            const std::uint32_t own = order == ContactOrder::steady ? own_colour(contacts[i]) : 0;
            const auto free = (own + std::uint32_t(std::countr_one(std::rotr(taken, int(own))))) % kBatch;
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
    sorted.starts.erase(std::unique(sorted.starts.begin(), sorted.starts.end()), sorted.starts.end());  // empty colours
    return sorted;
}

}  // namespace nuno
