// Presets name parameters that there are, and the seed's cloth holds with each.
#include "app/presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/param_history.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

TEST(Presets, name_real_parameters_with_valid_values_and_a_sentence)
{
    std::set<std::pair<PresetKind, std::string_view>> names;
    for (const Preset& preset : preset_table()) {
        EXPECT_TRUE(names.emplace(preset.kind, preset.name).second) << preset.name;
        EXPECT_TRUE(preset.help.ends_with('.')) << preset.name;
        ASSERT_FALSE(preset.settings.empty()) << preset.name;
        SimParams params;
        for (const Preset::Setting& setting : preset.settings) {
            const ParamInfo* info = find_param(sim_param_table(), setting.name);
            ASSERT_NE(info, nullptr) << setting.name;
            EXPECT_NO_THROW(set_param_text(*info, &params, setting.value, "test")) << setting.name;
            EXPECT_EQ(param_text(*info, param_value(*info, &params)), setting.value) << setting.name;
        }
        EXPECT_TRUE(same_params(params, with_preset(preset, {})));
        EXPECT_TRUE(same_params(params, with_preset(preset, params))) << "setting it twice changes nothing";
    }
    EXPECT_EQ(names.size(), 11u);
}

TEST(Presets, of_one_kind_replace_one_another)
{
    for (const Preset& preset : preset_table())
        for (const Preset& other : preset_table()) {
            if (preset.kind != other.kind || preset.kind == PresetKind::wind) continue;
            EXPECT_TRUE(same_params(with_preset(preset, with_preset(other, {})), with_preset(preset, {})))
                << preset.name << " after " << other.name;
        }
}

TEST(Presets, are_one_entry_of_the_history)
{
    const Preset& gale = preset_table()[6];
    ASSERT_EQ(gale.name, "gale");
    const SimParams before, after = with_preset(gale, before);
    ParamHistory history;
    history.record(std::string(gale.name), changes_between(sim_param_table(), &before, &after));
    SimParams params = after;
    for (const ParamHistory::Value& v : history.undo()) set_param(*v.info, &params, v.value, "test");
    EXPECT_TRUE(same_params(params, before));
    EXPECT_FALSE(history.can_undo());
}

class PresetRun : public testing::TestWithParam<Preset>
{};

TEST_P(PresetRun, the_seed_runs_stable)
{
    const Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    Simulation simulation(scene, with_preset(GetParam(), params));
    double speed = 0;
    for (int frame = 0; frame < 120; ++frame) {
        ASSERT_NO_THROW(simulation.advance_frame());
        speed = std::max(speed, simulation.diagnostics().max_speed);
    }
    EXPECT_GT(speed, 0.1) << "it moves";
    EXPECT_LT(speed, 60) << "[m/s], three times the strongest wind";
}

INSTANTIATE_TEST_SUITE_P(All, PresetRun, testing::ValuesIn(preset_table().begin(), preset_table().end()),
                         [](const auto& preset) { return std::string(preset.param.name); });

}  // namespace
}  // namespace nuno
