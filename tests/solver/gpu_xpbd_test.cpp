// XPBD and vertex block descent in compute shaders against CPU threads, in what other methods do not have: tethers,
// strain limit, bending, what comes between steps. The same bits on a software renderer.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "gl/egl_context.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

class GpuPositionTest : public testing::TestWithParam<MethodAndSweep>
{
  protected:
    GpuPositionTest() : context_(make_headless_context())
    {
        params_.method = GetParam().method;
        params_.sweep = GetParam().sweep;
        params_.tethers = Tethers::pins;
        params_.substeps = 6;
        params_.structural_stiffness = 2000;
        params_.shear_stiffness = 500;
        params_.gravity_z = 1;
    }
    ~GpuPositionTest() override
    {
        for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
    }

    // Calls body(solver) with a solver of each backend, and expects the same state after it.
    template <class Body>
    void expect_agreement(const ClothModel& model, const Bodies& bodies, const Body& body)
    {
        ThreadPool pool(2);
        ClothState states[2];
        for (const Backend backend : {Backend::cpu, Backend::gpu}) {
            SimParams params = params_;
            params.backend = backend;
            const auto solver = make_solver(model, bodies, params, pool);
            ClothState& state = states[backend == Backend::gpu];
            state = start_state(model, params);
            solver->upload(state);
            body(*solver, params);
            solver->download_positions(state.positions);
            solver->download_velocities(state.velocities);
        }
        if (gl_info().software) {
            EXPECT_EQ(state_hash(states[0]), state_hash(states[1]));
            return;
        }
        for (std::size_t v = 0; v < states[0].positions.size(); ++v)
            EXPECT_LE(glm::distance(glm::vec3(states[0].positions[v]), glm::vec3(states[1].positions[v])), 1e-2f);
    }

    std::unique_ptr<Context> context_;
    SimParams params_;
};

void run_frames(ClothSolver& solver, const SimParams& params, int first_frame, int count)
{
    for (int frame = first_frame; frame < first_frame + count; ++frame)
        solver.step({params, frame / double(params.frame_rate), params.substeps});
}

// 64 x 64 is the most that fits into one work group.
TEST_P(GpuPositionTest, small_and_large_sheets_with_tethers_and_several_iterations_agree)
{
    for (const int count : {17, 64, 65})
        for (const int iterations : {0, 3}) {
            params_.iterations = iterations;
            const ClothModel model = square_cloth(count, 1, {0, static_cast<std::uint32_t>(count - 1)});
            SCOPED_TRACE(count);
            expect_agreement(model, kNoBodies,
                             [](ClothSolver& solver, SimParams& params) { run_frames(solver, params, 0, 15); });
        }
}

// More than one dispatch of one work group does: many substeps, and many sweeps in each.
TEST_P(GpuPositionTest, much_work_in_one_step_agrees)
{
    struct Work
    {
        int count, substeps, iterations;
    };
    for (const Work work : {Work{17, 601, 1}, {45, 401, 1}, {64, 2, 400}}) {
        SCOPED_TRACE(work.count);
        params_.substeps = work.substeps;
        params_.iterations = work.iterations;
        const ClothModel model = square_cloth(work.count, 1, {0});
        expect_agreement(model, kNoBodies,
                         [](ClothSolver& solver, SimParams& params) { run_frames(solver, params, 0, 1); });
    }
}

TEST_P(GpuPositionTest, several_sheets_with_bending_limit_and_moving_air_agree)
{
    std::vector<SheetSource> sources{square_mesh(12, 1, 16), square_sheet(9, 0.5f, {0}), square_mesh(6, 0.3f)};
    sources[0].pins = {3, 90};
    const ClothModel model = build_cloth_model(sources, MassLumping::area);
    params_.strain_limit = 0.05f;
    params_.tether_stretch = 0.1f;
    if (params_.sweep != Sweep::jacobi)  // which has none
        params_.bending_warp = params_.bending_weft = params_.bending_bias = 1e-4f;
    params_.wind_model = WindModel::aero;
    params_.wind_z = 5;
    params_.gust_speed = 2;
    Bodies bodies;
    bodies.spheres.push_back({{0.4f, -0.4f, 0.3f}, 0.2f});
    expect_agreement(model, bodies, [](ClothSolver& solver, SimParams& params) { run_frames(solver, params, 0, 20); });
}

TEST_P(GpuPositionTest, pins_velocities_and_parameters_that_change_between_steps_agree)
{
    const ClothModel model = square_cloth(17, 1, {0, 16}, MassLumping::area);
    expect_agreement(model, kNoBodies, [&](ClothSolver& solver, SimParams& params) {
        run_frames(solver, params, 0, 3);
        solver.set_vertex(200, {0.2f, -0.3f, 0.4f, 0});
        run_frames(solver, params, 3, 3);
        std::vector<glm::vec4> velocities(model.vertex_count());
        solver.download_velocities(velocities);
        for (std::size_t v = 50; v < 60; ++v) velocities[v] += glm::vec4(0.5f, -0.25f, 1, 0);
        solver.upload_velocities(velocities);
        run_frames(solver, params, 6, 2);
        solver.set_vertex(200, {0.2f, -0.3f, 0.4f, 1 / (params.areal_density * model.areas[200])});
        params.substeps = 9;
        params.structural_stiffness = 50;
        params.strain_limit = 0.2f;
        run_frames(solver, params, 8, 3);
        params.tethers = Tethers::none;
        params.strain_limit = 0;
        params.stiffness_damping = 0;
        run_frames(solver, params, 11, 3);
    });
}

