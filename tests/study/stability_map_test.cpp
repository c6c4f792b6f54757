// Maps of stability: measured limits are the predicted ones, and cells lie on their side of them.
#include "study/stability_map.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "model/oscillator.h"
#include "solver/method_table.h"
#include "support/verification.h"

namespace nuno {
namespace {

using Results = std::map<std::string, nlohmann::ordered_json>;

StabilityMaps maps_of(Method method, MapSize size, int side = 5)
{
    const Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.method = method;
    params.resolution = side;
    return StabilityMaps(scene, params, size);
}

class StabilityMapTest : public testing::TestWithParam<Method>
{};

TEST_P(StabilityMapTest, limits_are_as_predicted_and_cells_on_their_side)
{
    const StabilityMaps maps = maps_of(GetParam(), {4, 7});
    Results results;
    for (const SweepPoint& point : maps.points()) results[point.id] = point.measure();
    for (const MapSummary& summary : summarise(maps, results)) {
        const std::string_view map = map_info(summary.kind).id;
        expect_measured(fmt::format("largest deviation of a limit, {}, {} map", method_info(GetParam()).name, map),
                        summary.deviation, 0, kLimitTolerance);
        EXPECT_EQ(summary.wrong_side, 0) << map;
        EXPECT_EQ(summary.missing, 0) << map;
        EXPECT_EQ(summary.cells, 28) << map;
        EXPECT_EQ(summary.limits, is_explicit(GetParam()) ? 4 : 0) << map;
        if (is_explicit(GetParam())) {
            EXPECT_GT(summary.stable, 0) << map;
            EXPECT_GT(summary.blown_up, 0) << map;
        } else {
            EXPECT_EQ(summary.lost, 0) << map;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, StabilityMapTest,
                         testing::Values(Method::explicit_euler, Method::symplectic_euler, Method::verlet, Method::rk4,
                                         Method::xpbd, Method::vbd, Method::implicit_euler, Method::sdirk2),
                         [](const auto& test) { return std::string(method_info(test.param).name); });

// A fabric, whose motion beyond a limit is soon held by folds. Just beyond it, damped motion sinks for long before it grows.
TEST(StabilityMap, limits_of_a_damped_flag_are_as_predicted)
{
    const Scene scene = load_scene("flag");
    SimParams params = scene.params;
    params.method = Method::verlet;
    params.resolution = 9;
    const StabilityMaps maps(scene, params, {5, 2});
    for (const MapKind kind : {MapKind::damping, MapKind::wind})
        for (std::size_t column = 0; column < 5; ++column)
            expect_measured(fmt::format("deviation of the limit of verlet on a flag, {} map", map_info(kind).id),
                            maps.measure_limit(kind, Method::verlet, column)["deviation"].get<double>(), 0,
                            kLimitTolerance);
}

TEST(StabilityMap, a_cell_on_the_wrong_side_is_counted)
{
    const StabilityMaps maps = maps_of(Method::rk4, {2, 2}, 3);
    Results results;
    for (const SweepPoint& point : maps.points()) results[point.id] = point.measure();
    ASSERT_TRUE(summarise(maps, results).front().holds());
    results[cell_id(MapKind::stiffness, Method::rk4, 0, 0)]["verdict"] = "blown_up";
    EXPECT_EQ(summarise(maps, results).front().wrong_side, 1);
    EXPECT_FALSE(summarise(maps, results).front().holds());
    results = {};
    EXPECT_EQ(summarise(maps, results).front().missing, 4);
}

TEST(StabilityMap, a_limit_that_is_off_is_seen)
{
    const StabilityMaps maps = maps_of(Method::rk4, {2, 2}, 3);
    Results results;
    for (const SweepPoint& point : maps.points()) results[point.id] = point.measure();
    results[limit_id(MapKind::stiffness, Method::rk4, 1)]["deviation"] = -0.04;
    EXPECT_FALSE(summarise(maps, results).front().holds());
}

TEST(StabilityMap, methods_are_those_that_take_the_parameters)
{
    const Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.resolution = 4;
    EXPECT_EQ(StabilityMaps(scene, params).methods().size(), 8u);
    params.stiffness_damping = 1e-4f;
    EXPECT_THAT(StabilityMaps(scene, params).methods(), testing::Not(testing::Contains(Method::xpbd)));
    params.internal_model = InternalModel::continuum;
    EXPECT_THAT(StabilityMaps(scene, params).methods(),
                testing::ElementsAre(Method::explicit_euler, Method::symplectic_euler, Method::verlet, Method::rk4));
    params.method = Method::xpbd;
    EXPECT_THROW(StabilityMaps(scene, params), Error);
}

}  // namespace
}  // namespace nuno
