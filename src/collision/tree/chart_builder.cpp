// The plane, the faces over the convex hull, the rim below it, and parts.
#include "collision/tree/chart_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

// Normals further from that of the plane make heights over it too small; so do steeper rims.
constexpr double kLeastCosine = 0.4, kMostSlope = 0.7;
// A hull that takes in so many times the faces it is the hull of is not worth its proof.
constexpr std::size_t kMostSpread = 4;
// Of the extent at rest; cloth that is stretched further is not proven.
constexpr float kReach = 1.5f;

}  // namespace

ChartBuilder::ChartBuilder(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces)
    : rest_(rest_positions),
      mesh_faces_(faces),
      sides_(sides_of(faces, static_cast<std::uint32_t>(rest_positions.size()))),
      number_of_(rest_positions.size(), kNoVertex),
      is_taken_(faces.size())
{
}

void ChartBuilder::clear()
{
    for (const std::uint32_t v : vertices_) number_of_[v] = kNoVertex;
    for (const std::uint32_t f : faces_) is_taken_[f] = false;
    vertices_.clear();
    places_.clear();
    faces_.clear();
    open_rim_.clear();
    pockets_.clear();
    least_height_ = std::numeric_limits<double>::infinity();
    longest_ = stretch_ = 0;
}

bool ChartBuilder::choose_plane(std::span<const std::uint32_t> held)
{
    glm::dvec3 area(0), middle(0);
    for (const std::uint32_t f : held) {
        const glm::dvec3 a(rest_[mesh_faces_[f].x]), b(rest_[mesh_faces_[f].y]), c(rest_[mesh_faces_[f].z]);
        area += glm::cross(b - a, c - a);
        middle += (a + b + c) / (3.0 * double(held.size()));
    }
    if (!(glm::length(area) > 0)) return false;
    const glm::dvec3 normal = glm::normalize(area);
    const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, normal));
    plane_ = {middle, normal, u, glm::cross(normal, u)};
    return true;
}

std::uint32_t ChartBuilder::place_vertex(std::uint32_t vertex)
{
    if (number_of_[vertex] == kNoVertex) {
        number_of_[vertex] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(vertex);
        const glm::dvec3 from = glm::dvec3(rest_[vertex]) - plane_.origin;
        places_.emplace_back(glm::dot(from, plane_.u), glm::dot(from, plane_.v));
    }
    return number_of_[vertex];
}

// Adds a face; false where it does not face the plane's way.
bool ChartBuilder::take(std::uint32_t face)
{
    is_taken_[face] = true;
    faces_.push_back(face);
    const glm::uvec3 corners = mesh_faces_[face];
    const glm::dvec3 x(rest_[corners.x]), e = glm::dvec3(rest_[corners.y]) - x, g = glm::dvec3(rest_[corners.z]) - x;
    const glm::dvec2 a(places_[place_vertex(corners.x)]), b(places_[place_vertex(corners.y)]),
        c(places_[place_vertex(corners.z)]);
    const glm::dvec3 normal = glm::cross(e, g);
    if (!(glm::dot(normal, plane_.normal) > kLeastCosine * glm::length(normal))) return false;
    const glm::dvec2 p = b - a, q = c - a;
    const double area = cross(p, q);  // twice
    if (!(area > 0)) return false;
    const double longest = std::max({glm::length(p), glm::length(q), glm::length(c - b)});
    longest_ = std::max(longest_, longest);
    least_height_ = std::min(least_height_, area / longest);
    // The gradient [u v] of the rest shape over the plane; the square s of its norm is the larger solution of
    // s^2 - (u.u + v.v) s + (u.u v.v - (u.v)^2) = 0.
    const glm::dvec3 u = (e * q.y - g * p.y) / area, v = (g * p.x - e * q.x) / area;
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v);
    stretch_ = std::max(stretch_, std::sqrt(0.5 * (uu + vv + std::sqrt((uu - vv) * (uu - vv) + 4 * uv * uv))));
    return true;
}

// Takes all faces that lie over some of the hull, and notes where the rim is inside it.
bool ChartBuilder::spread()
{
    const std::size_t most = kMostSpread * faces_.size() + 64;
    for (std::size_t k = 0; k < faces_.size(); ++k)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t across = sides_.across[faces_[k]][static_cast<std::size_t>(corner)];
            if (across < kOddSide && is_taken_[across]) continue;
            const glm::uvec3 face = mesh_faces_[faces_[k]];
            const std::uint32_t from = number_of_[face[corner]], to = number_of_[face[(corner + 1) % 3]];
            if (!hull_.holds_some_of(places_[from], places_[to])) continue;
            if (across == kNoFace)
                open_rim_.push_back({from, to});
            else if (across == kOddSide || faces_.size() == most || !take(across))
                return false;
        }
    return true;
}

