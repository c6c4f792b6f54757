// A run that was saved goes on with the same bits as the one that never stopped, in compute shaders.
#include <gtest/gtest.h>

#include <tuple>

#include "gl/egl_context.h"
#include "model/oscillator.h"
#include "sim/run_recorder.h"
#include "sim/saved_run.h"

namespace nuno {
namespace {

class SavedOnGpu : public testing::TestWithParam<std::tuple<Method, Sweep, CollisionLevel>>
{};

TEST_P(SavedOnGpu, goes_on_with_the_same_bits)
{
    const auto [method, sweep, level] = GetParam();
    const auto context = make_headless_context();
    const Scene scene = SavedSceneFolder().scene();
    SimParams params = scene.params;
    params.backend = Backend::gpu;
    params.method = method;
    params.sweep = sweep;
    params.collision = level;
    if (!is_explicit(method)) params.substeps = 6;
    if (method == Method::explicit_euler) {  // which only drag keeps stable
        params.damping = 30;
        params.substeps = 300;
    }
    Simulation whole(scene, params), resumed(scene, params);
    advance_frames(whole, 15);
    resumed.resume(whole.save());
    EXPECT_EQ(hash_text(resumed.state()), hash_text(whole.state()));
    for (int frame = 0; frame < 5; ++frame) {
        whole.advance_frame();
        resumed.advance_frame();
        EXPECT_EQ(hash_text(resumed.state()), hash_text(whole.state())) << "frame " << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, SavedOnGpu,
                         testing::Values(std::tuple(Method::explicit_euler, Sweep::automatic, CollisionLevel::discrete),
                                         std::tuple(Method::symplectic_euler, Sweep::automatic,
                                                    CollisionLevel::discrete),
                                         std::tuple(Method::verlet, Sweep::automatic, CollisionLevel::discrete),
                                         std::tuple(Method::rk4, Sweep::automatic, CollisionLevel::discrete),
                                         std::tuple(Method::xpbd, Sweep::coloured, CollisionLevel::none),
                                         std::tuple(Method::xpbd, Sweep::coloured, CollisionLevel::spheres),
                                         std::tuple(Method::xpbd, Sweep::coloured, CollisionLevel::discrete),
                                         std::tuple(Method::xpbd, Sweep::coloured, CollisionLevel::speculative),
                                         std::tuple(Method::xpbd, Sweep::coloured, CollisionLevel::continuous),
                                         std::tuple(Method::xpbd, Sweep::coloured, CollisionLevel::guaranteed),
                                         std::tuple(Method::xpbd, Sweep::jacobi, CollisionLevel::discrete),
                                         std::tuple(Method::vbd, Sweep::automatic, CollisionLevel::discrete),
                                         std::tuple(Method::verlet, Sweep::automatic, CollisionLevel::guaranteed)));

TEST(MovedBodiesOnGpu, push_as_on_the_cpu_to_the_bit)
{
    const auto context = make_headless_context();
    const Scene scene = SavedSceneFolder().scene();
    for (const Method method : {Method::symplectic_euler, Method::rk4, Method::xpbd}) {
        std::string hashes[2];
        for (const Backend backend : {Backend::cpu, Backend::gpu}) {
            SimParams params = scene.params;
            params.method = method;
            params.sweep = Sweep::coloured;
            params.backend = backend;
            Simulation simulation(scene, params);
            advance_frames(simulation, 5);
            simulation.hold_body(0, {0.05, 0.1, 0});
            advance_frames(simulation, 10);
            simulation.release_body();
            advance_frames(simulation, 3);
            hashes[std::size_t(backend)] = hash_text(simulation.state());
        }
        EXPECT_EQ(hashes[0], hashes[1]) << int(method);
    }
}

TEST(PinsOnGpu, are_those_of_the_cpu_to_the_bit)
{
    const auto context = make_headless_context();
    const Scene scene = SavedSceneFolder().scene();
    for (const Method method : {Method::symplectic_euler, Method::xpbd}) {
        std::string hashes[2];
        for (const Backend backend : {Backend::cpu, Backend::gpu}) {
            SimParams params = scene.params;
            params.method = method;
            params.sweep = Sweep::coloured;
            params.backend = backend;
            Simulation simulation(scene, params);
            advance_frames(simulation, 5);
            simulation.set_pinned(40, true);
            simulation.set_pinned(simulation.model().vertex_count() - 1, false);
            advance_frames(simulation, 10);
            hashes[std::size_t(backend)] = hash_text(simulation.state());
        }
        EXPECT_EQ(hashes[0], hashes[1]) << int(method);
    }
}

}  // namespace
}  // namespace nuno
