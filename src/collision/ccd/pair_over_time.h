// A pair in exact integers: its differences, linear in time, and the polynomials whose signs tell of contact.
#pragma once

#include <array>

#include "collision/ccd/four_points.h"
#include "collision/ccd/polynomial.h"

namespace nuno {

// Every axis is scaled by a power of two of its own that makes its coordinates integers; contact does not depend on it.
// With the differences w_i(t) of difference_pairs.h: the origin is in their hull at t exactly where volume(t) = 0 and
// - some component k of normal(t) is not 0 and the area(i, k) are, for a face, each 0 or of its sign, for edges, not of
//   the same sign for i = 0, 1, nor for i = 2, 3; or
// - normal(t) = 0 (a face without area, parallel edges, edges without length) and the origin is on one of the sides,
//   all three areas of which are then 0 and whose product(i) is not positive.
class PairOverTime
{
  public:
    PairOverTime(PairKind kind, const FourPoints& t0, const FourPoints& t1);

    PairKind kind() const { return kind_; }
    const Polynomial& volume() const { return volume_; }  // w2 . (w0 x w1)

    // Of a side of the hull (difference_pairs.h) from w_i to w_j; made when first asked for.
    const Polynomial& area(int side, int axis);  // (w_first x w_second)[axis]
    const Polynomial& product(int side);         // w_first . w_second
    const Polynomial& normal(int axis);          // of the plane of the face, or of both edges

  private:
    struct Line  // at_t0 + t slope
    {
        Integer at_t0, slope;
    };
    static void add_product(Polynomial& sum, const Line& a, const Line& b, int sign);
    const Line& first_of(int side, int axis) const;
    const Line& second_of(int side, int axis) const;
    void set_differences(const FourPoints& t0, const FourPoints& t1, int axis);
    void set_volume();

    PairKind kind_;
    Line w_[4][3];
    Polynomial areas_[4][3], products_[4], normals_[3], volume_;
    bool has_area_[4][3] = {}, has_product_[4] = {}, has_normal_[3] = {};
};

}  // namespace nuno
