// How a spring's excess is shared out between its ends, for every spring of a sheet in strips.
#pragma once

#include <deque>

#include "model/spring_weights.h"
#include "solver/xpbd/strip_sweep.h"

namespace nuno {

// The springs of a kind: rest length [m] and stiffness [N/m], inside the sheet and along its rim.
struct StripStiffness
{
    float rest_length = 0, inside = 0, rim = 0;
};
// [N/m] of a plate's C, inside the sheet and along its rim.
struct StripPlateStiffness
{
    float inside = 0, rim = 0;
};

struct StripStiffnesses
{
    std::array<StripStiffness, kStripSpringCount> springs;
    std::array<StripPlateStiffness, kStripPlateCount> plates;
};

// Columns and rows from the first end of a spring to the second, and from the vector that owns it to each.
struct StripReach
{
    int first_column, second_column, second_row;
};
inline constexpr std::array<StripReach, kStripSpringCount> kStripReach{
    {{0, 1, 0}, {0, 2, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {0, 0, 2}}};

// True where the cells of a grid sheet are alike enough for strips: equal rest lengths of each kind of spring, to the
// rounding of the mesh.
bool suits_strips(const ClothModel& model, const Sheet& sheet);

// Of a sheet that suits strips, in the columns and rows of the layout.
StripStiffnesses strip_stiffnesses(const ClothModel& model, const Sheet& sheet, const StripLayout& layout,
                                   std::span<const SpringWeight> weights);

// Shares so that all projections of a spring alone in `sweeps` sweeps leave what backward Euler does,
// alpha / (w_a + w_b + alpha) of its excess, alpha = 1 / (k h^2): each leaves that to the power 1 / their number.
class StripShareTables
{
  public:
    // mobility: a lane, inverse mass over `inverse_mass` [1/kg], the sheet's own; 0 where held or padding. limit:
    // largest stretch of a spring; 0: none.
    void make(const StripLayout& layout, const float* mobility, float inverse_mass, const StripStiffnesses& stiffnesses,
              float h, int sweeps, float limit);

    std::array<StripSpringTerms, kStripSpringCount> terms;
    std::array<bool, kStripPlateCount> has_plate{};
    std::vector<const StripRowShares*> rows;  // one a row

  private:
    std::deque<StripLanes> tables_;
    std::deque<StripRowShares> shares_;  // one for all rows whose masses are alike
};

}  // namespace nuno
