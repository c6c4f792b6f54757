// The extremes: no number is lost unseen, and methods without a limit stay finite.
#include "study/stability_extremes.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "solver/method_table.h"

namespace nuno {
namespace {

const std::vector<Method> kMethods{Method::explicit_euler, Method::symplectic_euler,
                                   Method::verlet,         Method::rk4,
                                   Method::xpbd,           Method::vbd,
                                   Method::implicit_euler, Method::sdirk2};

TEST(Extremes, there_are_at_least_200_cases_each_with_a_name_of_its_own)
{
    std::set<std::string> ids;
    for (const ExtremeCase& c : extreme_cases(kMethods)) ids.insert(c.id);
    EXPECT_GE(ids.size(), 200u);
    EXPECT_EQ(ids.size(), extreme_cases(kMethods).size());
}

TEST(Extremes, nothing_is_expected_of_a_method_without_a_limit_but_numbers_or_a_refusal)
{
    for (const ExtremeCase& c : extreme_cases({Method::xpbd, Method::implicit_euler})) {
        EXPECT_NE(c.expects(Outcome::finite), c.expects(Outcome::refused)) << c.id;
        for (const Outcome bad : {Outcome::went_bad, Outcome::too_long, Outcome::unseen, Outcome::crashed})
            EXPECT_FALSE(c.expects(bad)) << c.id;
    }
}

struct SceneAndSide
{
    const char* scene;
    int side;  // vertices along the longer side
};

// `flag` is of a fabric, in moving air.
class ExtremeTest : public testing::TestWithParam<std::tuple<Method, SceneAndSide>>
{};

// All but the million of substeps.
TEST_P(ExtremeTest, every_case_ends_as_expected)
{
    const auto [method, of] = GetParam();
    const Scene scene = load_scene(of.scene);
    SimParams params = scene.params;
    params.resolution = of.side;
    for (const ExtremeCase& c : extreme_cases({method})) {
        if (c.extreme == Extreme::many_steps) continue;
        const nlohmann::ordered_json result = measure_extreme(scene, params, c);
        EXPECT_TRUE(result["as_expected"].get<bool>()) << c.id << ": " << result.dump();
        if (result["outcome"] != name_of(Outcome::finite)) {
            EXPECT_NE(result["said"], "") << c.id;
        }
    }
}

constexpr auto kCaseName = [](const auto& test) {
    const auto [method, of] = test.param;
    return std::string(method_info(method).name) + "_" + of.scene;
};

INSTANTIATE_TEST_SUITE_P(Methods, ExtremeTest,
                         testing::Combine(testing::ValuesIn(kMethods),
                                          testing::Values(SceneAndSide{"seed", 7}, SceneAndSide{"flag", 9})),
                         kCaseName);

}  // namespace
}  // namespace nuno
