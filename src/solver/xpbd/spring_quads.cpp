// Which colours go together, and which corner of its quad each vertex is.
#include "solver/xpbd/spring_quads.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace nuno {
namespace {

constexpr std::size_t kCorners = 4;

// Springs that hang together, and the vertices where they meet.
struct Cluster
{
    std::vector<std::int32_t> vertices;
    std::vector<std::array<std::int32_t, 2>> springs;  // number, colour within the group
};

// Sets of vertices, each known by one of its own.
class VertexSets
{
  public:
    explicit VertexSets(std::uint32_t vertex_count) : parents_(vertex_count)
    {
        std::iota(parents_.begin(), parents_.end(), 0);
    }
    std::int32_t set_of(std::int32_t vertex)
    {
        for (std::int32_t* parent = &parents_[std::size_t(vertex)]; *parent != vertex;
             parent = &parents_[std::size_t(vertex)]) {
            *parent = parents_[std::size_t(*parent)];  // halves the way of those that come after
            vertex = *parent;
        }
        return vertex;
    }
    void unite(std::int32_t a, std::int32_t b) { parents_[std::size_t(set_of(a))] = set_of(b); }

  private:
    std::vector<std::int32_t> parents_;
};

// Nothing where more than four vertices hang together.
std::optional<std::vector<Cluster>> find_clusters(const ColouredSprings& springs, int colour, int colour_count,
                                                  std::uint32_t vertex_count)
{
    const auto first = [&](int c) { return springs.first[std::size_t(c)]; };
    VertexSets sets(vertex_count);
    for (std::int32_t n = first(colour); n < first(colour + colour_count); ++n)
        if (const glm::ivec2 ends = springs.ends[std::size_t(n)]; ends.x >= 0) sets.unite(ends.x, ends.y);
    std::vector<Cluster> clusters;
    std::vector<std::int32_t> cluster_of(vertex_count, -1);
    for (int c = colour; c < colour + colour_count; ++c)
        for (std::int32_t n = first(c); n < first(c + 1); ++n) {
            const glm::ivec2 ends = springs.ends[std::size_t(n)];
            if (ends.x < 0) continue;
            std::int32_t& number = cluster_of[std::size_t(sets.set_of(ends.x))];
            if (number < 0) {
                number = static_cast<std::int32_t>(clusters.size());
                clusters.emplace_back();
            }
            Cluster& cluster = clusters[std::size_t(number)];
            cluster.springs.push_back({n, c - colour});
            for (const std::int32_t v : {ends.x, ends.y})
                if (std::find(cluster.vertices.begin(), cluster.vertices.end(), v) == cluster.vertices.end())
                    cluster.vertices.push_back(v);
            if (cluster.vertices.size() > kCorners) return std::nullopt;
        }
    return clusters;
}

// Which side of its colour a spring from one corner to another is; -1: none.
int side_of(int colour, int from, int to)
{
    for (int side = 0; side < 2; ++side)
        if (kQuadSides[std::size_t(colour)][std::size_t(side)] == std::array{from, to}) return side;
    return -1;
}

// Vertices at the four corners such that each spring stands on a side of its colour; nothing where there are none.
std::optional<glm::ivec4> place_corners(const ColouredSprings& springs, const Cluster& cluster)
{
    std::array<std::int32_t, kCorners> corners{-1, -1, -1, -1};
    std::copy(cluster.vertices.begin(), cluster.vertices.end(), corners.begin());
    std::sort(corners.begin(), corners.end());
    const auto corner_of = [&](std::int32_t vertex) {
        return static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
    };
    do {
        const auto fits = [&](const std::array<std::int32_t, 2>& spring) {
            const glm::ivec2 ends = springs.ends[std::size_t(spring[0])];
            return side_of(spring[1], corner_of(ends.x), corner_of(ends.y)) >= 0;
        };
        if (std::all_of(cluster.springs.begin(), cluster.springs.end(), fits))
            return glm::ivec4(corners[0], corners[1], corners[2], corners[3]);
    } while (std::next_permutation(corners.begin(), corners.end()));
    return std::nullopt;
}

// False, and nothing appended, where the colours cannot go together.
bool append_group(const ColouredSprings& springs, int colour, int colour_count, std::uint32_t vertex_count,
                  SpringQuads& quads)
{
    const std::optional<std::vector<Cluster>> clusters = find_clusters(springs, colour, colour_count, vertex_count);
    if (!clusters) return false;
    std::vector<glm::ivec4> corners;
    for (const Cluster& cluster : *clusters) {
        const std::optional<glm::ivec4> placed = place_corners(springs, cluster);
        if (!placed) return false;
        corners.push_back(*placed);
    }
    QuadGroup group{colour_count, static_cast<std::int32_t>(quads.corners.size()),
                    static_cast<std::int32_t>(corners.size()), static_cast<std::int32_t>(quads.sides.size())};
    quads.groups.push_back(group);
    quads.corners.insert(quads.corners.end(), corners.begin(), corners.end());
    quads.sides.resize(quads.sides.size() + corners.size() * std::size_t(colour_count), glm::ivec2(-1));
    for (std::int32_t q = 0; q < group.count; ++q)
        for (const auto& [n, c] : (*clusters)[std::size_t(q)].springs) {
            const glm::ivec4 placed = corners[std::size_t(q)];
            const glm::ivec2 ends = springs.ends[std::size_t(n)];
            const auto corner_of = [&](std::int32_t vertex) {
                int k = 0;
                while (placed[k] != vertex) ++k;
                return k;
            };
            quads.sides[std::size_t(group.first_sides + c * group.count + q)]
                       [side_of(c, corner_of(ends.x), corner_of(ends.y))] = n;
        }
    return true;
}

// A colour by itself: two springs a quad, since they need not hang together.
void append_colour(const ColouredSprings& springs, int colour, SpringQuads& quads)
{
    QuadGroup group{1, static_cast<std::int32_t>(quads.corners.size()), 0,
                    static_cast<std::int32_t>(quads.sides.size())};
    int side = 2;
    for (std::int32_t n = springs.first[std::size_t(colour)]; n < springs.first[std::size_t(colour) + 1]; ++n) {
        const glm::ivec2 ends = springs.ends[std::size_t(n)];
        if (ends.x < 0) continue;
        if (side == 2) {
            side = 0;
            ++group.count;
            quads.corners.emplace_back(-1);
            quads.sides.emplace_back(-1);
        }
        const auto& corners = kQuadSides[0][std::size_t(side)];
        quads.corners.back()[corners[0]] = ends.x;
        quads.corners.back()[corners[1]] = ends.y;
        quads.sides.back()[side++] = n;
    }
    quads.groups.push_back(group);
}

}  // namespace

SpringQuads make_spring_quads(const ColouredSprings& springs, std::uint32_t vertex_count)
{
    SpringQuads quads;
    const int colour_total = static_cast<int>(springs.first.size()) - 1;
    for (int colour = 0; colour < colour_total;) {
        int count = std::min(kMostQuadColours, colour_total - colour);
        while (count > 1 && !append_group(springs, colour, count, vertex_count, quads)) --count;
        if (count == 1) append_colour(springs, colour, quads);
        colour += count;
    }
    return quads;
}

}  // namespace nuno
