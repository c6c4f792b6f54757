// Round numbers for the ends of axes.
#pragma once

namespace nuno {

// The least of 1, 2 and 5 times a power of ten that is not below `value`, which is above 0.
double round_up_125(double value);

}  // namespace nuno
