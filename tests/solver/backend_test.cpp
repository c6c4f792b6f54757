// Compute shaders against CPU threads: the same bits on a software renderer.
#include <gtest/gtest.h>

#include <limits>

#include <glm/geometric.hpp>

#include "gl/egl_context.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

class BackendTest : public testing::TestWithParam<Method>
{
  protected:
    BackendTest() : context_(make_headless_context()) {}
    ~BackendTest() override
    {
        for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
    }
    std::unique_ptr<Context> context_;
};

struct Pair
{
    Pair(const ClothModel& model, const Bodies& bodies, SimParams params) : pool(2)
    {
        params.backend = Backend::cpu;
        cpu = make_solver(model, bodies, params, pool);
        params.backend = Backend::gpu;
        gpu = make_solver(model, bodies, params, pool);
    }
    ThreadPool pool;
    std::unique_ptr<ClothSolver> cpu, gpu;
};

// Hardware may divide and take roots to a few ulp: it is held to a distance, over few substeps.
void expect_agreement(ClothSolver& cpu, ClothSolver& gpu, const ClothModel& model, int substeps)
{
    const ClothState a = state_of(cpu, model), b = state_of(gpu, model);
    if (gl_info().software) {
        EXPECT_EQ(state_hash(a), state_hash(b)) << "after " << substeps << " substeps";
        return;
    }
    for (std::size_t v = 0; substeps <= 10 && v < model.vertex_count(); ++v)
        EXPECT_LE(glm::distance(glm::vec3(a.positions[v]), glm::vec3(b.positions[v])), 1e-5f) << "vertex " << v;
}

// 33 x 33 vertices do not fit into the one work group of Euler, the others do.
TEST_P(BackendTest, grids_and_meshes_agree_after_1_10_100_and_1000_substeps)
{
    Bodies bodies;
    bodies.planes.push_back({{0, 1, 0}, -1.2f});
    bodies.spheres.push_back({{0.4f, -0.7f, 0.15f}, 0.25f});
    for (const SheetSource& source :
         {square_sheet(17, 1, {0, 16}), square_mesh(17, 1, 64), square_sheet(23, 1), square_sheet(33, 1, {0})})
    {
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        SimParams params;
        params.method = GetParam();
        params.sweep = Sweep::coloured;  // the order of xpbd that both have
        params.substeps = params.method == Method::explicit_euler ? 600 : 60;
        params.seed = 9;
        params.jitter = 1e-3f;
        params.wind_strength = 2;
        params.damping = params.method == Method::explicit_euler ? 8.0f : 0.2f;
        Pair pair(model, bodies, params);
        const ClothState start = start_state(model, params);
        pair.cpu->upload(start);
        pair.gpu->upload(start);
        int done = 0;
        for (const int substeps : {1, 10, 100, 1000}) {
            const StepInput input{params, done * double(substep_s(params)), substeps - done};
            pair.cpu->step(input);
            pair.gpu->step(input);
            done = substeps;
            expect_agreement(*pair.cpu, *pair.gpu, model, substeps);
        }
        EXPECT_EQ(pair.cpu->first_lost(), std::nullopt);
        EXPECT_NE(state_hash(state_of(*pair.cpu, model)), state_hash(start)) << "nothing moved";
    }
}

TEST_P(BackendTest, live_changes_of_parameters_agree)
{
    const ClothModel model = square_cloth(17, 1, {0});
    SimParams params;
    params.method = GetParam();
    params.sweep = Sweep::coloured;  // the order of xpbd that both have
    params.damping = 8;
    params.substeps = 100;
    Pair pair(model, kNoBodies, params);
    for (ClothSolver* solver : {pair.cpu.get(), pair.gpu.get()}) {
        SimParams live = params;
        solver->upload(start_state(model, live));
        solver->step({live, 0, 20});
        live.structural_stiffness *= 3;
        live.wind_mean = 1;
        solver->step({live, 0.1, 20});
        solver->set_vertex(100, {0.3f, 0.2f, 0.1f, 0});
        solver->step({live, 0.2, 21});
    }
    expect_agreement(*pair.cpu, *pair.gpu, model, 10);
    const ClothState state = state_of(*pair.gpu, model);
    EXPECT_EQ(glm::vec3(state.positions[100]), glm::vec3(0.3f, 0.2f, 0.1f)) << "a held vertex stays";
}

TEST_P(BackendTest, the_first_vertex_that_is_lost_is_found_on_both)
{
    const ClothModel model = square_cloth(9, 1);
    SimParams params;
    params.method = GetParam();
    params.sweep = Sweep::coloured;  // the order of xpbd that both have
    Pair pair(model, kNoBodies, params);
    ClothState state = start_state(model, params);
    for (ClothSolver* solver : {pair.cpu.get(), pair.gpu.get()}) {
        solver->upload(state);
        EXPECT_EQ(solver->first_lost(), std::nullopt);
    }
    state.velocities[42].z = std::numeric_limits<float>::quiet_NaN();
    state.positions[60].x = std::numeric_limits<float>::infinity();
    for (ClothSolver* solver : {pair.cpu.get(), pair.gpu.get()}) {
        solver->upload(state);
        EXPECT_EQ(solver->first_lost(), 42u);
    }
    state.positions[40].y = -1e6f;
    state.positions[39].y = 999999;
    for (ClothSolver* solver : {pair.cpu.get(), pair.gpu.get()}) {
        solver->upload(state);
        EXPECT_EQ(solver->first_lost(), 40u);
    }
}

std::vector<Method> methods_of_both_backends()
{
    return methods_that([](const MethodInfo& info) { return info.on(Backend::gpu); });
}

INSTANTIATE_TEST_SUITE_P(Methods, BackendTest, testing::ValuesIn(methods_of_both_backends()), kMethodName);

}  // namespace
}  // namespace nuno
