// Rounding in decades.
#include "core/round_up.h"

#include <cmath>
#include <initializer_list>

namespace nuno {

double round_up_125(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= value) return digit * power;
    return 10 * power;
}

}  // namespace nuno
