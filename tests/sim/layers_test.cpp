// Levels of collision between layers, in scenes.
#include <gtest/gtest.h>

#include "sim/run_recorder.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

struct LayerRun
{
    CollisionCounts count;
    std::string hash;
};

// `gale` as thin layers in ten times its wind, with vertices through faces counted beside what the level itself says.
LayerRun run_gale(CollisionLevel level, Method method, int threads = 1, int frames = 60)
{
    const Scene scene = load_scene("gale");
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    params.wind_strength = 100;
    params.thickness = 0.0005f;
    params.method = method;
    params.collision = level;
    params.threads = threads;
    Simulation simulation(scene, params);
    LayerRun run;
    for (int i = 0; i < frames; ++i) {
        const CollisionCounts count = simulation.advance_frame().count;
        run.count.contacts += count.contacts;
        run.count.impacts += count.impacts;
        run.count.unresolved += count.unresolved;
    }
    run.hash = hash_text(simulation.state());
    return run;
}

TEST(Layers, pass_through_one_another_at_discrete_and_not_at_guaranteed)
{
    EXPECT_GT(run_gale(CollisionLevel::discrete, Method::automatic).count.unresolved, 20u);
    const LayerRun run = run_gale(CollisionLevel::guaranteed, Method::automatic);
    EXPECT_GT(run.count.contacts, 100u);
    EXPECT_GT(run.count.impacts, 0u);
    EXPECT_EQ(run.count.unresolved, 0u);
}

TEST(Layers, are_kept_apart_with_every_method)
{
    for (const Method method : {Method::symplectic_euler, Method::verlet, Method::rk4, Method::xpbd, Method::vbd,
                                Method::implicit_euler, Method::sdirk2})
    {
        const LayerRun run = run_gale(CollisionLevel::guaranteed, method);
        EXPECT_GT(run.count.contacts, 100u) << int(method);
        EXPECT_EQ(run.count.unresolved, 0u) << int(method);
    }
}

TEST(Layers, do_not_depend_on_the_number_of_threads)
{
    const std::string one = run_gale(CollisionLevel::guaranteed, Method::automatic, 1).hash;
    for (const int threads : {2, 3})
        EXPECT_EQ(run_gale(CollisionLevel::guaranteed, Method::automatic, threads).hash, one);
}

TEST(Layers, a_level_can_be_changed_while_the_cloth_moves)
{
    const Scene scene = load_scene("gale");
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    Simulation simulation(scene, params);
    for (const CollisionLevel level : {CollisionLevel::speculative, CollisionLevel::none, CollisionLevel::guaranteed,
                                       CollisionLevel::discrete, CollisionLevel::continuous, CollisionLevel::none})
    {
        params.collision = level;
        simulation.set_params(params);
        for (int i = 0; i < 8; ++i) simulation.advance_frame();
    }
    EXPECT_FALSE(first_lost(simulation.state().positions));
}

}  // namespace
}  // namespace nuno