// The rim from one corner of the hull to the next; nothing where it goes elsewhere, or is no lower than the hull.
std::optional<ChartBuilder::Pocket> ChartBuilder::pocket_below(std::uint32_t from, std::uint32_t to) const
{
    Pocket pocket{glm::normalize(glm::dvec2(places_[to]) - glm::dvec2(places_[from])), 0, {from}};
    while (pocket.chain.back() != to) {
        const std::uint32_t at = pocket.chain.back(), vertex = sides_.rim_next[vertices_[at]];
        const std::uint32_t next = vertex == kNoVertex ? kNoVertex : number_of_[vertex];
        if (next == kNoVertex) return std::nullopt;
        const glm::dvec2 side = glm::dvec2(places_[next]) - glm::dvec2(places_[at]);
        const double forth = glm::dot(pocket.along, side), aside = std::abs(cross(pocket.along, side));
        if (!(forth > 0) || aside > kMostSlope * forth) return std::nullopt;
        pocket.slope = std::max(pocket.slope, aside / forth);
        pocket.chain.push_back(next);
    }
    return pocket.chain.size() > 2 ? std::optional(pocket) : std::nullopt;
}

// Whether every side of the rim inside the hull hangs below a side of the hull.
bool ChartBuilder::find_pockets()
{
    if (open_rim_.empty()) return true;
    std::vector<std::uint32_t> next_of(vertices_.size(), kNoVertex);
    const std::span<const std::uint32_t> corners = hull_.corners();
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (std::optional<Pocket> pocket = pocket_below(corners[k], corners[(k + 1) % corners.size()])) {
            for (std::size_t i = 0; i + 1 < pocket->chain.size(); ++i) next_of[pocket->chain[i]] = pocket->chain[i + 1];
            pockets_.push_back(std::move(*pocket));
        }
    return std::all_of(open_rim_.begin(), open_rim_.end(),
                       [&](const RimSide& side) { return next_of[side.from] == side.to; });
}

// How many faces lie over a place changes only at the rim; so inside the hull it is the same everywhere but in pockets,
// where it is one less. Here it is counted once, in the middle of a face.
bool ChartBuilder::is_covered_once() const
{
    const auto at = [&](std::uint32_t vertex) { return glm::dvec2(places_[number_of_[vertex]]); };
    const glm::uvec3 first = mesh_faces_[faces_.front()];
    const glm::dvec2 middle = (at(first.x) + at(first.y) + at(first.z)) / 3.0;
    const auto is_left = [&](glm::dvec2 a, glm::dvec2 b) { return cross(b - a, middle - a) >= 0; };
    const auto count = std::count_if(faces_.begin(), faces_.end(), [&](std::uint32_t face) {
        const glm::uvec3 v = mesh_faces_[face];
        return is_left(at(v.x), at(v.y)) && is_left(at(v.y), at(v.z)) && is_left(at(v.z), at(v.x));
    });
    const auto is_in_pocket = [&](const Pocket& pocket) {
        for (std::size_t k = 0; k + 1 < pocket.chain.size(); ++k) {
            const glm::dvec2 a(places_[pocket.chain[k]]), b(places_[pocket.chain[k + 1]]);
            const bool is_beside = glm::dot(pocket.along, middle - a) >= 0 && glm::dot(pocket.along, middle - b) <= 0;
            if (is_beside && cross(b - a, middle - a) <= 0) return true;
        }
        return false;
    };
    return count == 1 && std::none_of(pockets_.begin(), pockets_.end(), is_in_pocket);
}

std::optional<ChartWindow> ChartBuilder::window_of(std::span<const std::uint32_t> held)
{
    clear();
    if (held.empty() || !choose_plane(held)) return std::nullopt;
    for (const std::uint32_t face : held)
        if (!take(face)) return std::nullopt;
    hull_ = ConvexPolygon::around(places_);
    if (hull_.corners().size() < 3 || !spread() || !find_pockets() || !is_covered_once()) return std::nullopt;
    return finished();
}

