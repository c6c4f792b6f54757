// What is left to nuno among the parameters.
#include "solver/method_choice.h"

#include <algorithm>
#include <cmath>

#include "model/face_table.h"
#include "model/stability.h"

namespace nuno {
namespace {

// Vertices along the longest side of the largest sheet, as if it were square.
double side_of(const ClothModel& model)
{
    double side = 1;
    for (const Sheet& sheet : model.sheets) {
        const double longest = sheet.is_grid() ? std::max(sheet.columns, sheet.rows) : std::sqrt(sheet.vertex_count);
        side = std::max(side, longest);
    }
    return side;
}

int substeps_for(const ClothModel& model, const SimParams& params)
{
    if (is_explicit(params.method)) {
        const int least = least_stable_substeps(model, params);
        return least > 0 ? least : 20;
    }
    if (params.method == Method::xpbd || params.method == Method::vbd)
        return std::max(5, static_cast<int>(std::ceil(5 * std::pow(side_of(model) / 64, 0.8))));
    return params.method == Method::reference ? 1 : 4;
}

}  // namespace

SimParams resolve_params(const ClothModel& model, const SimParams& asked)
{
    if (face_forces(asked).membrane) membrane_constants(asked);  // Error where they are none
    SimParams params = asked;
    if (asked.method == Method::automatic) {
        params.method = Method::symplectic_euler;
        const int least = least_stable_substeps(model, params);
        const int most = asked.substeps > 0 ? asked.substeps : kMostExplicitSubsteps;
        if (least == 0 || least > most) params.method = Method::xpbd;
    }
    if (asked.substeps == 0) params.substeps = substeps_for(model, params);
    const bool position_based = params.method == Method::xpbd || params.method == Method::vbd;
    if (asked.tethers == Tethers::automatic) params.tethers = position_based ? Tethers::pins : Tethers::none;
    return params;
}

}  // namespace nuno
