// Presets, and where they set what.
#include "model/fabric.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "model/face_table.h"

namespace nuno {
namespace {

void set(SimParams& params, std::string_view name, std::string_view text)
{
    set_param_text(*find_param(sim_param_table(), name), &params, text, "test");
}

TEST(Fabric, setting_it_sets_all_its_constants_and_later_settings_override_it)
{
    SimParams params;
    set(params, "fabric", "denim");
    EXPECT_EQ(params.areal_density, fabric_constants(Fabric::denim).areal_density);
    EXPECT_EQ(params.weft_stiffness, fabric_constants(Fabric::denim).weft_stiffness);
    EXPECT_EQ(params.internal_model, InternalModel::fabric_springs);
    set(params, "areal_density", "0.5");
    EXPECT_EQ(params.areal_density, 0.5f);
    set(params, "internal_model", "continuum");
    set(params, "fabric", "silk");
    EXPECT_EQ(params.internal_model, InternalModel::continuum) << "a model that takes fabrics stays";
    const SimParams before = params;
    set(params, "fabric", "custom");
    EXPECT_EQ(params.areal_density, before.areal_density);
}

TEST(Fabric, every_preset_is_within_the_ranges_of_its_parameters_and_a_cloth)
{
    for (const Fabric fabric : {Fabric::cotton, Fabric::silk, Fabric::wool, Fabric::denim}) {
        SimParams params;
        params.fabric = fabric;
        apply_fabric(params);
        for (const ParamInfo& info : sim_param_table()) {
            EXPECT_GE(param_value(info, &params), info.min) << info.name;
            EXPECT_LE(param_value(info, &params), info.max) << info.name;
        }
        EXPECT_NO_THROW(membrane_constants(params));
        EXPECT_GE(4 * params.bending_bias, params.bending_warp + params.bending_weft) << "the twist would be negative";
    }
}

TEST(Fabric, more_cross_stiffness_than_the_threads_bear_is_refused)
{
    SimParams params;
    params.warp_stiffness = params.weft_stiffness = 100;
    params.cross_stiffness = 100;
    EXPECT_NO_THROW(membrane_constants(params));
    params.cross_stiffness = 101;
    EXPECT_THROW(membrane_constants(params), Error);
}

}  // namespace
}  // namespace nuno
