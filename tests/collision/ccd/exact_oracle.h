// The times of contact in rational numbers, derived from the points by other formulas than src/collision/ccd has.
#pragma once

#include <vector>

#include "collision/ccd/four_points.h"
#include "collision/ccd/rational_polynomial.h"

namespace nuno {

class ExactOracle
{
  public:
    ExactOracle(PairKind kind, const FourPoints& t0, const FourPoints& t1);

    bool has_contact() const { return !contacts_.empty(); }
    bool has_none_before(double time) const;
    bool has_one_by(double time) const;

  private:
    // Times of contact, among them the first: contact starts at 0 or at a root of something that contact depends on.
    std::vector<RealRoot> contacts_;
};

}  // namespace nuno
