// The panel drawn without a window: every row of every table, at every end of its range.
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/panel_params.h"
#include "model/sim_params.h"
#include "render/view_params.h"

namespace nuno {
namespace {

class ParamPanelTest : public testing::Test
{
  protected:
    ParamPanelTest()
    {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {600, 3000};
        io.Fonts->Build();
    }
    ~ParamPanelTest() override { ImGui::DestroyContext(); }

    // One frame with all groups of `table` open; the change of the last row that was changed.
    std::optional<ParamEdit> draw(ParamTable table, const void* block, const void* scene_block, ParamRows::Kind kind)
    {
        ImGui::GetIO().DeltaTime = 1.0f / 60;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({600, 3000});
        ImGui::Begin("rows");
        std::optional<ParamEdit> edit;
        const ParamRows rows{table, block, scene_block, [&](const ParamInfo&) { return kind; }};
        for (const std::string_view group : param_groups(table))
            if (const auto changed = panel_.draw_group(rows, group, true)) edit = changed;
        ImGui::End();
        ImGui::Render();
        return edit;
    }

    ViewerLog log_{false};
    ParamPanel panel_{log_};
};

template <class Block>
std::vector<Block> blocks_at_the_ends(ParamTable table)
{
    std::vector<Block> blocks(3);
    for (const ParamInfo& info : table) {
        set_param(info, &blocks[1], info.min, "test");
        set_param(info, &blocks[2], info.max, "test");
    }
    return blocks;
}

TEST_F(ParamPanelTest, every_row_can_be_drawn_at_the_ends_of_its_range_and_changes_nothing)
{
    const SimParams sim;
    for (const SimParams& block : blocks_at_the_ends<SimParams>(sim_param_table()))
        EXPECT_FALSE(draw(sim_param_table(), &block, &sim, ParamRows::Kind::live));
    const ViewParams view;
    for (const ViewParams& block : blocks_at_the_ends<ViewParams>(view_param_table()))
        EXPECT_FALSE(draw(view_param_table(), &block, &view, ParamRows::Kind::live));
}

// Holds the left button on every place of the panel in turn; the changes that come are within their ranges.
TEST_F(ParamPanelTest, no_place_of_the_panel_gives_a_value_out_of_range)
{
    const SimParams scene;
    SimParams block;
    int change_count = 0;
    ImGuiIO& io = ImGui::GetIO();
    for (int y = 5; y < 1500; y += 9) {
        for (const int x : {330, 420, 560}) {
            io.MousePos = {static_cast<float>(x), static_cast<float>(y)};
            for (const bool down : {true, false}) {
                io.MouseDown[0] = down;
                const auto edit = draw(sim_param_table(), &block, &scene, ParamRows::Kind::live);
                if (!edit) continue;
                ++change_count;
                EXPECT_NO_THROW(set_param(*edit->info, &block, edit->value, "test")) << edit->info->name;
            }
        }
    }
    EXPECT_GT(change_count, 20);
}

TEST_F(ParamPanelTest, a_row_that_acts_on_release_acts_once_and_then)
{
    const SimParams scene;
    SimParams block;
    ImGuiIO& io = ImGui::GetIO();
    draw(sim_param_table(), &block, &scene, ParamRows::Kind::on_release);
    // Looks for the first row that reacts: the button is held for two frames, and moved, before it is let go.
    for (int y = 5; y < 300; y += 6) {
        io.MousePos = {330, static_cast<float>(y)};
        io.MouseDown[0] = true;
        EXPECT_FALSE(draw(sim_param_table(), &block, &scene, ParamRows::Kind::on_release));
        io.MousePos = {420, static_cast<float>(y)};
        EXPECT_FALSE(draw(sim_param_table(), &block, &scene, ParamRows::Kind::on_release));
        io.MouseDown[0] = false;
        if (const auto edit = draw(sim_param_table(), &block, &scene, ParamRows::Kind::on_release)) {
            EXPECT_NE(edit->value, param_value(*edit->info, &block));
            EXPECT_FALSE(draw(sim_param_table(), &block, &scene, ParamRows::Kind::on_release));
            return;
        }
    }
    FAIL() << "no row reacted";
}

}  // namespace
}  // namespace nuno
