// Small text tools.
#include "core/text.h"

#include <gtest/gtest.h>

namespace nuno {
namespace {

TEST(Text, nearest_name_is_the_one_with_the_fewest_edits)
{
    const std::string_view names[] = {"substeps", "damping", "thickness"};
    EXPECT_EQ(nearest_name("subtseps", names), "substeps");
    EXPECT_EQ(nearest_name("thicknes", names), "thickness");
    EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(Text, a_number_must_be_the_whole_text)
{
    EXPECT_EQ(parse_number("2.5e-3"), 2.5e-3);
    EXPECT_EQ(parse_number("-7"), -7.0);
    for (const char* text : {"", "1x", "0x10 ", "1,5", "--1", " 1"})
        EXPECT_EQ(parse_number(text), std::nullopt) << text;
}

TEST(Text, choices_are_joined_as_a_sentence)
{
    const std::string_view three[] = {"a", "b", "c"};
    EXPECT_EQ(join_choices(three), "a, b or c");
    EXPECT_EQ(join_choices(std::span(three, 1)), "a");
}

}  // namespace
}  // namespace nuno
