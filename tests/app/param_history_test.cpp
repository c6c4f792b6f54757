// Changes of parameters are taken back and made again.
#include "app/param_history.h"

#include <gtest/gtest.h>

#include <string>

#include "model/sim_params.h"

namespace nuno {
namespace {

class ParamHistoryTest : public testing::Test
{
  protected:
    void change(const char* name, double value, bool drags = false)
    {
        const SimParams before = params;
        set_param(*find_param(sim_param_table(), name), &params, value, "test");
        history.record(name, changes_between(sim_param_table(), &before, &params), drags);
    }
    void set(const std::vector<ParamHistory::Value>& values)
    {
        for (const ParamHistory::Value& v : values) set_param(*v.info, &params, v.value, "test");
    }
    SimParams params;
    ParamHistory history;
};

TEST_F(ParamHistoryTest, changes_are_undone_last_first_and_made_again_in_order)
{
    const SimParams start = params;
    change("damping", 1);
    change("thickness", 0.02);
    const SimParams end = params;
    EXPECT_EQ(history.undo_name(), "thickness");
    set(history.undo());
    EXPECT_EQ(params.thickness, start.thickness);
    EXPECT_EQ(params.damping, 1);
    set(history.undo());
    EXPECT_TRUE(same_params(params, start));
    EXPECT_FALSE(history.can_undo());
    EXPECT_TRUE(history.undo().empty());
    EXPECT_EQ(history.redo_name(), "damping");
    set(history.redo());
    set(history.redo());
    EXPECT_TRUE(same_params(params, end));
    EXPECT_FALSE(history.can_redo());
    EXPECT_TRUE(history.redo().empty());
}

TEST_F(ParamHistoryTest, a_drag_that_comes_back_is_no_entry)
{
    change("thickness", 0.02);
    const float start = params.damping;
    change("damping", 2, true);
    change("damping", double(start), true);
    EXPECT_EQ(history.undo_name(), "thickness");
    change("damping", 3, true);
    EXPECT_EQ(history.undo_name(), "damping");
}

TEST_F(ParamHistoryTest, a_drag_of_one_slider_is_one_entry)
{
    const SimParams start = params;
    for (int k = 1; k <= 10; ++k) change("damping", k, true);
    history.end_drag();
    for (int k = 1; k <= 10; ++k) change("damping", 10 + k, true);
    change("thickness", 0.02, true);
    set(history.undo());
    set(history.undo());
    EXPECT_EQ(params.damping, 10) << "the second drag";
    set(history.undo());
    EXPECT_TRUE(same_params(params, start));
    EXPECT_FALSE(history.can_undo());
    set(history.redo());
    EXPECT_EQ(params.damping, 10);
}

TEST_F(ParamHistoryTest, a_fabric_is_undone_with_all_that_it_set)
{
    change("fabric", static_cast<double>(Fabric::silk));
    change("thickness", 0.02);
    const SimParams start = params;
    change("fabric", static_cast<double>(Fabric::denim));
    ASSERT_NE(params.areal_density, start.areal_density);
    set(history.undo());
    EXPECT_TRUE(same_params(params, start));
}

TEST_F(ParamHistoryTest, a_new_change_forgets_what_was_undone_and_no_change_is_no_entry)
{
    change("damping", 1);
    change("damping", 2);
    set(history.undo());
    change("damping", 1);
    EXPECT_TRUE(history.can_redo()) << "it was 1 already";
    change("damping", 3);
    EXPECT_FALSE(history.can_redo());
    set(history.undo());
    EXPECT_EQ(params.damping, 1);
}

TEST_F(ParamHistoryTest, is_empty_after_another_scene_and_bounded)
{
    for (int k = 1; k <= 300; ++k) change("damping", k);
    std::size_t count = 0;
    for (; history.can_undo(); ++count) set(history.undo());
    EXPECT_EQ(count, ParamHistory::kMostEntries);
    EXPECT_EQ(params.damping, 100);
    history.clear();
    EXPECT_FALSE(history.can_undo());
    EXPECT_FALSE(history.can_redo());
}

}  // namespace
}  // namespace nuno
