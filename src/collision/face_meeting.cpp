// From the signs of volumes: where the corners of each face are from the plane of the other, and how edges pass each
// other. What lies in one plane is looked at along the three axes.
#include "collision/face_meeting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "collision/orientation.h"

namespace nuno {
namespace {

constexpr double kUnit = 0x1p-53;  // of rounding to nearest

using Signs = std::array<int, 3>;

int next(int corner) { return corner == 2 ? 0 : corner + 1; }

// Which corners of two faces are one vertex.
struct Common
{
    int count = 0;
    std::array<int, 3> own{}, others{};  // as numbered in each face
};

Common common_corners(const FaceCorners& f, const FaceCorners& g)
{
    Common common;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (f.vertices[std::size_t(i)] == g.vertices[std::size_t(j)] && common.count < 3) {
                common.own[std::size_t(common.count)] = i;
                common.others[std::size_t(common.count++)] = j;
            }
    return common;
}

bool one_strict_side(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[1] == s[2]; }
bool no_opposite_signs(const Signs& s)
{
    return std::min({s[0], s[1], s[2]}) >= 0 || std::max({s[0], s[1], s[2]}) <= 0;
}

Signs sides_of(const FaceCorners& corners, const FaceCorners& plane)
{
    Signs signs;
    for (std::size_t i = 0; i < 3; ++i) signs[i] = volume_sign(plane.x[0], plane.x[1], plane.x[2], corners.x[i]);
    return signs;
}

// Two closed segments in one plane, or on one line: they meet where they do along each axis. One of the three views
// keeps points of the plane apart; in the others what meets still does.
bool segments_meet_in_plane(const glm::vec3& p, const glm::vec3& q, const glm::vec3& a, const glm::vec3& b)
{
    for (int k = 0; k < 3; ++k)
        if (std::max(p[k], q[k]) < std::min(a[k], b[k]) || std::max(a[k], b[k]) < std::min(p[k], q[k])) return false;
    for (int axis = 0; axis < 3; ++axis) {
        if (area_sign(p, q, a, axis) * area_sign(p, q, b, axis) > 0) return false;
        if (area_sign(a, b, p, axis) * area_sign(a, b, q, axis) > 0) return false;
    }
    return true;
}

// Whether a point in the plane of a face is in it; false for a face without area.
bool is_inside_in_plane(const glm::vec3& p, const FaceCorners& f)
{
    bool seen = false;
    for (int axis = 0; axis < 3; ++axis) {
        const Signs turns{area_sign(f.x[0], f.x[1], p, axis), area_sign(f.x[1], f.x[2], p, axis),
                          area_sign(f.x[2], f.x[0], p, axis)};
        if (!no_opposite_signs(turns)) return false;
        seen = seen || turns != Signs{0, 0, 0};
    }
    return seen;
}

double size_of_product(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

// Whether a . b is above 0 for certain, where a is a rounded difference: three products, two sums.
bool certainly_ahead(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::dot(a, b) > 5 * kUnit * size_of_product(a, b);
}

// Whether the apexes of two faces are, seen along the edge a b, more than a right angle apart; not so if in doubt. Each
// normal is a product of differences: six roundings a component, and five more in the sum of their products.
bool certainly_open(const glm::vec3& a, const glm::vec3& b, const glm::vec3& apex_f, const glm::vec3& apex_g)
{
    const glm::dvec3 e = glm::dvec3(b) - glm::dvec3(a), f = glm::dvec3(apex_f) - glm::dvec3(a),
                     g = glm::dvec3(apex_g) - glm::dvec3(a);
    const glm::dvec3 normal_f = glm::cross(f, e), normal_g = glm::cross(g, e);
    const glm::dvec3 ae = glm::abs(e), af = glm::abs(f), ag = glm::abs(g);
    const glm::dvec3 size_f{af.y * ae.z + af.z * ae.y, af.z * ae.x + af.x * ae.z, af.x * ae.y + af.y * ae.x};
    const glm::dvec3 size_g{ag.y * ae.z + ag.z * ae.y, ag.z * ae.x + ag.x * ae.z, ag.x * ae.y + ag.y * ae.x};
    return glm::dot(normal_f, normal_g) < -20 * kUnit * glm::dot(size_f, size_g);
}

// Whether a plane through the common corner s has the two faces on its two sides; not so if in doubt.
bool certainly_apart(const FaceCorners& f, const FaceCorners& g, const Common& common)
{
    const std::size_t i = std::size_t(common.own[0]), j = std::size_t(common.others[0]);
    const glm::dvec3 s(f.x[i]);
    const glm::dvec3 a = glm::dvec3(f.x[(i + 1) % 3]) - s, b = glm::dvec3(f.x[(i + 2) % 3]) - s,
                     c = glm::dvec3(g.x[(j + 1) % 3]) - s, d = glm::dvec3(g.x[(j + 2) % 3]) - s;
    const auto unit = [](const glm::dvec3& v) { return v / (glm::length(v) + 1e-200); };
    const glm::dvec3 across = unit(unit(a) + unit(b)) - unit(unit(c) + unit(d));
    return certainly_ahead(a, across) && certainly_ahead(b, across) && certainly_ahead(c, -across) &&
           certainly_ahead(d, -across);
}

// Whether some plane is between the two faces; not so if in doubt. The direction across it is sought by steps of Frank
// and Wolfe's method towards the nearest point of the differences g - f, from that of the middles on.
bool certainly_apart(const FaceCorners& f, const FaceCorners& g)
{
    constexpr int steps = 4;
    float largest = 0;
    for (const FaceCorners* corners : {&f, &g})
        for (const glm::vec3& x : corners->x)
            largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    glm::dvec3 way = glm::dvec3(g.x[0]) + glm::dvec3(g.x[1]) + glm::dvec3(g.x[2]) - glm::dvec3(f.x[0]) -
                     glm::dvec3(f.x[1]) - glm::dvec3(f.x[2]);
    way /= 3.0;
    for (int step = 0; step < steps; ++step) {
        const auto height = [&](const glm::vec3& p) { return glm::dot(glm::dvec3(p), way); };
        const std::array<double, 3> of_f{height(f.x[0]), height(f.x[1]), height(f.x[2])},
            of_g{height(g.x[0]), height(g.x[1]), height(g.x[2])};
        const auto highest = std::max_element(of_f.begin(), of_f.end()) - of_f.begin();
        const auto lowest = std::min_element(of_g.begin(), of_g.end()) - of_g.begin();
        const glm::dvec3 nearest = glm::dvec3(g.x[std::size_t(lowest)]) - glm::dvec3(f.x[std::size_t(highest)]);
        // Of a height: three products, two sums; and their difference.
        const double size = double(largest) * (std::abs(way.x) + std::abs(way.y) + std::abs(way.z));
        if (of_g[std::size_t(lowest)] - of_f[std::size_t(highest)] > 10 * kUnit * size) return true;
        const glm::dvec3 back = way - nearest;
        const double length_sq = glm::dot(back, back), share = glm::dot(way, back);
        if (!(share > 0) || !(length_sq > 0)) return false;
        way -= std::min(share / length_sq, 1.0) * back;
    }
    return false;
}

// Corners a, b in common: folded onto each other in one plane.
bool is_folded(const FaceCorners& f, const FaceCorners& g, const Common& common)
{
    const glm::vec3 &a = f.x[std::size_t(common.own[0])], &b = f.x[std::size_t(common.own[1])];
    const glm::vec3 &apex_f = f.x[std::size_t(3 - common.own[0] - common.own[1])],
                    &apex_g = g.x[std::size_t(3 - common.others[0] - common.others[1])];
    if (certainly_open(a, b, apex_f, apex_g) || volume_sign(a, b, apex_f, apex_g) != 0) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (area_sign(a, b, apex_f, axis) * area_sign(a, b, apex_g, axis) > 0) return true;
    return false;
}

// Two faces without a common edge. Of those with a common vertex only the edges opposite to it are looked at.
class PairSigns
{
  public:
    PairSigns(const FaceCorners& f, const FaceCorners& g, const Common& common) : f_(f), g_(g)
    {
        if (common.count == 0) return;
        first_edge_ = next(common.own[0]);
        second_edge_ = next(common.others[0]);
    }

    FaceMeeting meeting()
    {
        sides_g_ = sides_of(g_, f_);
        if (is_beside(sides_g_, second_edge_)) return {};
        sides_f_ = sides_of(f_, g_);
        if (is_beside(sides_f_, first_edge_)) return {};
        // The edges of g are seen from those of f as those of f from g's: an even permutation of the four points.
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                if (!takes_first(i) && !takes_second(j)) continue;
                const int sign = volume_sign(first(i), first(next(i)), second(j), second(next(j)));
                from_first_[std::size_t(i)][std::size_t(j)] = sign;
                from_second_[std::size_t(j)][std::size_t(i)] = sign;
            }
        for (int i = 0; i < 3; ++i) {
            if (takes_first(i)) add_edge(sides_f_, from_first_[std::size_t(i)], {true, i});
            if (takes_second(i)) add_edge(sides_g_, from_second_[std::size_t(i)], {false, i});
        }
        if (meeting_.kind == Meeting::none && touch_in_plane()) meeting_.kind = Meeting::touching;
        return meeting_;
    }

  private:
    const glm::vec3& first(int i) const { return f_.x[std::size_t(i)]; }
    const glm::vec3& second(int j) const { return g_.x[std::size_t(j)]; }
    // Whether the corners are strictly on one side of the plane of the other face, which then has an area: the common
    // one is in it, but on no edge opposite to it.
    static bool is_beside(const Signs& sides, int edge)
    {
        if (edge < 0) return one_strict_side(sides);
        return sides[std::size_t(edge)] * sides[std::size_t(next(edge))] > 0;
    }
    bool takes_first(int edge) const { return first_edge_ < 0 || edge == first_edge_; }
    bool takes_second(int edge) const { return second_edge_ < 0 || edge == second_edge_; }

    // An edge that is not in the plane of the other face: it meets the plane in one point at most, and that is in the
    // face where the edge passes the sides of the face all on the same hand.
    void add_edge(const Signs& sides, const Signs& passing, Crossing crossing)
    {
        const int from = sides[std::size_t(crossing.edge)], to = sides[std::size_t(next(crossing.edge))];
        if (from * to > 0 || (from == 0 && to == 0) || !no_opposite_signs(passing)) return;
        if (from * to < 0 && one_strict_side(passing) && meeting_.crossing_count < 2) {
            meeting_.kind = Meeting::crossing;
            meeting_.crossings[std::size_t(meeting_.crossing_count++)] = crossing;
        } else if (meeting_.kind == Meeting::none) {
            meeting_.kind = Meeting::touching;
        }
    }

    bool touch_in_plane() const
    {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if ((takes_first(i) || takes_second(j)) && from_first_[std::size_t(i)][std::size_t(j)] == 0 &&
                    segments_meet_in_plane(first(i), first(next(i)), second(j), second(next(j))))
                    return true;
        for (int i = 0; i < 3; ++i) {
            const bool end_of_first = takes_first(i) || takes_first(next(next(i)));
            const bool end_of_second = takes_second(i) || takes_second(next(next(i)));
            if (end_of_first && sides_f_[std::size_t(i)] == 0 && is_inside_in_plane(first(i), g_)) return true;
            if (end_of_second && sides_g_[std::size_t(i)] == 0 && is_inside_in_plane(second(i), f_)) return true;
        }
        return false;
    }

    const FaceCorners &f_, &g_;
    int first_edge_ = -1, second_edge_ = -1;  // the only ones looked at; -1: all
    Signs sides_f_{}, sides_g_{};
    std::array<Signs, 3> from_first_{}, from_second_{};
    FaceMeeting meeting_;
};

}  // namespace

FaceMeeting meet(const FaceCorners& f, const FaceCorners& g)
{
    const Common common = common_corners(f, g);
    FaceMeeting touching;
    touching.kind = Meeting::touching;
    if (common.count == 3) return touching;
    if (common.count == 2) return is_folded(f, g, common) ? touching : FaceMeeting{};
    if (common.count == 1 ? certainly_apart(f, g, common) : certainly_apart(f, g)) return {};
    return PairSigns(f, g, common).meeting();
}

}  // namespace nuno
