// Bounds on what a run measured.
#include "scene/end_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace nuno {
namespace {

TEST(EndCheck, tells_each_bound_that_does_not_hold)
{
    const MetricInfo& contacts = metric_table()[0];
    EndCheck check{5, {{&contacts, 10, std::numeric_limits<double>::infinity(), "a.toml:9"}}};
    RunMetrics metrics;
    metrics.contacts = 10;
    EXPECT_TRUE(failed_bounds(check, metrics).empty());
    metrics.contacts = 9;
    ASSERT_EQ(failed_bounds(check, metrics).size(), 1u);
    EXPECT_THAT(failed_bounds(check, metrics)[0], testing::HasSubstr("a.toml:9: contacts is 9"));
    metrics.contacts = std::nan("");
    EXPECT_EQ(failed_bounds(check, metrics).size(), 1u) << "a NaN holds no bound";
}

}  // namespace
}  // namespace nuno
