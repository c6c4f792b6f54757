// Geodesic distances on a sheet at rest.
#include "model/tethers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::span<const glm::uvec3> faces_of(const ClothModel& model, const Sheet& sheet)
{
    return std::span(model.faces).subspan(sheet.first_face, sheet.face_count);
}

// Distance to c over a face whose corners a and b are at distances da and db (R. Kimmel, J. Sethian, Computing geodesic
// paths on manifolds, 1998): that to a point source in the plane of the face, unfolded; where the line from it leaves
// the face, along an edge.
double over_face(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, double da, double db)
{
    const double length = glm::distance(a, b);
    const double along_edges = std::min(da + glm::distance(a, c), db + glm::distance(b, c));
    const glm::dvec3 e = (b - a) / length;
    const double cx = glm::dot(c - a, e), cy = std::sqrt(std::max(glm::dot(c - a, c - a) - cx * cx, 0.0));
    const double sx = (da * da - db * db + length * length) / (2 * length);
    const double sy_sq = da * da - sx * sx;
    if (sy_sq < 0 || cy <= 0) return along_edges;
    const double sy = -std::sqrt(sy_sq), crossing = sx + (cx - sx) * (-sy) / (cy - sy);
    if (crossing < 0 || crossing > length) return along_edges;
    return std::hypot(cx - sx, cy - sy);
}

// Few anchors are tried one by one.
constexpr std::size_t kFewAnchors = 4;

}  // namespace

SheetGeodesics::SheetGeodesics(const ClothModel& model, const Sheet& sheet)
    : model_(model),
      sheet_(sheet),
      faces_(faces_of(model, sheet)),
      straight_(is_flat_and_convex(model, sheet)),
      first_around_(sheet.vertex_count + 1)
{
    for (const glm::uvec3& face : faces_)
        for (int k = 0; k < 3; ++k) ++first_around_[face[k] - sheet.first_vertex + 1];
    for (std::size_t v = 1; v < first_around_.size(); ++v) first_around_[v] += first_around_[v - 1];
    around_.resize(first_around_.back());
    std::vector<std::uint32_t> next(first_around_.begin(), first_around_.end() - 1);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
        for (int k = 0; k < 3; ++k) around_[next[faces_[f][k] - sheet.first_vertex]++] = f;
}

// Connected anchors in groups, in the order of their first vertex.
std::vector<std::vector<std::uint32_t>> SheetGeodesics::groups(std::span<const std::uint8_t> held) const
{
    std::vector<std::uint32_t> root(sheet_.vertex_count);
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = v;
    const std::function<std::uint32_t(std::uint32_t)> find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const glm::uvec3& face : faces_)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = face[k], b = face[(k + 1) % 3];
            if (!held[a] || !held[b]) continue;
            const std::uint32_t ra = find(a - sheet_.first_vertex), rb = find(b - sheet_.first_vertex);
            root[std::max(ra, rb)] = std::min(ra, rb);
        }
    std::map<std::uint32_t, std::vector<std::uint32_t>> found;
    for (std::uint32_t v = 0; v < root.size(); ++v)
        if (held[sheet_.first_vertex + v]) found[find(v)].push_back(sheet_.first_vertex + v);
    std::vector<std::vector<std::uint32_t>> result;
    for (auto& [first, group] : found) result.push_back(std::move(group));
    return result;
}

// Fast marching from the anchors; the anchor of a vertex is that of the corner it was reached from.
void SheetGeodesics::march(std::span<const std::uint32_t> anchors, std::vector<Tether>& nearest) const
{
    const auto at = [&](std::uint32_t v) { return glm::dvec3(model_.rest_positions[v]); };
    std::vector<double> distance(sheet_.vertex_count, std::numeric_limits<double>::infinity());
    std::vector<bool> done(sheet_.vertex_count);
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const auto reach = [&](std::uint32_t vertex, double d, std::uint32_t anchor) {
        const std::uint32_t v = vertex - sheet_.first_vertex;
        if (d >= distance[v]) return;
        distance[v] = d;
        nearest[v] = {anchor, static_cast<float>(d)};
        front.push({d, vertex});
    };
    for (const std::uint32_t anchor : anchors) reach(anchor, 0, anchor);
    while (!front.empty()) {
        const std::uint32_t a = front.top().second, local = a - sheet_.first_vertex;
        front.pop();
        if (done[local]) continue;
        done[local] = true;
        for (std::uint32_t k = first_around_[local]; k < first_around_[local + 1]; ++k) {
            const glm::uvec3 face = faces_[around_[k]];
            const int corner = face[0] == a ? 0 : face[1] == a ? 1 : 2;
            for (const int side : {1, 2}) {
                const std::uint32_t c = face[(corner + side) % 3], b = face[(corner + 3 - side) % 3];
                if (done[c - sheet_.first_vertex]) continue;
                const std::uint32_t other = b - sheet_.first_vertex;
                double d = distance[local] + glm::distance(at(a), at(c));
                if (done[other] && nearest[other].anchor == nearest[local].anchor)
                    d = std::min(d, over_face(at(a), at(b), at(c), distance[local], distance[other]));
                reach(c, d, nearest[local].anchor);
            }
        }
    }
}

