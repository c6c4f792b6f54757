// Continuous test of a vertex against a face, in double.
#include "collision/pass_through.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "collision/discrete.h"
#include "core/task_share.h"
#include "model/formulas.h"

namespace nuno {
namespace {

// A point on an edge has one weight 0, but for rounding.
constexpr double kEdgeRounding = 1e-9;

// Six times the volume of the tetrahedron face + point: positive where the point is on the side of the face's normal.
double volume(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return glm::dot(point - a, glm::cross(b - a, c - a));
}

// volume(t) = c0 + c1 t + c2 t^2 + c3 t^3, for t = 0 .. 1.
struct Cubic
{
    double c0, c1, c2, c3;
    double at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
};

Cubic volume_over_time(const Path& point, const Path& a, const Path& b, const Path& c)
{
    const glm::dvec3 q = point.t0 - a.t0, u = b.t0 - a.t0, v = c.t0 - a.t0;
    const glm::dvec3 dq = point.t1 - a.t1 - q, du = b.t1 - a.t1 - u, dv = c.t1 - a.t1 - v;
    const glm::dvec3 n0 = glm::cross(u, v), n1 = glm::cross(u, dv) + glm::cross(du, v), n2 = glm::cross(du, dv);
    return {glm::dot(q, n0), glm::dot(q, n1) + glm::dot(dq, n0), glm::dot(q, n2) + glm::dot(dq, n1), glm::dot(dq, n2)};
}

// The times 0 = t0 <= .. <= 1 between which the cubic only rises or only falls: the roots of c1 + 2 c2 t + 3 c3 t^2, in
// the form that does not cancel. A root that is not finite fails both comparisons.
struct Knots
{
    std::array<double, 4> times{0, 1, 1, 1};
    int count = 1;
    void add(double t)
    {
        if (t > times[count - 1] && t < 1) times[count++] = t;
    }
};

Knots monotone_parts(const Cubic& f)
{
    Knots knots;
    const double a = 3 * f.c3, b = f.c2, discriminant = b * b - a * f.c1;
    if (discriminant > 0) {
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        const double first = q / a, second = f.c1 / q;
        knots.add(std::fmin(first, second));
        knots.add(std::fmax(first, second));
    }
    knots.times[knots.count] = 1;
    return knots;
}

// Where between lo and hi `f` changes sign, having the sign of `negative` at lo.
double sign_change(const Cubic& f, double lo, double hi, bool negative)
{
    for (int halving = 0; halving < 64; ++halving) {
        const double middle = 0.5 * (lo + hi);
        ((f.at(middle) < 0) == negative ? lo : hi) = middle;
    }
    return hi;
}

bool is_inside_at(double t, const Path& point, const Path& a, const Path& b, const Path& c)
{
    const auto at = [t](const Path& path) { return path.t0 + t * (path.t1 - path.t0); };
    const glm::dvec3 weights = formulas_f64::face_foot(at(point), at(a), at(b), at(c)).weights;
    return weights.x >= -kEdgeRounding && weights.y >= -kEdgeRounding && weights.z >= -kEdgeRounding;
}

}  // namespace

bool passes_through(const Path& point, const Path& a, const Path& b, const Path& c)
{
    const Cubic f = volume_over_time(point, a, b, c);
    const Knots knots = monotone_parts(f);
    bool negative = volume(point.t0, a.t0, b.t0, c.t0) < 0, passed = false;
    for (int part = 0; part < knots.count; ++part) {
        const double lo = knots.times[part], hi = knots.times[part + 1];
        const bool is_last = part + 1 == knots.count;
        const bool negative_at_hi = is_last ? volume(point.t1, a.t1, b.t1, c.t1) < 0 : f.at(hi) < 0;
        if (negative != negative_at_hi) {
            if (is_inside_at(sign_change(f, lo, hi, negative), point, a, b, c)) passed = !passed;
            negative = negative_at_hi;
        }
    }
    return passed;
}

// The boxes hold all that moves between the poses. They grow for roots that rounding puts just outside a face: within
// kEdgeRounding of its longest edge, which on a straight way is never longer than at both ends.
std::vector<VertexFace> find_pass_through(ElementQuery& query, std::span<const glm::vec4> positions_t0,
                                          std::span<const glm::vec4> positions_t1, ThreadPool& pool)
{
    const float longest =
        std::max(longest_edge(query.faces(), positions_t0), longest_edge(query.faces(), positions_t1));
    const int task_count = query.begin({positions_t0, positions_t1}, {1e-5f * longest, Culling::none}, pool);
    std::vector<std::vector<VertexFace>> found(static_cast<std::size_t>(task_count));
    share_tasks(pool, task_count, [&](int task, int) {
        query.run(task, [&](const ElementPair& pair) {
            const auto path = [&](int i) { return path_of(pair.vertices[i], positions_t0, positions_t1); };
            if (passes_through(path(0), path(1), path(2), path(3)))
                found[static_cast<std::size_t>(task)].push_back({pair.vertices.x, pair.face});
        });
    });

    std::vector<VertexFace> all;
    for (const std::vector<VertexFace>& part : found) all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace nuno
