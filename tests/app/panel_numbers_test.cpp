// The numbers behind the panel: which sliders are logarithmic, what they give, what the graph of stage times shows.
#include <gtest/gtest.h>

#include "app/panel_params.h"
#include "app/stage_graph.h"
#include "app/viewer_pace.h"
#include "model/sim_params.h"
#include "render/view_params.h"

namespace nuno {
namespace {

const ParamInfo& info_of(std::string_view name)
{
    const ParamInfo* info = find_param(sim_param_table(), name);
    return info ? *info : *find_param(view_param_table(), name);
}

TEST(ParamSliders, are_logarithmic_where_the_range_dwarfs_the_values)
{
    for (const char* name : {"wind_strength", "structural_stiffness", "substeps", "camera_distance", "gravity_y"})
        EXPECT_TRUE(is_logarithmic(info_of(name))) << name;
    for (const char* name : {"friction", "camera_azimuth", "light_elevation", "threads"})
        EXPECT_FALSE(is_logarithmic(info_of(name))) << name;
}

TEST(ParamSliders, give_three_significant_digits_within_the_range)
{
    const ParamInfo& stiffness = info_of("structural_stiffness");
    EXPECT_EQ(rounded_by_slider(stiffness, 41.2345), double(41.2f));
    EXPECT_EQ(rounded_by_slider(stiffness, 0.00123456), double(0.00123f));
    EXPECT_EQ(rounded_by_slider(stiffness, 123456), 123000);
    EXPECT_EQ(rounded_by_slider(stiffness, 0), 0);
    EXPECT_EQ(rounded_by_slider(stiffness, stiffness.max), stiffness.max);
    EXPECT_EQ(rounded_by_slider(info_of("gravity_y"), -9.8149), double(-9.81f));
}

TEST(ParamSliders, stand_in_every_group_of_their_table_once)
{
    for (const ParamTable table : {sim_param_table(), view_param_table()}) {
        const std::vector<std::string_view> groups = param_groups(table);
        std::size_t rows = 0;
        for (const std::string_view group : groups)
            for (const ParamInfo& info : table) rows += info.group == group;
        EXPECT_EQ(rows, table.size());
    }
    EXPECT_EQ(param_groups(sim_param_table()).at(0), "wind");
}

StageColumn column(float solve, float render)
{
    StageTimes times;
    times.solve = solve;
    return stage_column(times, render, 0.5);
}

TEST(StageHistory, keeps_the_last_frames_in_order)
{
    StageHistory history;
    for (int i = 0; i < 300; ++i) history.add(column(static_cast<float>(i), 1), 1);
    ASSERT_EQ(history.size(), StageHistory::kFrames);
    EXPECT_EQ(history.column(0)[0], 60);
    EXPECT_EQ(history.column(StageHistory::kFrames - 1)[0], 299);
    EXPECT_EQ(history.highest_ms(), 299 + 1 + 0.5f);
}

TEST(StageHistory, counts_the_simulation_by_simulated_frame_and_the_window_by_shown_frame)
{
    StageHistory history;
    history.add(column(8, 3), 4);
    EXPECT_FLOAT_EQ(history.smoothed_ms(0), 2);
    EXPECT_FLOAT_EQ(history.smoothed_ms(6), 3);
    EXPECT_FLOAT_EQ(history.smoothed_ms(7), 0.5f);
    EXPECT_FLOAT_EQ(history.smoothed_sum_ms(), 8 + 3 + 0.5f);
    for (int i = 0; i < 200; ++i) history.add(column(0, 5), 0);
    EXPECT_FLOAT_EQ(history.smoothed_ms(0), 2) << "nothing was simulated";
    EXPECT_NEAR(history.smoothed_ms(6), 5, 0.01);
    EXPECT_EQ(history.size(), 1u) << "the graph waits";
}

TEST(StageHistory, fits_under_its_axis)
{
    EXPECT_EQ(graph_axis_ms(0), 2);
    EXPECT_EQ(graph_axis_ms(16.7f), 24);
    EXPECT_EQ(graph_axis_ms(5000.5f), 6000);
}

TEST(ViewerPace, tells_rates_over_half_a_second)
{
    ViewerPace pace;
    for (int i = 0; i < 8; ++i) pace.add(0.0625, 0.03125);
    EXPECT_NEAR(pace.frames_per_second(), 16, 1e-9);
    EXPECT_NEAR(pace.real_time_factor(), 0.5, 1e-9);
}

}  // namespace
}  // namespace nuno
