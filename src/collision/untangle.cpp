// Step by step along both rules together, each step followed by sweeps that draw edges back to their lengths.
#include "collision/untangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "collision/untangle_moves.h"

namespace nuno {
namespace {

constexpr std::size_t kFewestSteps = 300, kMostSteps = 4000, kFaceSteps = 40'000'000;
constexpr int kStepsOfPhase = 60;
constexpr std::array<int, 3> kSpreadRounds{0, 6, 25};  // by phase, again and again: what is stuck moves as a patch
constexpr int kLengthSweeps = 4;
constexpr double kStepOfEdge = 0.05;  // largest step, over the mean length of the edges
constexpr double kShaking = 0.01;     // of a step

std::vector<MeshEdge> edges_of(std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const glm::uvec3& face : faces)
        for (int i = 0; i < 3; ++i) ends.push_back(std::minmax(face[i], face[(i + 1) % 3]));
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<MeshEdge> edges;
    for (const auto& [a, b] : ends)
        edges.push_back({a, b, glm::distance(glm::dvec3(positions[a]), glm::dvec3(positions[b]))});
    return edges;
}

double mean_length(std::span<const MeshEdge> edges)
{
    double sum = 0;
    for (const MeshEdge& edge : edges) sum += edge.length;
    return edges.empty() ? 0 : sum / double(edges.size());
}

// -1 .. 1, from a number alone.
double scattered(std::uint64_t number)
{
    number += 0x9e3779b97f4a7c15;  // splitmix64
    number = (number ^ number >> 30) * 0xbf58476d1ce4e5b9;
    number = (number ^ number >> 27) * 0x94d049bb133111eb;
    return double((number ^ number >> 31) >> 11) * 0x1p-52 - 1;
}

// The unit normal of a face, or of its opposite: the one whose largest component is positive. 0 without an area.
glm::dvec3 upward_normal(const glm::uvec3& face, std::span<const glm::vec4> positions)
{
    const glm::dvec3 a(positions[face.x]), b(positions[face.y]), c(positions[face.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a), size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double length = glm::length(normal);
    return length > 0 ? normal / (normal[axis] < 0 ? -length : length) : glm::dvec3(0);
}

// What touches has no direction to go to: the face of the higher number goes up, the other down, so that layers in one
// plane part, and all of it is shaken, so that it crosses or is apart.
void add_shaking(std::span<const Tangle> tangles, std::span<const glm::uvec3> faces,
                 std::span<const glm::vec4> positions, int step, Directions& ways)
{
    for (const Tangle& tangle : tangles) {
        if (tangle.meeting.kind != Meeting::touching) continue;
        const glm::dvec3 up = upward_normal(faces[tangle.faces.a], positions);
        for (const std::uint32_t face : {tangle.faces.a, tangle.faces.b})
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t v = faces[face][i];
                const std::uint64_t number = (std::uint64_t(step) << 34) + 4 * std::uint64_t{v};
                const glm::dvec3 shake(scattered(number), scattered(number + 1), scattered(number + 2));
                ways[v] += face == tangle.faces.a ? 0.25 * shake - up : 0.25 * shake + up;
            }
    }
    for (glm::dvec3& way : ways)
        if (way != glm::dvec3(0)) way *= kShaking / glm::length(way);
}

// Each way becomes the mean of itself and those beside it, round by round; what is left of a third of the longest is a
// whole step.
void spread(std::span<const MeshEdge> edges, int rounds, Directions& ways)
{
    std::vector<int> counts(ways.size(), 0);
    for (const MeshEdge& edge : edges) ++counts[edge.a], ++counts[edge.b];
    for (int round = 0; round < rounds; ++round) {
        Directions sums(ways.size(), glm::dvec3(0));
        for (const MeshEdge& edge : edges) {
            sums[edge.a] += ways[edge.b];
            sums[edge.b] += ways[edge.a];
        }
        for (std::size_t v = 0; v < ways.size(); ++v)
            if (counts[v] > 0) ways[v] = 0.5 * ways[v] + 0.5 / counts[v] * sums[v];
    }
    double longest = 0;
    for (const glm::dvec3& way : ways) longest = std::max(longest, glm::length(way));
    for (glm::dvec3& way : ways)
        if (longest > 0) way *= 3 / longest;
}

void take_step(const Directions& ways, double step, std::vector<glm::vec4>& positions)
{
    for (std::size_t v = 0; v < positions.size(); ++v) {
        if (positions[v].w == 0 || ways[v] == glm::dvec3(0)) continue;
        const double length = glm::length(ways[v]);
        const glm::vec3 moved(glm::dvec3(positions[v]) + (step / std::max(length, 1.0)) * ways[v]);
        positions[v] = glm::vec4(moved, positions[v].w);
    }
}

// Edges that are as long as they were are left as they are, to the bit.
void keep_lengths(std::span<const MeshEdge> edges, std::vector<glm::vec4>& positions)
{
    for (int sweep = 0; sweep < kLengthSweeps; ++sweep)
        for (const MeshEdge& edge : edges) {
            glm::vec4 &a = positions[edge.a], &b = positions[edge.b];
            const glm::dvec3 way = glm::dvec3(b) - glm::dvec3(a);
            const double length = glm::length(way);
            const int free = (a.w > 0) + (b.w > 0);
            if (length == edge.length || free == 0 || !(length > 0)) continue;
            const glm::dvec3 change = (length - edge.length) / (length * free) * way;
            if (a.w > 0) a = glm::vec4(glm::vec3(glm::dvec3(a) + change), a.w);
            if (b.w > 0) b = glm::vec4(glm::vec3(glm::dvec3(b) - change), b.w);
        }
}

float largest_move(std::span<const glm::vec4> from, std::span<const glm::vec4> to)
{
    float largest = 0;
    for (std::size_t v = 0; v < from.size(); ++v)
        largest = std::max(largest, glm::distance(glm::vec3(from[v]), glm::vec3(to[v])));
    return largest;
}

}  // namespace

UntangleResult untangle(TangleSearch& search, std::span<const glm::vec4> positions, ThreadPool& pool)
{
    const std::vector<MeshEdge> edges = edges_of(search.faces(), positions);
    const double step = kStepOfEdge * mean_length(edges);
    std::vector<glm::vec4> now(positions.begin(), positions.end());
    const auto most_steps = static_cast<int>(
        std::clamp(kFaceSteps / std::max<std::size_t>(search.faces().size(), 1), kFewestSteps, kMostSteps));
    const int steps_without_gain = std::max(3 * kStepsOfPhase, most_steps / 6);
    UntangleResult best;
    for (int taken = 0; taken <= most_steps && taken - best.steps <= steps_without_gain; ++taken) {
        const std::vector<Tangle> tangles = search.find(now, pool);
        const TangleCounts counts = count_of(tangles);
        if (taken == 0) best.before = counts;
        if (taken == 0 || counts.all() < best.left.all()) {
            best.left = counts;
            best.positions = now;
            best.steps = taken;
        }
        if (counts.all() == 0) break;
        Directions ways(now.size(), glm::dvec3(0));
        add_shaking(tangles, search.faces(), now, taken, ways);
        add_contour_moves(tangles, search.faces(), now, ways);
        add_side_moves(tangles, search.faces(), edges, now, ways);
        const int rounds = kSpreadRounds[std::size_t(taken / kStepsOfPhase) % kSpreadRounds.size()];
        if (rounds > 0) spread(edges, rounds, ways);
        take_step(ways, step, now);
        keep_lengths(edges, now);
    }
    best.largest_move = largest_move(positions, best.positions);
    return best;
}

}  // namespace nuno
