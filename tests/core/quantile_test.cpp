// Quantiles of lists.
#include "core/quantile.h"

#include <gtest/gtest.h>

namespace nuno {
namespace {

TEST(Quantile, takes_the_value_at_its_place_of_the_sorted_list)
{
    EXPECT_EQ(median({5, 1, 3}), 3);
    EXPECT_EQ(median({4, 2}), 4) << "of two the greater";
    EXPECT_EQ(quantile({9, 7, 8, 6}, 0), 6);
    EXPECT_EQ(quantile({9, 7, 8, 6}, 1), 9);
    EXPECT_EQ(quantile({9, 7, 8, 6}, 0.5), 8);
    EXPECT_EQ(median({}), 0) << "nothing";
}

}  // namespace
}  // namespace nuno
