// The differences of a pair and their products as polynomials with integer coefficients.
#include "collision/ccd/pair_over_time.h"

#include <algorithm>

#include "collision/ccd/binary_parts.h"
#include "collision/ccd/difference_pairs.h"

namespace nuno {

PairOverTime::PairOverTime(PairKind kind, const FourPoints& t0, const FourPoints& t1) : kind_(kind)
{
    for (int axis = 0; axis < 3; ++axis) set_differences(t0, t1, axis);
    set_volume();
}

void PairOverTime::set_differences(const FourPoints& t0, const FourPoints& t1, int axis)
{
    BinaryParts parts[2][4];
    int least = 1 << 20;
    for (int i = 0; i < 4; ++i) {
        parts[0][i] = binary_parts(t0[i][axis]);
        parts[1][i] = binary_parts(t1[i][axis]);
        for (const BinaryParts& part : {parts[0][i], parts[1][i]})
            if (part.bits != 0) least = std::min(least, part.exponent);
    }
    Integer at[2][4];
    for (int end = 0; end < 2; ++end)
        for (int i = 0; i < 4; ++i) {
            const BinaryParts& part = parts[end][i];
            if (part.bits != 0) at[end][i] = Integer(part.bits) << static_cast<unsigned>(part.exponent - least);
        }

    for (int i = 0; i < side_count(kind_); ++i) {
        const int a = kMinuend[row_of(kind_)][i], b = kSubtrahend[row_of(kind_)][i];
        Line& w = w_[i][axis];
        w.at_t0 = at[0][a] - at[0][b];
        w.slope = at[1][a] - at[1][b];
        w.slope -= w.at_t0;
    }
}

void PairOverTime::add_product(Polynomial& sum, const Line& a, const Line& b, int sign)
{
    sum.c[0].add_product(a.at_t0, b.at_t0, sign);
    sum.c[1].add_product(a.at_t0, b.slope, sign);
    sum.c[1].add_product(a.slope, b.at_t0, sign);
    sum.c[2].add_product(a.slope, b.slope, sign);
}

void PairOverTime::set_volume()
{
    for (int axis = 0; axis < 3; ++axis) {
        const Polynomial& normal = area(0, axis);
        const Line& w = w_[2][axis];
        for (int i = 0; i < normal.count; ++i) {
            volume_.c[i].add_product(normal.c[i], w.at_t0);
            volume_.c[i + 1].add_product(normal.c[i], w.slope);
        }
    }
    volume_.count = 4;
    volume_.trim();
}

const PairOverTime::Line& PairOverTime::first_of(int side, int axis) const
{
    return w_[kSideFrom[row_of(kind_)][side]][axis];
}

const PairOverTime::Line& PairOverTime::second_of(int side, int axis) const
{
    return w_[kSideTo[row_of(kind_)][side]][axis];
}

const Polynomial& PairOverTime::area(int side, int axis)
{
    Polynomial& area = areas_[side][axis];
    if (!has_area_[side][axis]) {
        const int x = (axis + 1) % 3, y = (axis + 2) % 3;
        add_product(area, first_of(side, x), second_of(side, y), 1);
        add_product(area, first_of(side, y), second_of(side, x), -1);
        area.count = 3;
        area.trim();
        has_area_[side][axis] = true;
    }
    return area;
}

const Polynomial& PairOverTime::product(int side)
{
    Polynomial& product = products_[side];
    if (!has_product_[side]) {
        for (int axis = 0; axis < 3; ++axis) add_product(product, first_of(side, axis), second_of(side, axis), 1);
        product.count = 3;
        product.trim();
        has_product_[side] = true;
    }
    return product;
}

// Face: w0 x w1 + w1 x w2 + w2 x w0 = (w1 - w0) x (w2 - w0). Edges: w0 x w1 - w2 x w3 = (b1 - b0) x (a1 - a0).
const Polynomial& PairOverTime::normal(int axis)
{
    Polynomial& normal = normals_[axis];
    if (!has_normal_[axis]) {
        const bool face = kind_ == PairKind::vertex_face;
        for (int i = 0; i < 3; ++i) {
            normal.c[i] = face ? area(0, axis).c[i] + area(1, axis).c[i] : area(0, axis).c[i] - area(1, axis).c[i];
            if (face) normal.c[i] += area(2, axis).c[i];
        }
        normal.count = 3;
        normal.trim();
        has_normal_[axis] = true;
    }
    return normal;
}

}  // namespace nuno
