// Every scene of the library runs to its end and holds its own check.
#include <gtest/gtest.h>

#include "sim/run_recorder.h"

namespace nuno {
namespace {

class SceneCheck : public testing::TestWithParam<std::string>
{};

TEST_P(SceneCheck, holds)
{
    const Scene scene = load_scene(GetParam());
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    Simulation simulation(scene, params);
    EXPECT_EQ(simulation.stability_warning(), std::nullopt);
    RunRecorder recorder;
    recorder.add({}, simulation.diagnostics());
    while (simulation.frame() + 1 < scene.check.frames) {
        const FrameStats stats = simulation.advance_frame();
        recorder.add(stats, simulation.diagnostics());
    }
    const RunMetrics metrics = recorder.metrics();
    for (const std::string& failure : failed_bounds(scene.check, metrics)) ADD_FAILURE() << failure;
    for (const MetricInfo& metric : metric_table())
        RecordProperty(std::string(metric.name), std::to_string(metrics.*metric.value));
}

INSTANTIATE_TEST_SUITE_P(Library, SceneCheck, testing::ValuesIn(scene_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace nuno
