// Whole frames with contact: the same bits on CPU and software GPU, for 1 and 2 threads, run after run.
#include <gtest/gtest.h>

#include "gl/egl_context.h"
#include "sim/run_recorder.h"
#include "sim/simulation.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

struct Outcome
{
    std::string hash;
    double contacts = 0;
};

Outcome run(const std::string& name, Backend backend, int threads, int frames)
{
    const Scene scene = load_scene(name);
    SimParams params = scene.params;
    params.backend = backend;
    params.threads = threads;
    Simulation simulation(scene, params);
    Outcome outcome;
    for (int frame = 0; frame < frames; ++frame) outcome.contacts += double(simulation.advance_frame().count.contacts);
    outcome.hash = hash_text(simulation.state());
    return outcome;
}

TEST(SimulationParity, the_seed_agrees_after_300_frames_with_contact)
{
    const auto context = make_headless_context();
    if (!gl_info().software) GTEST_SKIP() << "hardware rounds division and roots in its own way";
    const Outcome one = run("seed", Backend::cpu, 1, 300);
    EXPECT_GT(one.contacts, 100);
    EXPECT_EQ(one.hash, run("seed", Backend::cpu, 1, 300).hash) << "a second run";
    EXPECT_EQ(one.hash, run("seed", Backend::cpu, 2, 300).hash) << "two threads";
    EXPECT_EQ(one.hash, run("seed", Backend::gpu, 1, 300).hash) << "compute shaders";
    EXPECT_EQ(one.hash, run("seed", Backend::gpu, 2, 300).hash) << "compute shaders and two threads";
}

TEST(SimulationParity, sphere_floor_and_larger_sheets_agree)
{
    const auto context = make_headless_context();
    if (!gl_info().software) GTEST_SKIP() << "hardware rounds division and roots in its own way";
    for (const char* name : {"drape", "curtain"}) {
        const Outcome one = run(name, Backend::cpu, 1, 40);
        EXPECT_EQ(one.hash, run(name, Backend::cpu, 2, 40).hash) << name;
        EXPECT_EQ(one.hash, run(name, Backend::gpu, 2, 40).hash) << name;
    }
}

// Layers thrown at each other by wind, kept apart in every substep. What holds of symplectic Euler holds of the explicit
// one, which would need thousands of substeps here.
TEST(SimulationParity, contacts_between_layers_agree_with_every_method)
{
    const auto context = make_headless_context();
    if (!gl_info().software) GTEST_SKIP() << "hardware rounds division and roots in its own way";
    const Scene scene = load_scene("gale");
    for (const MethodInfo& info : method_table()) {
        if (!info.on(Backend::gpu) || info.method == Method::explicit_euler) continue;
        const auto hash_on = [&](Backend backend) {
            SimParams params = scene.params;
            params.backend = backend;
            params.method = info.method;
            params.sweep = Sweep::coloured;
            params.collision = CollisionLevel::guaranteed;
            params.wind_strength = 100;
            params.thickness = 0.0005f;
            Simulation simulation(scene, params);
            std::uint32_t impacts = 0;
            for (int frame = 0; frame < 60; ++frame) impacts += simulation.advance_frame().count.impacts;
            EXPECT_GT(impacts, 0u) << info.name;
            return hash_text(simulation.state());
        };
        EXPECT_EQ(hash_on(Backend::cpu), hash_on(Backend::gpu)) << info.name;
    }
}

TEST(SimulationParity, the_backend_changes_in_the_middle_of_a_run_without_a_trace)
{
    const auto context = make_headless_context();
    if (!gl_info().software) GTEST_SKIP() << "hardware rounds division and roots in its own way";
    const Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    Simulation simulation(scene, params);
    for (int frame = 0; frame < 100; ++frame) {
        if (frame % 25 == 10) {
            params.backend = params.backend == Backend::cpu ? Backend::gpu : Backend::cpu;
            simulation.set_params(params);
        }
        simulation.advance_frame();
    }
    EXPECT_EQ(hash_text(simulation.state()), run("seed", Backend::cpu, 1, 100).hash);
    for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
}

}  // namespace
}  // namespace nuno
