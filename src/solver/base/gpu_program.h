// Programs of the kernels in shaders/sim that read the parameters.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "gl/program.h"

namespace nuno {

// compute_program with the fields of the block of parameters, and all of these defines.
Program gpu_program(std::string_view file, std::initializer_list<std::vector<Define>> defines);

}  // namespace nuno
