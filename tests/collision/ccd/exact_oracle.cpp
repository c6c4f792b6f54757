// Contact by weights: of the vertex in the face, or of the places on both edges where they cross.
#include "collision/ccd/exact_oracle.h"

#include <array>

namespace nuno {
namespace {

using Poly = RationalPolynomial;
using PolyVector = std::array<Poly, 3>;

PolyVector operator-(const PolyVector& a, const PolyVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Poly dot(const PolyVector& a, const PolyVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
PolyVector cross(const PolyVector& a, const PolyVector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A condition of contact: the sign of p must be 0, or not negative, as `equal` says.
struct Condition
{
    Poly p;
    bool equal;
};
using Conditions = std::vector<Condition>;

// Contact at a time: where `divisor` is not 0, all of `regular`; else all of one of `degenerate`.
struct ContactRule
{
    Poly divisor;
    Conditions regular;
    std::vector<Conditions> degenerate;
};

// |q x e|^2 = 0 and 0 <= q.e <= e.e, and, for a segment without length, |q|^2 <= |e|^2.
Conditions point_on_segment(const PolyVector& point, const PolyVector& from, const PolyVector& to)
{
    const PolyVector q = point - from, e = to - from, area = cross(q, e);
    return {
        {dot(area, area), true}, {dot(q, e), false}, {dot(e, e) - dot(q, e), false}, {dot(e, e) - dot(q, q), false}};
}

// q = b e1 + c e2 with b, c, 1 - b - c >= 0; n = e1 x e2; b |n|^2 = (q x e2).n, c |n|^2 = (e1 x q).n.
ContactRule vertex_face_rule(const std::array<PolyVector, 4>& x)
{
    const PolyVector q = x[0] - x[1], e1 = x[2] - x[1], e2 = x[3] - x[1], n = cross(e1, e2);
    const Poly nn = dot(n, n), b = dot(cross(q, e2), n), c = dot(cross(e1, q), n);
    return {
        nn,
        {{dot(q, n), true}, {b, false}, {c, false}, {nn - b - c, false}},
        {point_on_segment(x[0], x[1], x[2]), point_on_segment(x[0], x[2], x[3]), point_on_segment(x[0], x[3], x[1])}};
}

// a0 + s ea = b0 + r eb with 0 <= s, r <= 1; n = ea x eb; d = b0 - a0; s |n|^2 = (d x eb).n, r |n|^2 = (d x ea).n.
ContactRule edge_edge_rule(const std::array<PolyVector, 4>& x)
{
    const PolyVector ea = x[1] - x[0], eb = x[3] - x[2], d = x[2] - x[0], n = cross(ea, eb);
    const Poly nn = dot(n, n), s = dot(cross(d, eb), n), r = dot(cross(d, ea), n);
    return {nn,
            {{dot(d, n), true}, {s, false}, {nn - s, false}, {r, false}, {nn - r, false}},
            {point_on_segment(x[0], x[2], x[3]), point_on_segment(x[1], x[2], x[3]), point_on_segment(x[2], x[0], x[1]),
             point_on_segment(x[3], x[0], x[1])}};
}

bool all_hold(const Conditions& conditions, RealRoot& time)
{
    for (const Condition& condition : conditions) {
        const int sign = sign_at_root(condition.p, time);
        if (condition.equal ? sign != 0 : sign < 0) return false;
    }
    return true;
}

bool is_contact(const ContactRule& rule, RealRoot& time)
{
    if (sign_at_root(rule.divisor, time) != 0) return all_hold(rule.regular, time);
    for (const Conditions& conditions : rule.degenerate)
        if (all_hold(conditions, time)) return true;
    return false;
}

// With motion out of a plane all contacts are at roots of the volume, the first condition of the rule: dot(q, n). Else
// they can begin at a root of anything.
std::vector<RealRoot> times_to_try(const ContactRule& rule, const Poly& volume)
{
    if (!volume.empty()) return roots_between_0_and_1(volume);
    std::vector<RealRoot> times{{{0, 1}, -1, 0}};
    const auto append = [&](const Poly& p) {
        if (p.empty()) return;
        const std::vector<RealRoot> roots = roots_between_0_and_1(p);
        times.insert(times.end(), roots.begin(), roots.end());
    };
    append(rule.divisor);
    for (const Condition& condition : rule.regular) append(condition.p);
    for (const Conditions& conditions : rule.degenerate)
        for (const Condition& condition : conditions) append(condition.p);
    return times;
}

// Coordinates over the least of their lowest bits, so that they are whole numbers.
std::array<PolyVector, 4> paths_of(const FourPoints& t0, const FourPoints& t1)
{
    std::array<PolyVector, 4> paths;
    mpz_class common = 1;
    for (const FourPoints* points : {&t0, &t1})
        for (const glm::dvec3& point : *points)
            for (int k = 0; k < 3; ++k) common = lcm(common, Rational(point[k]).get_den());
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) {
            const Rational from = Rational(t0[i][k]) * common, to = Rational(t1[i][k]) * common;
            paths[i][k] = Poly{} + Poly{from, to - from};  // the sum drops zeros at the end
        }
    return paths;
}

}  // namespace

ExactOracle::ExactOracle(PairKind kind, const FourPoints& t0, const FourPoints& t1)
{
    const std::array<PolyVector, 4> paths = paths_of(t0, t1);
    const ContactRule rule = kind == PairKind::vertex_face ? vertex_face_rule(paths) : edge_edge_rule(paths);
    for (RealRoot& time : times_to_try(rule, rule.regular.front().p))
        if (is_contact(rule, time)) contacts_.push_back(time);
}

bool ExactOracle::has_none_before(double time) const
{
    for (const RealRoot& contact : contacts_)
        if (!is_at_most(Rational(time), contact)) return false;
    return true;
}

bool ExactOracle::has_one_by(double time) const
{
    for (const RealRoot& contact : contacts_)
        if (Rational(time) >= contact.hi ||
            (Rational(time) > contact.lo && root_count(contact.p, contact.lo, Rational(time)) == 1))
            return true;
    return false;
}

}  // namespace nuno
