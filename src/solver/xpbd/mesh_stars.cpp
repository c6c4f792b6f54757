// The stars of a mesh, greedily.
#include "solver/xpbd/mesh_stars.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "solver/xpbd/first_fit.h"

namespace nuno {
namespace {

constexpr std::uint32_t kNoVertex = ~0u;

// The neighbours around each vertex in turn, from where the faces begin or else from the first.
class Rings
{
  public:
    Rings(std::span<const glm::uvec3> faces, std::uint32_t vertex_count) : sides_(vertex_count)
    {
        for (const glm::uvec3& face : faces)
            for (int k = 0; k < 3; ++k) sides_[face[k]].emplace_back(face[(k + 1) % 3], face[(k + 2) % 3]);
        for (auto& sides : sides_) std::sort(sides.begin(), sides.end());
    }

    std::vector<std::uint32_t> around(std::uint32_t vertex) const
    {
        std::vector<std::uint32_t> ring;
        for (std::uint32_t v = first(vertex); v != kNoVertex && ring.size() < std::size_t(Stars::kMostRing);
             v = after(vertex, v))
        {
            if (std::find(ring.begin(), ring.end(), v) != ring.end()) break;
            ring.push_back(v);
        }
        return ring;
    }

  private:
    std::uint32_t first(std::uint32_t vertex) const
    {
        const auto& sides = sides_[vertex];
        const auto follows = [&](std::uint32_t v) {
            return std::any_of(sides.begin(), sides.end(), [&](const auto& side) { return side.second == v; });
        };
        for (const auto& side : sides)
            if (!follows(side.first)) return side.first;
        return sides.empty() ? kNoVertex : sides.front().first;
    }
    std::uint32_t after(std::uint32_t vertex, std::uint32_t v) const
    {
        for (const auto& [from, to] : sides_[vertex])
            if (from == v) return to;
        return kNoVertex;
    }

    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> sides_;  // opposite to each vertex
};

class SpringFinder
{
  public:
    explicit SpringFinder(std::span<const std::uint32_t> ends)
    {
        by_ends_.reserve(ends.size() / 2);
        for (std::size_t n = 0; n < ends.size() / 2; ++n) by_ends_.emplace(key(ends[2 * n], ends[2 * n + 1]), n);
    }
    std::size_t find(std::uint32_t a, std::uint32_t b) const
    {
        const auto found = by_ends_.find(key(a, b));
        return found == by_ends_.end() ? Star::kNoSpring : found->second;
    }

  private:
    static std::uint64_t key(std::uint32_t a, std::uint32_t b)
    {
        return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
    }
    std::unordered_map<std::uint64_t, std::size_t> by_ends_;
};

Star star_of(std::uint32_t centre, const Rings& rings, const SpringFinder& springs)
{
    Star star{{centre}, {}};
    const std::vector<std::uint32_t> ring = rings.around(centre);
    star.vertices.insert(star.vertices.end(), ring.begin(), ring.end());
    for (const std::uint32_t v : ring) star.springs.push_back(springs.find(centre, v));
    for (const std::size_t on : {1, 2})
        for (std::size_t k = 0; k < ring.size(); ++k)
            star.springs.push_back(springs.find(ring[k], ring[(k + on) % ring.size()]));
    return star;
}

// Springs that this star would hold, each once.
std::size_t drop_taken(Star& star, const std::vector<bool>& taken)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < star.springs.size(); ++k) {
        std::size_t& spring = star.springs[k];
        if (spring == Star::kNoSpring) continue;
        if (taken[spring] || std::count(star.springs.begin(), star.springs.begin() + std::ptrdiff_t(k), spring) > 0)
            spring = Star::kNoSpring;
        else
            ++count;
    }
    return count;
}

}  // namespace

Stars find_stars(std::span<const std::uint32_t> ends, std::span<const glm::uvec3> faces, std::uint32_t vertex_count)
{
    const Rings rings(faces, vertex_count);
    const SpringFinder springs(ends);
    std::vector<Star> candidates;
    for (std::uint32_t v = 0; v < vertex_count; ++v)
        if (Star star = star_of(v, rings, springs); star.ring() >= Stars::kLeastRing)
            candidates.push_back(std::move(star));
    Stars found;
    std::vector<bool> taken(ends.size() / 2);
    for (const double least : {3.0, 2.5, 2.0, 1.5, 1.0})  // springs a vertex of the ring
        for (Star& star : candidates) {
            const std::size_t count = drop_taken(star, taken);
            if (count == 0 || double(count) < least * star.ring()) continue;
            for (const std::size_t spring : star.springs)
                if (spring != Star::kNoSpring) taken[spring] = true;
            found.stars.push_back(star);
        }
    for (std::size_t n = 0; n < taken.size(); ++n)
        if (!taken[n]) found.left_over.push_back(n);
    return found;
}

std::vector<std::size_t> colour_stars(std::span<const Star> stars, std::uint32_t vertex_count)
{
    FirstFit fit(vertex_count);
    std::vector<std::size_t> colours;
    for (const Star& star : stars) colours.push_back(fit.colour(star.vertices));
    return colours;
}

}  // namespace nuno
