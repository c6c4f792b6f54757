// What is left to nuno among the parameters: method, substeps and tethers.
#pragma once

#include "model/body.h"
#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

// `asked` with every "auto" replaced: method becomes symplectic_euler where that is stable with the substeps asked for
// (or, where these are 0, with at most kMostExplicitSubsteps) and no tether or strain limit is asked for, else xpbd;
// with internal_model = continuum or stiffness_damping, which xpbd has not, always symplectic_euler. Substeps 0 becomes
// what the method needs: of an explicit one what is stable with springs stretched however far, and with a membrane
// stretched by a quarter more than the share `stretch` that its faces are now. Tethers become pins with xpbd and vbd
// where the pins cannot move apart, else none. What was asked for by name stays, stable or not. Error where the
// constants of a membrane are none.
SimParams resolve_params(const ClothModel& model, const Bodies& bodies, const SimParams& asked, double stretch = 0);

// Substeps a frame up to which an explicit method is taken rather than xpbd.
inline constexpr int kMostExplicitSubsteps = 64;

}  // namespace nuno