// Straight lines: every vertex tries the anchors that its neighbours found, until none finds a nearer one. The distance
// to an anchor is exact; that no other is nearer holds but for rare ties of neighbourhoods.
void SheetGeodesics::spread(std::span<const std::uint32_t> anchors, std::vector<Tether>& nearest) const
{
    std::vector<std::uint32_t> wave, next;
    const auto reach = [&](std::uint32_t vertex, std::uint32_t anchor) {
        Tether& tether = nearest[vertex - sheet_.first_vertex];
        const float d = glm::distance(model_.rest_positions[vertex], model_.rest_positions[anchor]);
        if (d >= tether.length) return;
        tether = {anchor, d};
        next.push_back(vertex);
    };
    for (const std::uint32_t anchor : anchors) reach(anchor, anchor);
    while (!next.empty()) {
        wave.swap(next);
        next.clear();
        for (const std::uint32_t a : wave) {
            const std::uint32_t local = a - sheet_.first_vertex;
            for (std::uint32_t k = first_around_[local]; k < first_around_[local + 1]; ++k)
                for (int corner = 0; corner < 3; ++corner) reach(faces_[around_[k]][corner], nearest[local].anchor);
        }
    }
}

std::vector<Tether> SheetGeodesics::nearest(std::span<const std::uint32_t> anchors) const
{
    std::vector<Tether> nearest(sheet_.vertex_count);
    if (!straight_) {
        march(anchors, nearest);
    } else if (anchors.size() > kFewAnchors) {
        spread(anchors, nearest);
    } else {
        for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v)
            for (const std::uint32_t anchor : anchors) {
                const float d =
                    glm::distance(model_.rest_positions[sheet_.first_vertex + v], model_.rest_positions[anchor]);
                if (d < nearest[v].length) nearest[v] = {anchor, d};
            }
    }
    return nearest;
}

std::vector<Tether> SheetGeodesics::pin_tethers(std::span<const std::uint8_t> held) const
{
    const std::uint32_t count = sheet_.vertex_count;
    std::vector<Tether> tethers(std::size_t(kTethersPerVertex) * count);
    // The two nearest so far, in the order of the groups: a nearer one takes the place of the further of the two.
    for (const std::vector<std::uint32_t>& group : groups(held)) {
        const std::vector<Tether> found = nearest(group);
        for (std::uint32_t v = 0; v < count; ++v) {
            if (held[sheet_.first_vertex + v] || found[v].anchor == Tether::kNone) continue;
            Tether &first = tethers[v], &second = tethers[count + v];
            if (second.anchor == Tether::kNone) {
                (first.anchor == Tether::kNone ? first : second) = found[v];
            } else if (found[v].length < std::max(first.length, second.length)) {
                if (first.length > second.length) first = second;
                second = found[v];
            }
        }
    }
    return tethers;
}

bool is_flat_and_convex(const ClothModel& model, const Sheet& sheet)
{
    const auto at = [&](std::uint32_t v) { return glm::dvec3(model.rest_positions[v]); };
    const std::span<const glm::uvec3> faces = faces_of(model, sheet);
    glm::dvec3 sum(0);
    std::vector<Edge> sides;
    for (const glm::uvec3& face : faces) {
        sum += glm::cross(at(face[1]) - at(face[0]), at(face[2]) - at(face[0]));
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
            sides.emplace_back(low, high);
        }
    }
    std::sort(sides.begin(), sides.end());
    // The areas of faces add up to that of the whole only where all face one way.
    double area = 0;
    for (const glm::uvec3& face : faces)
        area += glm::length(glm::cross(at(face[1]) - at(face[0]), at(face[2]) - at(face[0])));
    constexpr double rounding = 1e-5;
    if (glm::length(sum) < (1 - rounding) * area) return false;
    const glm::dvec3 normal = glm::normalize(sum);

    // Rim edges in the direction of their faces; convex: each turns left, and all turns add up to one round.
    std::map<std::uint32_t, std::uint32_t> next;
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = face[k], b = face[(k + 1) % 3];
            const auto [low, high] = std::minmax(a, b);
            const auto [begin, end] = std::equal_range(sides.begin(), sides.end(), Edge(low, high));
            if (end - begin == 1 && !next.emplace(a, b).second) return false;
        }
    double turned = 0;
    for (const auto& [a, b] : next) {
        const auto after = next.find(b);
        if (after == next.end()) return false;
        const glm::dvec3 u = glm::normalize(at(b) - at(a)), v = glm::normalize(at(after->second) - at(b));
        const double turn = std::atan2(glm::dot(glm::cross(u, v), normal), glm::dot(u, v));
        if (turn < -1e-3) return false;
        turned += turn;
    }
    return std::abs(turned - 2 * M_PI) < 0.1;
}

}  // namespace nuno
