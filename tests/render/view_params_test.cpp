// The table of view parameters: its rows are sound, and share no name with the simulation's.
#include "render/view_params.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "model/sim_params.h"

namespace nuno {
namespace {

TEST(ViewParams, every_default_lies_in_its_range_and_is_what_the_struct_starts_with)
{
    const ViewParams params;
    for (const ParamInfo& info : view_param_table()) {
        EXPECT_GE(info.default_value, info.min) << info.name;
        EXPECT_LE(info.default_value, info.max) << info.name;
        EXPECT_EQ(param_value(info, &params), static_cast<float>(info.default_value)) << info.name;
        EXPECT_FALSE(info.help.empty()) << info.name;
    }
}

TEST(ViewParams, no_name_is_also_one_of_the_simulation)
{
    for (const ParamInfo& info : view_param_table())
        EXPECT_EQ(find_param(sim_param_table(), info.name), nullptr) << info.name;
}

TEST(ViewParams, a_look_is_set_by_name_and_a_wrong_one_is_an_error)
{
    ViewParams params;
    const ParamInfo* look = find_param(view_param_table(), "look");
    ASSERT_NE(look, nullptr);
    set_param_text(*look, &params, "phong", "--set");
    EXPECT_EQ(params.look, Look::phong);
    EXPECT_THROW(set_param_text(*look, &params, "fong", "--set"), Error);
}

}  // namespace
}  // namespace nuno