// Plates take a small sheet out of the one work group, and the way back leads through either kind of springs.
TEST_P(GpuPositionTest, bending_and_limits_that_come_and_go_agree)
{
    const float bends = params_.sweep == Sweep::jacobi ? 0 : 1e-4f;  // it has no bending
    const ClothModel model = square_cloth(12, 1, {0, 11});
    params_.structural_stiffness = 20;
    expect_agreement(model, kNoBodies, [&](ClothSolver& solver, SimParams& params) {
        int frame = 0;
        for (const auto& [bending, limit] :
             {std::pair{0.0f, 0.0f}, {bends, 0.02f}, {0.0f, 0.02f}, {bends, 0.02f}, {bends, 0.0f}, {0.0f, 0.0f}})
        {
            params.bending_warp = params.bending_weft = params.bending_bias = bending;
            params.strain_limit = limit;
            run_frames(solver, params, frame, 4);
            frame += 4;
        }
    });
}

TEST_P(GpuPositionTest, tethers_to_contacts_are_refused_by_name)
{
    const ClothModel model = square_cloth(5, 1, {0});
    params_.backend = Backend::gpu;
    params_.tethers = Tethers::contacts;
    ThreadPool pool(1);
    try {
        make_solver(model, kNoBodies, params_, pool);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("choose these, pins or none"), std::string::npos) << error.what();
    }
}

// The springs are made anew; what moves keeps moving.
TEST(GpuXpbd, bending_and_another_sweep_can_come_while_it_runs)
{
    const std::unique_ptr<Context> context = make_headless_context();
    const SheetSource source = square_mesh(9, 1);
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    SimParams params;
    params.method = Method::xpbd;
    params.backend = Backend::gpu;
    params.substeps = 5;
    params.tethers = Tethers::none;
    params.damping = 0;
    ThreadPool pool(1);
    const auto solver = make_solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    const float start = state.positions[0].y;
    solver->upload(state);
    run_frames(*solver, params, 0, 5);
    params.sweep = Sweep::jacobi;
    run_frames(*solver, params, 5, 5);
    params.sweep = Sweep::automatic;
    params.bending_warp = params.bending_weft = params.bending_bias = 1e-3f;
    run_frames(*solver, params, 10, 10);
    solver->download_positions(state.positions);
    const float time_s = 20 / 60.0f;
    // A free fall, of second order in the substep.
    EXPECT_NEAR(start - state.positions[0].y, 9.81f * time_s * time_s / 2, 0.01f);
    for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
}

// Beside a large sheet, the small one is not taken by one work group.
TEST(GpuXpbd, a_small_sheet_moves_alone_as_it_does_beside_a_large_one)
{
    const std::unique_ptr<Context> context = make_headless_context();
    const std::vector<SheetSource> sources{square_sheet(20, 1, {0, 19}), square_sheet(62, 1, {0})};
    Bodies bodies;
    bodies.spheres.push_back({{0.4f, -0.6f, 0.1f}, 0.2f});
    SimParams params;
    params.method = Method::xpbd;
    params.sweep = Sweep::coloured;
    params.backend = Backend::gpu;
    params.tethers = Tethers::pins;
    params.substeps = 6;
    params.structural_stiffness = 2000;
    params.strain_limit = 0.02f;
    ThreadPool pool(2);
    std::vector<ClothState> states;
    for (const std::size_t sheet_count : {1u, 2u}) {
        const ClothModel model = build_cloth_model(std::span(sources).first(sheet_count), MassLumping::area);
        const auto solver = make_solver(model, bodies, params, pool);
        solver->upload(start_state(model, params));
        run_frames(*solver, params, 0, 15);
        states.push_back(state_of(*solver, model));
    }
    const std::size_t vertex_count = states[0].positions.size();
    EXPECT_EQ(vertex_count, 400u);
    for (std::size_t v = 0; v < vertex_count; ++v) {
        ASSERT_EQ(states[0].positions[v], states[1].positions[v]) << "vertex " << v;
        ASSERT_EQ(states[0].velocities[v], states[1].velocities[v]) << "vertex " << v;
    }
}

TEST(GpuXpbd, refuses_an_order_that_only_the_cpu_has_and_lists_its_own)
{
    const std::unique_ptr<Context> context = make_headless_context();
    const ClothModel model = square_cloth(5, 1, {0});
    SimParams params;
    params.method = Method::xpbd;
    params.backend = Backend::gpu;
    params.substeps = 5;
    params.tethers = Tethers::none;
    params.sweep = Sweep::rows;
    ThreadPool pool(1);
    try {
        make_solver(model, kNoBodies, params, pool);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("coloured"), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, GpuPositionTest,
                         testing::Values(MethodAndSweep{Method::xpbd, Sweep::coloured},
                                         MethodAndSweep{Method::xpbd, Sweep::jacobi}, MethodAndSweep{Method::vbd}),
                         kMethodName);

}  // namespace
}  // namespace nuno