ChartWindow ChartBuilder::finished() const
{
    ChartWindow window;
    double slope = 0, shortest = least_height_, extent = 0;
    for (const Pocket& pocket : pockets_) {
        slope = std::max(slope, pocket.slope);
        for (std::size_t k = 0; k + 1 < pocket.chain.size(); ++k)
            shortest = std::min(shortest, double(glm::distance(glm::dvec2(places_[pocket.chain[k]]),
                                                               glm::dvec2(places_[pocket.chain[k + 1]]))));
    }
    const double cosine = 1 / std::sqrt(1 + slope * slope);
    window.least_distance = shortest * cosine;
    window.stretch = stretch_ / cosine;

    std::uint32_t centre = 0;
    for (std::uint32_t v = 0; v < places_.size(); ++v) {
        if (glm::dot(places_[v], places_[v]) < glm::dot(places_[centre], places_[centre])) centre = v;
        extent = std::max(extent, glm::length(glm::dvec2(places_[v])));
    }
    window.centre = vertices_[centre];
    double reach = 0;
    for (const std::uint32_t v : vertices_)
        reach = std::max(reach, glm::distance(glm::dvec3(rest_[v]), glm::dvec3(rest_[window.centre])));
    window.reach = kReach * static_cast<float>(reach);
    // A vector of that reach along each axis is sqrt 3 times as long.
    const double size = 1.74 * double(window.reach) + extent;
    window.rim_rounding = static_cast<float>(0x1p-19 * size);
    window.rounding = 0x1p-17 * size * longest_ / (least_height_ * least_height_);
    choose_samples(window);
    cut_in_parts(window);
    const glm::uvec3 any = mesh_faces_[faces_.front()];
    for (std::size_t k = 0; k < 3; ++k) {
        window.failed.vertices[k] = any[static_cast<int>(k)];
        window.failed.places[k] = places_[number_of_[any[static_cast<int>(k)]]];
    }
    return window;
}

// The weights of least squares: for positions J p + c they give J.
void ChartBuilder::choose_samples(ChartWindow& window) const
{
    std::array<glm::dvec2, ChartWindow::kSamples> from{};
    glm::dvec2 mean(0);
    for (std::size_t k = 0; k < from.size(); ++k) {
        const std::size_t v = k * (vertices_.size() - 1) / (from.size() - 1);
        window.samples[k].vertex = vertices_[v];
        from[k] = glm::dvec2(places_[v]);
        mean += from[k] / double(from.size());
    }
    double xx = 0, xy = 0, yy = 0;
    for (glm::dvec2& p : from) {
        p -= mean;
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
    }
    // All on one line: no mean gradient, and no proof.
    const double area = xx * yy - xy * xy, scale = area > 1e-9 * xx * yy ? 1 / area : 0;
    for (std::size_t k = 0; k < from.size(); ++k)
        window.samples[k].weight =
            glm::vec2(scale * glm::dvec2(yy * from[k].x - xy * from[k].y, xx * from[k].y - xy * from[k].x));
}

// Fills parts with faces and rims.
class ChartCutter
{
  public:
    ChartCutter(std::vector<ChartPart>& parts, std::span<const std::uint32_t> vertices,
                std::span<const glm::vec2> places)
        : parts_(parts), vertices_(vertices), places_(places), number_of_(vertices.size(), kNoVertex)
    {
    }
    void add_face(const std::array<std::uint32_t, 3>& corners)
    {
        make_room();
        for (const std::uint32_t v : corners) part().corners.push_back(number(v));
    }
    void add_rim(std::uint32_t from, std::uint32_t to, glm::vec2 along, float slope)
    {
        make_room();
        const std::uint16_t first = number(from);
        part().rims.push_back({{first, number(to)}, along, slope});
    }
    void fill_groups()
    {
        for (ChartPart& part : parts_)
            while (part.corners.size() % (3 * ChartPart::kGroup) != 0)
                part.corners.push_back(part.corners[part.corners.size() - 3]);
    }

  private:
    ChartPart& part() { return parts_.back(); }
    void make_room()
    {
        const bool is_full = !parts_.empty() && (part().corners.size() >= 3 * ChartPart::kMostFaces ||
                                                 part().vertices.size() + 3 > ChartPart::kMostVertices);
        if (!parts_.empty() && !is_full) return;
        for (const std::uint32_t v : numbered_) number_of_[v] = kNoVertex;
        numbered_.clear();
        parts_.emplace_back();
    }
    std::uint16_t number(std::uint32_t v)
    {
        if (number_of_[v] == kNoVertex) {
            number_of_[v] = static_cast<std::uint32_t>(numbered_.size());
            numbered_.push_back(v);
            part().vertices.push_back(vertices_[v]);
            part().places.push_back(places_[v]);
        }
        return static_cast<std::uint16_t>(number_of_[v]);
    }

    std::vector<ChartPart>& parts_;
    std::span<const std::uint32_t> vertices_;
    std::span<const glm::vec2> places_;
    std::vector<std::uint32_t> number_of_, numbered_;  // vertices of the window in the part
};

void ChartBuilder::cut_in_parts(ChartWindow& window) const
{
    ChartCutter cutter(window.parts, vertices_, places_);
    for (const std::uint32_t face : faces_) {
        const glm::uvec3 v = mesh_faces_[face];
        cutter.add_face({number_of_[v.x], number_of_[v.y], number_of_[v.z]});
    }
    for (const Pocket& pocket : pockets_)
        for (std::size_t k = 0; k + 1 < pocket.chain.size(); ++k)
            cutter.add_rim(pocket.chain[k], pocket.chain[k + 1], glm::vec2(pocket.along),
                           static_cast<float>(pocket.slope * 1.00001 + 1e-6));
    cutter.fill_groups();
}

}  // namespace nuno
