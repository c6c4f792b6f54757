// Programs of kernels that read the parameters.
#include "solver/base/gpu_program.h"

#include "model/sim_params.h"

namespace nuno {

Program gpu_program(std::string_view file, std::initializer_list<std::vector<Define>> defines)
{
    std::vector<Define> all;
    for (const std::vector<Define>& some : defines) all.insert(all.end(), some.begin(), some.end());
    return compute_program(file, all, {{"generated/sim_params", glsl_fields(sim_param_table())}});
}

}  // namespace nuno
