// Random queries of every family against the exact oracle: none missed, none false, none late.
#include <gtest/gtest.h>

#include "collision/ccd/oracle_check.h"
#include "collision/ccd/random_query.h"

namespace nuno {
namespace {

// As many as take about a second, or the sanitizers ten.
#if defined(NUNO_SANITIZED)
constexpr std::uint64_t kQueryCount = 60;
#else
constexpr std::uint64_t kQueryCount = 300;
#endif

class OracleFuzz : public testing::TestWithParam<QueryFamily>
{};

TEST_P(OracleFuzz, every_answer_is_that_of_rational_arithmetic)
{
    const QueryFamily family = GetParam();
    const std::uint64_t first_seed = 1, count = family == QueryFamily::extreme ? kQueryCount / 10 : kQueryCount;
    int impact_count = 0;
    for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
        const Query query = random_query(family, seed);
        const OracleCheck check = check_against_oracle(query);
        impact_count += check.is_impact;
        EXPECT_EQ(check.fault, "") << name_of(family) << " seed " << seed << ": " << text_of(query);
    }
    std::printf("%s: seeds %d to %d, %d impacts\n", name_of(family).c_str(), int(first_seed),
                int(first_seed + count - 1), impact_count);
    EXPECT_GT(impact_count, 0);
    EXPECT_LT(impact_count, static_cast<int>(count));
}

std::vector<QueryFamily> all_families()
{
    std::vector<QueryFamily> families;
    for (int i = 0; i < static_cast<int>(QueryFamily::count); ++i) families.push_back(static_cast<QueryFamily>(i));
    return families;
}

INSTANTIATE_TEST_SUITE_P(Families, OracleFuzz, testing::ValuesIn(all_families()),
                         [](const testing::TestParamInfo<QueryFamily>& family) { return name_of(family.param); });

}  // namespace
}  // namespace nuno
