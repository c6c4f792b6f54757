// Every scene of the library runs to its end and holds its own check.
#include <gtest/gtest.h>

#include "gl/egl_context.h"
#include "sim/run_recorder.h"

namespace nuno {
namespace {

void expect_check_holds(const std::string& name, Backend backend)
{
    const Scene scene = load_scene(name);
    SimParams params = scene.params;
    params.backend = backend;
    Simulation simulation(scene, params);
    EXPECT_EQ(simulation.stability_warning(), std::nullopt);
    RunRecorder recorder;
    recorder.add({}, simulation.diagnostics());
    while (simulation.frame() + 1 < scene.check.frames) {
        const FrameStats stats = simulation.advance_frame();
        recorder.add(stats, simulation.diagnostics());
    }
    EXPECT_EQ(simulation.present_warning(), std::nullopt);
    const RunMetrics metrics = recorder.metrics();
    for (const std::string& failure : failed_bounds(scene.check, metrics)) ADD_FAILURE() << failure;
    for (const MetricInfo& metric : metric_table())
        testing::Test::RecordProperty(std::string(metric.name), std::to_string(metrics.*metric.value));
}

class SceneCheck : public testing::TestWithParam<std::string>
{};

TEST_P(SceneCheck, holds) { expect_check_holds(GetParam(), Backend::cpu); }

INSTANTIATE_TEST_SUITE_P(Library, SceneCheck, testing::ValuesIn(scene_names()),
                         [](const auto& test) { return test.param; });

// Other methods give the same bits on both backends; xpbd sweeps in another order on the GPU.
TEST(SceneCheckOnGpu, holds_where_xpbd_sweeps_in_colours)
{
    const auto context = make_headless_context();
    expect_check_holds("swing", Backend::gpu);
}

}  // namespace
}  // namespace nuno
