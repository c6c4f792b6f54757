// Contact at the roots of the volume, or, where that is 0 all along, at the roots of all that contact depends on.
#include "collision/ccd/exact_impact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "collision/ccd/difference_pairs.h"
#include "collision/ccd/exact_root.h"
#include "collision/ccd/pair_over_time.h"

namespace nuno {
namespace {

bool is_inside(PairOverTime& pair, int axis, int normal_sign, ExactRoot& time)
{
    const auto sign = [&](int i) { return time.sign_of(pair.area(i, axis)); };
    if (pair.kind() == PairKind::edge_edge) return sign(0) * sign(1) <= 0 && sign(2) * sign(3) <= 0;
    for (int i = 0; i < 3; ++i)
        if (sign(i) == -normal_sign) return false;
    return true;
}

bool is_on_side(PairOverTime& pair, int i, ExactRoot& time)
{
    for (int axis = 0; axis < 3; ++axis)
        if (time.sign_of(pair.area(i, axis)) != 0) return false;
    return time.sign_of(pair.product(i)) <= 0;
}

// Whether the pair is in contact at a root of its volume.
bool is_contact(PairOverTime& pair, ExactRoot& time)
{
    for (int axis = 0; axis < 3; ++axis) {
        const int normal_sign = time.sign_of(pair.normal(axis));
        if (normal_sign != 0) return is_inside(pair, axis, normal_sign, time);
    }
    for (int i = 0; i < side_count(pair.kind()); ++i)
        if (is_on_side(pair, i, time)) return true;
    return false;
}

// Where contact may begin while the volume is 0 all along. Between two roots of all the signs that contact depends on,
// it is all or nothing, and the contact set is closed. A component of the normal that is not always 0 leaves the areas
// along its axis and its own roots; without one, contact is on the sides.
std::vector<ExactRoot> times_of_coplanar_motion(PairOverTime& pair)
{
    std::vector<ExactRoot> times;
    times.emplace_back(Fraction{});
    if (is_contact(pair, times.front())) return times;
    const auto append = [&](const Polynomial& p) {
        if (p.is_zero()) return;
        for (ExactRoot& root : roots_of(p)) times.push_back(std::move(root));
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (pair.normal(axis).is_zero()) continue;
        append(pair.normal(axis));
        for (int i = 0; i < side_count(pair.kind()); ++i) append(pair.area(i, axis));
        return times;
    }
    for (int i = 0; i < side_count(pair.kind()); ++i) {
        for (int axis = 0; axis < 3; ++axis) append(pair.area(i, axis));
        append(pair.product(i));
    }
    return times;
}

}  // namespace

std::optional<double> exact_impact(PairKind kind, const FourPoints& t0, const FourPoints& t1, double free_until)
{
    PairOverTime pair(kind, t0, t1);
    std::vector<ExactRoot> times = pair.volume().is_zero() ? times_of_coplanar_motion(pair) : roots_of(pair.volume());
    for (ExactRoot& time : times) time.narrow();
    std::vector<ExactRoot*> in_order;
    for (ExactRoot& time : times)
        if (!time.is_below(free_until)) in_order.push_back(&time);
    std::sort(in_order.begin(), in_order.end(),
              [](const ExactRoot* a, const ExactRoot* b) { return a->lower_bound() < b->lower_bound(); });

    // Brackets may overlap: the least lower bound of a contact is below all contacts, the first one's may not be it.
    std::optional<double> first;
    for (ExactRoot* time : in_order) {
        if (first && time->lower_bound() >= *first) break;
        if (is_contact(pair, *time)) first = time->lower_bound();
    }
    if (first) first = std::max(*first, free_until);
    return first;
}

}  // namespace nuno
