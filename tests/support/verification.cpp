// A measured number held to the one that theory expects.
#include "support/verification.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace nuno {

void expect_measured(std::string_view what, double measured, double expected, double tolerance)
{
    fmt::print("verify: {}: measured {:.6g}, expected {:.6g} +- {:.2g}\n", what, measured, expected, tolerance);
    std::fflush(stdout);
    EXPECT_LE(std::abs(measured - expected), tolerance)
        << what << ": measured " << measured << ", expected " << expected;
}

}  // namespace nuno
