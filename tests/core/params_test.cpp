// Parameter tables: what is accepted, and what the refusal says.
#include "core/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "core/error.h"
#include "model/sim_params.h"

namespace nuno {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& name, const std::string& text)
{
    SimParams params;
    const SimParams before = params;
    try {
        set_param_text(*find_param(sim_param_table(), name), &params, text, "scene.toml:7");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(std::memcmp(&params, &before, sizeof params), 0) << "a refused value was stored";
        return error.what();
    }
    ADD_FAILURE() << name << " = " << text << " was accepted";
    return {};
}

TEST(Params, every_row_reads_back_its_default_and_both_ends_of_its_range)
{
    for (const ParamInfo& info : sim_param_table()) {
        SimParams params;
        EXPECT_EQ(param_value(info, &params), info.default_value) << info.name;
        for (const double end : {info.min, info.max}) {
            set_param_text(info, &params, param_text(info, end), "here");
            EXPECT_FLOAT_EQ(float(param_value(info, &params)), float(end)) << info.name;
        }
    }
}

TEST(Params, fields_lie_as_std140_lays_out_scalars)
{
    std::size_t offset = 0;
    for (const ParamInfo& info : sim_param_table()) {
        EXPECT_EQ(info.offset, offset) << info.name;
        offset += 4;
    }
    EXPECT_EQ(offset, sizeof(SimParams));
}

TEST(Params, names_are_unique_and_every_row_has_a_sentence)
{
    std::set<std::string_view> names;
    for (const ParamInfo& info : sim_param_table()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_EQ(info.help.back(), '.') << info.name;
        EXPECT_LE(info.min, info.default_value) << info.name;
        EXPECT_GE(info.max, info.default_value) << info.name;
    }
}

TEST(Params, a_value_out_of_range_names_place_range_and_unit)
{
    const std::string message = refusal("damping", "-1");
    EXPECT_THAT(message, HasSubstr("scene.toml:7"));
    EXPECT_THAT(message, HasSubstr("damping"));
    EXPECT_THAT(message, HasSubstr("from 0 to 1000 kg/(m2 s)"));
}

TEST(Params, numbers_that_are_not_finite_or_not_whole_or_no_number_are_refused)
{
    for (const char* text : {"nan", "inf", "-inf", "1e40", "abc", "", "1 2"}) refusal("damping", text);
    for (const char* text : {"1.5", "-1", "1e9", "true"}) refusal("substeps", text);
    for (const char* text : {"2", "yes"}) refusal("count_pass_through", text);
}

TEST(Params, an_unknown_choice_names_the_nearest)
{
    EXPECT_THAT(refusal("method", "symplectic_eular"), HasSubstr("nearest is symplectic_euler"));
}

TEST(Params, an_unknown_name_names_the_nearest_and_its_range)
{
    const ParamTable table = sim_param_table();
    try {
        throw_unknown_param("wind_strenght", std::span(&table, 1), "--set");
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("--set"));
        EXPECT_THAT(error.what(), HasSubstr("wind_strength"));
        EXPECT_THAT(error.what(), HasSubstr("0 to 1000"));
    }
}

}  // namespace
}  // namespace nuno
