// Measured fabrics (docs/fabrics.md).
#pragma once

#include "model/sim_params.h"

namespace nuno {

// What a fabric sets, all in SI units: see the parameters of the same names.
struct FabricConstants
{
    float areal_density;
    float warp_stiffness, weft_stiffness, cross_stiffness, shear_modulus;  // [N/m]
    float bending_warp, bending_weft, bending_bias;                        // [N m]
    float thickness;                                                       // [m]
    float friction, static_friction;
};

// Not of Fabric::custom.
FabricConstants fabric_constants(Fabric fabric);

// Sets all constants of params.fabric, and internal_model to fabric_springs where it was springs; custom changes
// nothing. The table of parameters calls it whenever `fabric` is set, so that later settings override it.
void apply_fabric(SimParams& params);

}  // namespace nuno
