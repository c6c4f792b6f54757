// Measured fabrics.
#include "model/fabric.h"

#include <cassert>

namespace nuno {

FabricConstants fabric_constants(Fabric fabric)
{
    assert(fabric != Fabric::custom);
    switch (fabric) {
    case Fabric::silk:
        return {.areal_density = 0.060f,
                .warp_stiffness = 300,
                .weft_stiffness = 250,
                .cross_stiffness = 40,
                .shear_modulus = 20,
                .bending_warp = 0.6e-6f,
                .bending_weft = 0.5e-6f,
                .bending_bias = 0.4e-6f,
                .thickness = 0.2e-3f,
                .friction = 0.2f,
                .static_friction = 0.25f};
    case Fabric::wool:
        return {.areal_density = 0.2348f,
                .warp_stiffness = 105,
                .weft_stiffness = 105,
                .cross_stiffness = 29,
                .shear_modulus = 38,
                .bending_warp = 12e-6f,
                .bending_weft = 9e-6f,
                .bending_bias = 9e-6f,
                .thickness = 0.568e-3f,
                .friction = 0.4f,
                .static_friction = 0.5f};
    case Fabric::denim:
        return {.areal_density = 0.324f,
                .warp_stiffness = 205,
                .weft_stiffness = 1014,
                .cross_stiffness = 0,
                .shear_modulus = 53,
                .bending_warp = 16.0e-6f,
                .bending_weft = 24.2e-6f,
                .bending_bias = 18.3e-6f,
                .thickness = 0.7e-3f,
                .friction = 0.4f,
                .static_friction = 0.5f};
    default:  // cotton
        return {.areal_density = 0.1503f,
                .warp_stiffness = 277,
                .weft_stiffness = 277,
                .cross_stiffness = 67,
                .shear_modulus = 105,
                .bending_warp = 13e-6f,
                .bending_weft = 13e-6f,
                .bending_bias = 12e-6f,
                .thickness = 0.318e-3f,
                .friction = 0.3f,
                .static_friction = 0.4f};
    }
}

void apply_fabric(SimParams& p)
{
    if (p.fabric == Fabric::custom) return;
    const FabricConstants c = fabric_constants(p.fabric);
    p.areal_density = c.areal_density;
    p.warp_stiffness = c.warp_stiffness;
    p.weft_stiffness = c.weft_stiffness;
    p.cross_stiffness = c.cross_stiffness;
    p.shear_modulus = c.shear_modulus;
    p.bending_warp = c.bending_warp;
    p.bending_weft = c.bending_weft;
    p.bending_bias = c.bending_bias;
    p.thickness = c.thickness;
    p.friction = c.friction;
    p.static_friction = c.static_friction;
    if (p.internal_model == InternalModel::springs) p.internal_model = InternalModel::fabric_springs;
}

}  // namespace nuno
