// A measured number held to the one that theory expects.
#pragma once

#include <string_view>

namespace nuno {

// Fails where `measured` is further than `tolerance` from `expected`; prints a line `verify: what: measured, expected,
// tolerance`, which `./test -L verify -V | grep verify:` lists.
void expect_measured(std::string_view what, double measured, double expected, double tolerance);

}  // namespace nuno
