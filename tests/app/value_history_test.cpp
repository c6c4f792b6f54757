// Values over the last simulated seconds.
#include "app/value_history.h"

#include <gtest/gtest.h>

#include <limits>

namespace nuno {
namespace {

TEST(ValueHistory, keeps_the_last_seconds)
{
    ValueHistory history;
    for (int i = 0; i <= 300; ++i) history.add(0.1 * i, i);
    EXPECT_NEAR(history.samples().front().time_s, 30 - ValueHistory::kSeconds, 0.11);
    EXPECT_EQ(history.samples().back().value, 300);
    EXPECT_NEAR(history.lowest(), 200, 1);
    EXPECT_EQ(history.highest(), 300);
}

TEST(ValueHistory, a_run_that_was_put_back_writes_over_what_came_after)
{
    ValueHistory history;
    for (const double time_s : {1.0, 2.0, 3.0, 4.0}) history.add(time_s, time_s);
    history.add(2.5, 9);
    ASSERT_EQ(history.samples().size(), 3u);
    EXPECT_EQ(history.samples().back().time_s, 2.5);
    EXPECT_EQ(history.highest(), 9);
    history.add(0, 5);
    EXPECT_EQ(history.samples().size(), 1u);
}

TEST(ValueHistory, what_is_no_number_is_passed_over)
{
    ValueHistory history;
    history.add(1, std::numeric_limits<double>::quiet_NaN());
    history.add(2, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(history.samples().empty());
    EXPECT_EQ(history.highest(), 0);
}

TEST(ValueHistory, axes_are_round)
{
    EXPECT_DOUBLE_EQ(round_axis(0.7), 1);
    EXPECT_DOUBLE_EQ(round_axis(1.2), 2);
    EXPECT_DOUBLE_EQ(round_axis(43), 50);
    EXPECT_DOUBLE_EQ(round_axis(0.0051), 0.01);
    EXPECT_DOUBLE_EQ(round_axis(0), 1);
    EXPECT_DOUBLE_EQ(round_axis(-3), 1);
}

}  // namespace
}  // namespace nuno
