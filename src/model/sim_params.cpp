// The table of simulation parameters.
#include "model/sim_params.h"

namespace nuno {
namespace {

constexpr std::string_view kMethods[] = {"explicit_euler", "symplectic_euler"};
constexpr std::string_view kBackends[] = {"cpu", "gpu"};
constexpr std::string_view kCollisionLevels[] = {"none", "discrete"};
constexpr std::string_view kCullings[] = {"none", "seed"};
constexpr std::string_view kMassLumpings[] = {"area", "equal"};

}  // namespace

std::span<const std::string_view> choice_names(Method) { return kMethods; }
std::span<const std::string_view> choice_names(Backend) { return kBackends; }
std::span<const std::string_view> choice_names(CollisionLevel) { return kCollisionLevels; }
std::span<const std::string_view> choice_names(Culling) { return kCullings; }
std::span<const std::string_view> choice_names(MassLumping) { return kMassLumpings; }

ParamTable sim_param_table()
{
    static const ParamInfo table[] = {
#define NUNO_PARAM_BLOCK SimParams
#include "core/param_rows.inc"
#include "model/sim_params.def"
#include "core/param_rows_end.inc"
    };
    return table;
}

bool needs_restart(std::string_view name)
{
    const ParamInfo* info = find_param(sim_param_table(), name);
    return info && info->group == "start";
}

}  // namespace nuno
