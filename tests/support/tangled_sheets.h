// A scene that starts tangled.
#pragma once

#include <string>

namespace nuno {

// A sheet, and another above it whose lower rim has gone through.
inline const std::string kTangledSheets = R"([params]
thickness = 0.004
[[sheet]]
name = "lower"
columns = 13
across = [1.0, 0.0, 0.0]
down = [0.0, 0.0, 1.0]
pins = ["top", "bottom"]
[[sheet]]
name = "upper"
columns = 13
origin = [0.1, 0.031, 0.1]
across = [0.77, 0.0, 0.0]
down = [0.0, -0.04, 0.8]
)";

}  // namespace nuno
