// Closest points of eight pairs at a time.
#include "collision/pair_sieve.h"

#include <algorithm>
#include <limits>

#include "model/wide.h"

namespace nuno {
namespace {

// Of the largest relative motion of a pair, what is allowed for a normal that turns, and for a way that is no straight
// one.
constexpr float kTurning = 0.3f, kBending = 0.1f;
// Of the reach, how far closest points may lie outside of an element, besides that motion.
constexpr float kOutside = 0.1f;
// The least cosine between separations at start and end that are on the same side.
constexpr float kSameSide = 0.7f;
// Elements nearer than this [m] have no normal.
constexpr float kTouching = 1e-9f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using Real = WideFloat;
using Vec = WideVec3;

NUNO_WIDE_INLINE Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
NUNO_WIDE_INLINE Vec cross(Vec a, Vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
NUNO_WIDE_INLINE Real clamped(Real a) { return min_real(max_real(a, Real(0.0f)), Real(1.0f)); }
NUNO_WIDE_INLINE Real positive(Real a) { return max_real(a, Real(1e-30f)); }

// The vectors of eight pairs, corner by corner.
struct Corners
{
    float lanes[4][3][kLanes];

    NUNO_WIDE_INLINE void gather(int lane, const glm::uvec4& vertices, std::span<const glm::vec4> vectors)
    {
        for (int corner = 0; corner < 4; ++corner) {
            const glm::vec4& vector = vectors[vertices[corner]];
            for (int axis = 0; axis < 3; ++axis) lanes[corner][axis][lane] = vector[axis];
        }
    }
    NUNO_WIDE_INLINE void set(int corner, Vec vector)
    {
        vector.x.store(lanes[corner][0]);
        vector.y.store(lanes[corner][1]);
        vector.z.store(lanes[corner][2]);
    }
    NUNO_WIDE_INLINE Vec operator[](int corner) const
    {
        return {Real(lanes[corner][0]), Real(lanes[corner][1]), Real(lanes[corner][2])};
    }
};

// From side B to side A between the closest points, and a vector across both elements, of any length.
struct Separation
{
    Vec between, across;
};

// To the point p from the nearest point of the segment from a to b, given p - a and b - a.
NUNO_WIDE_INLINE Vec from_segment(Vec ap, Vec ab) { return ap - clamped(dot(ap, ab) / positive(dot(ab, ab))) * ab; }

// From the foot of the point on the plane where it lies in the face, else from the nearest point of the edges.
NUNO_WIDE_INLINE Separation vertex_from_face(const Corners& x)
{
    const Vec ap = x[0] - x[1], bp = x[0] - x[2], cp = x[0] - x[3];
    const Vec ab = x[2] - x[1], bc = x[3] - x[2], ca = x[1] - x[3], across = cross(ab, bc);
    const Vec r = from_segment(ap, ab), s = from_segment(bp, bc), t = from_segment(cp, ca);
    Vec nearest = select_positive(dot(r, r) - dot(s, s), s, r);
    nearest = select_positive(dot(nearest, nearest) - dot(t, t), t, nearest);
    // On the inner side of all edges.
    const Real inside =
        min_real(min_real(dot(across, cross(ab, ap)), dot(across, cross(bc, bp))), dot(across, cross(ca, cp)));
    return {select_positive(inside, (dot(ap, across) / positive(dot(across, across))) * across, nearest), across};
}

// As closest_edge_edge of shaders/shared/closest_points.h.
NUNO_WIDE_INLINE Separation edge_from_edge(const Corners& x)
{
    const Vec da = x[1] - x[0], db = x[3] - x[2], r = x[0] - x[2];
    const Real aa = dot(da, da), bb = dot(db, db), ab = dot(da, db), ar = dot(da, r), br = dot(db, r);
    const Real det = aa * bb - ab * ab;
    const Real crossing = clamped((ab * br - ar * bb) / positive(det));
    Real s = select_positive(det - Real(1e-6f) * aa * bb, crossing, Real(0.0f));
    const Real t = clamped((ab * s + br) / positive(bb));
    s = clamped((ab * t - ar) / positive(aa));
    return {r + s * da - t * db, cross(da, db)};
}

template <PairKind kKind>
NUNO_WIDE_INLINE Separation separation_of(const Corners& x)
{
    if constexpr (kKind == PairKind::vertex_face)
        return vertex_from_face(x);
    else
        return edge_from_edge(x);
}

// Of all vertices a of side A and b of side B: the least distance along the normal on the way, the largest relative way
// and the largest distance, both squared.
struct Planes
{
    Real gap, approach, size;
};

template <PairKind kKind>
NUNO_WIDE_INLINE Planes planes_across(Vec normal, const Corners& x, const Corners& ways)
{
    constexpr int first_of_b = kKind == PairKind::vertex_face ? 1 : 2;
    Planes planes{Real(kInfinity), Real(0.0f), Real(0.0f)};
    for (int a = 0; a < first_of_b; ++a)
        for (int b = first_of_b; b < 4; ++b) {
            const Vec way = ways[a] - ways[b], r = x[a] - x[b];
            planes.approach = max_real(planes.approach, dot(way, way));
            planes.size = max_real(planes.size, dot(r, r));
            planes.gap = min_real(planes.gap, dot(normal, r) + min_real(dot(normal, way), Real(0.0f)));
        }
    return planes;
}

struct Foreseen
{
    Vec normal;
    Real gap, approach;
};

template <PairKind kKind>
NUNO_WIDE_INLINE Foreseen foresee_lanes(const Corners& x, const Corners& ways, float reach)
{
    Corners ends;
    for (int corner = 0; corner < 4; ++corner) ends.set(corner, x[corner] + ways[corner]);
    const Separation now = separation_of<kKind>(x);
    const Vec later = separation_of<kKind>(ends).between;
    const Real square = dot(now.between, now.between), distance = sqrt_real(square);
    const Real end_distance = sqrt_real(dot(later, later));
    const Vec normal = now.between / positive(distance);
    const Planes planes = planes_across<kKind>(normal, x, ways);
    const Real approach = sqrt_real(planes.approach), none = Real(kInfinity);
    Real gap = planes.gap - Real(kTurning) * approach;

    // What lies in the plane of the face, or of the two edges' directions; nothing where they have none.
    const Real size = dot(now.across, now.across), along = dot(now.between, now.across);
    const Real outside = select_positive(size - Real(1e-30f), square - along * along / positive(size), Real(0.0f));
    const Real allowed = approach + Real(kOutside * reach);
    gap = select_positive(outside - allowed * allowed, none, gap);
    gap = select_positive(distance - approach - Real(reach), none, gap);
    const Real passed_by = min_real(min_real(distance, end_distance) - Real(reach) - Real(kBending) * approach,
                                    dot(normal, later) - Real(kSameSide) * end_distance);
    gap = select_positive(passed_by, none, gap);
    return {normal, select_positive(Real(kTouching) - distance, none, gap), approach};
}

// Differences of corners and ways are rounded by 2^-24 of themselves; a product with a normal of nearly unit length and
// their sum add a few of the same: 16 in all, taken as 32. The ways themselves are rounded differences, by 2^-24 of
// each on each axis: less than 4 in all, taken as 8.
template <PairKind kKind>
NUNO_WIDE_INLINE Real bound_lanes(const Corners& x, const Corners& ways)
{
    const Vec between = separation_of<kKind>(x).between;
    const Vec normal = between / positive(sqrt_real(dot(between, between)));
    const Planes planes = planes_across<kKind>(normal, x, ways);
    Real longest = Real(0.0f);
    for (int corner = 0; corner < 4; ++corner) longest = max_real(longest, dot(ways[corner], ways[corner]));
    return planes.gap - Real(0x1p-19f) * (sqrt_real(planes.size) + sqrt_real(planes.approach)) -
           Real(0x1p-21f) * sqrt_real(longest);
}

// Calls body(x, ways, first, count) for eight pairs after eight; where fewer are left the last is repeated.
template <class Body>
NUNO_WIDE_INLINE void by_lanes(std::span<const ElementPair> pairs, const StraightStep& step, const Body& body)
{
    Corners x, ways;
    for (std::size_t first = 0; first < pairs.size(); first += kLanes) {
        const std::size_t count = std::min<std::size_t>(kLanes, pairs.size() - first);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const glm::uvec4& vertices = pairs[first + std::min(lane, count - 1)].vertices;
            x.gather(static_cast<int>(lane), vertices, step.start);
            ways.gather(static_cast<int>(lane), vertices, step.ways);
        }
        body(x, ways, first, count);
    }
}

template <PairKind kKind>
NUNO_WIDE_INLINE void foresee_all(std::span<const ElementPair> pairs, const StraightStep& step, float reach,
                                  std::span<ForeseenPair> answers)
{
    by_lanes(pairs, step,
             [&](const Corners& x, const Corners& ways, std::size_t first, std::size_t count) NUNO_WIDE_LAMBDA {
                 const Foreseen foreseen = foresee_lanes<kKind>(x, ways, reach);
                 float normal[3][kLanes], gap[kLanes], approach[kLanes];
                 foreseen.normal.x.store(normal[0]);
                 foreseen.normal.y.store(normal[1]);
                 foreseen.normal.z.store(normal[2]);
                 foreseen.gap.store(gap);
                 foreseen.approach.store(approach);
                 for (std::size_t i = 0; i < count; ++i)
                     answers[first + i] = {{normal[0][i], normal[1][i], normal[2][i]}, gap[i], approach[i]};
             });
}

template <PairKind kKind>
NUNO_WIDE_INLINE void bound_all(std::span<const ElementPair> pairs, const StraightStep& step, std::span<float> bounds)
{
    by_lanes(pairs, step,
             [&](const Corners& x, const Corners& ways, std::size_t first, std::size_t count) NUNO_WIDE_LAMBDA {
                 float bound[kLanes];
                 bound_lanes<kKind>(x, ways).store(bound);
                 for (std::size_t i = 0; i < count; ++i) bounds[first + i] = bound[i];
             });
}

NUNO_SIMD_CLONES void foresee_vertex_faces(std::span<const ElementPair> pairs, const StraightStep& step, float reach,
                                           std::span<ForeseenPair> answers)
{
    foresee_all<PairKind::vertex_face>(pairs, step, reach, answers);
}

NUNO_SIMD_CLONES void foresee_edge_edges(std::span<const ElementPair> pairs, const StraightStep& step, float reach,
                                         std::span<ForeseenPair> answers)
{
    foresee_all<PairKind::edge_edge>(pairs, step, reach, answers);
}

NUNO_SIMD_CLONES void bound_vertex_faces(std::span<const ElementPair> pairs, const StraightStep& step,
                                         std::span<float> bounds)
{
    bound_all<PairKind::vertex_face>(pairs, step, bounds);
}

NUNO_SIMD_CLONES void bound_edge_edges(std::span<const ElementPair> pairs, const StraightStep& step,
                                       std::span<float> bounds)
{
    bound_all<PairKind::edge_edge>(pairs, step, bounds);
}

}  // namespace

void foresee_pairs(PairKind kind, std::span<const ElementPair> pairs, const StraightStep& step, float reach,
                   std::span<ForeseenPair> answers)
{
    if (kind == PairKind::vertex_face)
        foresee_vertex_faces(pairs, step, reach, answers);
    else
        foresee_edge_edges(pairs, step, reach, answers);
}

void bound_distances(PairKind kind, std::span<const ElementPair> pairs, const StraightStep& step,
                     std::span<float> bounds)
{
    if (kind == PairKind::vertex_face)
        bound_vertex_faces(pairs, step, bounds);
    else
        bound_edge_edges(pairs, step, bounds);
}

}  // namespace nuno
