// Level `spheres` in whole frames: a pile of sheets comes to rest with its layers apart, with every method, on both
// backends.
#include <gtest/gtest.h>

#include "gl/egl_context.h"
#include "sim/run_recorder.h"
#include "sim/simulation.h"
#include "solver/method_table.h"
#include "support/program_run.h"

namespace nuno {
namespace {

// Three sheets, each turned against the one below, fall a few centimetres. They are as thick as their cells are wide.
Scene pile()
{
    const TemporaryDirectory directory;
    return load_scene(directory
                          .write("pile.toml", R"(title = "pile"
[params]
fabric = "cotton"
thickness = 0.03
friction = 0.4
static_friction = 0.5
collision = "spheres"
collision_passes = 4
count_pass_through = true
[[sheet]]
name = "first"
columns = 17
origin = [-0.25, 0.04, -0.25]
across = [0.50, 0.0, 0.00]
down = [0.00, 0.00, 0.50]
[[sheet]]
name = "second"
columns = 17
origin = [-0.20, 0.09, -0.29]
across = [0.49, 0.0, 0.1]
down = [-0.1, 0.00, 0.49]
[[sheet]]
name = "third"
columns = 17
origin = [0.0, 0.14, -0.35]
across = [0.36, 0.0, 0.36]
down = [-0.36, 0.00, 0.36]
[[plane]]
normal = [0.0, 1.0, 0.0]
offset = 0.0
)")
                          .string());
}

struct PileRun
{
    std::uint32_t contacts = 0, passed = 0;
    double kinetic_j = 0;
    std::string hash;
};

PileRun run_pile(SimParams params, int frames)
{
    Simulation simulation(pile(), params);
    PileRun run;
    for (int frame = 0; frame < frames; ++frame) {
        const FrameStats stats = simulation.advance_frame();
        run.contacts += stats.count.contacts;
        run.passed += stats.count.unresolved;
    }
    run.kinetic_j = simulation.diagnostics().kinetic_j;
    run.hash = hash_text(simulation.state());
    return run;
}

SimParams on_cpu(int threads = 1)
{
    SimParams params = pile().params;
    params.backend = Backend::cpu;
    params.threads = threads;
    return params;
}

TEST(SphereLayers, lie_on_one_another_at_rest)
{
    const PileRun run = run_pile(on_cpu(), 90);
    EXPECT_GT(run.contacts, 10000u);
    EXPECT_EQ(run.passed, 0u);
    EXPECT_LT(run.kinetic_j, 0.001);
    SimParams none = on_cpu();
    none.collision = CollisionLevel::none;
    EXPECT_GT(run_pile(none, 90).passed, 100u);
}

TEST(SphereLayers, hold_with_every_method)
{
    for (const MethodInfo& info : method_table()) {
        if (!info.on(Backend::cpu) || info.method == Method::explicit_euler || info.method == Method::reference)
            continue;
        SimParams params = on_cpu();
        params.method = info.method;
        const PileRun run = run_pile(params, 20);
        EXPECT_GT(run.contacts, 1000u) << info.name;
        EXPECT_EQ(run.passed, 0u) << info.name;
    }
}

TEST(SphereLayers, do_not_depend_on_the_number_of_threads)
{
    const std::string one = run_pile(on_cpu(1), 40).hash;
    for (const int threads : {2, 3}) EXPECT_EQ(run_pile(on_cpu(threads), 40).hash, one);
}

TEST(SphereLayers, can_be_chosen_while_the_cloth_moves)
{
    SimParams params = on_cpu();
    Simulation simulation(pile(), params);
    std::uint32_t contacts = 0;
    for (const CollisionLevel level : {CollisionLevel::none, CollisionLevel::spheres, CollisionLevel::guaranteed,
                                       CollisionLevel::spheres, CollisionLevel::discrete})
    {
        params.collision = level;
        simulation.set_params(params);
        for (int frame = 0; frame < 5; ++frame) {
            const FrameStats stats = simulation.advance_frame();
            if (level == CollisionLevel::spheres) contacts += stats.count.contacts;
        }
    }
    EXPECT_GT(contacts, 100u);
    EXPECT_FALSE(first_lost(simulation.state().positions));
}

TEST(SphereLayers, agree_on_both_backends)
{
    const auto context = make_headless_context();
    if (!gl_info().software) GTEST_SKIP() << "hardware rounds division and roots in its own way";
    for (const Method method : {Method::symplectic_euler, Method::xpbd}) {
        SimParams params = on_cpu();
        params.method = method;
        params.sweep = Sweep::coloured;
        const std::string cpu = run_pile(params, 20).hash;
        params.backend = Backend::gpu;
        EXPECT_EQ(run_pile(params, 20).hash, cpu) << int(method);
    }
}

}  // namespace
}  // namespace nuno
