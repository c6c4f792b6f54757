// The table of simulation parameters.
#include "model/sim_params.h"

#include <algorithm>

#include "model/fabric.h"

namespace nuno {
namespace {

constexpr std::string_view kFabrics[] = {"custom", "cotton", "silk", "wool", "denim"};
constexpr std::string_view kInternalModels[] = {"springs", "fabric_springs", "continuum"};
constexpr std::string_view kTethers[] = {"auto", "none", "pins", "contacts"};
constexpr std::string_view kWindModels[] = {"sines", "aero"};
constexpr std::string_view kMethods[] = {"auto", "explicit_euler", "symplectic_euler", "verlet",   "rk4", "xpbd",
                                         "vbd",  "implicit_euler", "sdirk2",           "reference"};
constexpr std::string_view kSweeps[] = {"auto", "rows", "coloured", "jacobi"};
constexpr std::string_view kBackends[] = {"cpu", "gpu"};
constexpr std::string_view kCollisionLevels[] = {"none",        "spheres",    "discrete",
                                                 "speculative", "continuous", "guaranteed"};
constexpr std::string_view kCullings[] = {"none", "seed", "sound"};
constexpr std::string_view kMassLumpings[] = {"area", "equal"};

}  // namespace

std::span<const std::string_view> choice_names(Fabric) { return kFabrics; }
std::span<const std::string_view> choice_names(InternalModel) { return kInternalModels; }
std::span<const std::string_view> choice_names(Tethers) { return kTethers; }
std::span<const std::string_view> choice_names(WindModel) { return kWindModels; }
std::span<const std::string_view> choice_names(Method) { return kMethods; }
std::span<const std::string_view> choice_names(Sweep) { return kSweeps; }
std::span<const std::string_view> choice_names(Backend) { return kBackends; }
std::span<const std::string_view> choice_names(CollisionLevel) { return kCollisionLevels; }
std::span<const std::string_view> choice_names(Culling) { return kCullings; }
std::span<const std::string_view> choice_names(MassLumping) { return kMassLumpings; }

ParamTable sim_param_table()
{
    static ParamInfo table[] = {
#define NUNO_PARAM_BLOCK SimParams
#include "core/param_rows.inc"
#include "model/sim_params.def"
#include "core/param_rows_end.inc"
    };
    static const bool linked = [] {
        const auto fabric = std::ranges::find(table, "fabric", &ParamInfo::name);
        fabric->on_set = [](void* block) { apply_fabric(*static_cast<SimParams*>(block)); };
        return true;
    }();
    static_cast<void>(linked);
    return table;
}

bool same_params(const SimParams& a, const SimParams& b)
{
    const ParamTable table = sim_param_table();
    return std::all_of(table.begin(), table.end(),
                       [&](const ParamInfo& info) { return param_value(info, &a) == param_value(info, &b); });
}

bool needs_restart(std::string_view name)
{
    const ParamInfo* info = find_param(sim_param_table(), name);
    return info && info->group == "start";
}

}  // namespace nuno
