// Forces on faces, dampers of springs and moving pins: compute shaders against CPU threads, bit for bit.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "gl/egl_context.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

class FacesParityTest : public testing::TestWithParam<Method>
{
  protected:
    FacesParityTest() : context_(make_headless_context()) {}
    ~FacesParityTest() override
    {
        for (const std::string& error : take_gl_errors()) ADD_FAILURE() << error;
    }

    // The state after a run in which parameters change midway.
    ClothState after(const ClothModel& model, const Bodies& bodies, SimParams params, Backend backend)
    {
        params.backend = backend;
        ThreadPool pool(2);
        const auto solver = make_solver(model, bodies, params, pool);
        ClothState state = start_state(model, params);
        solver->upload(state);
        solver->step({params, 0, 40});
        params.gust_speed *= 0.5f;
        params.stiffness_damping = 0;
        solver->step({params, 0.1, 41});
        params.wind_model = WindModel::sines;
        solver->step({params, 0.2, 20});
        solver->download_positions(state.positions);
        solver->download_velocities(state.velocities);
        return state;
    }

    void expect_agreement(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    {
        const ClothState a = after(model, bodies, params, Backend::cpu);
        const ClothState b = after(model, bodies, params, Backend::gpu);
        EXPECT_EQ(first_lost(a.positions), std::nullopt);
        EXPECT_NE(state_hash(a), state_hash(start_state(model, params))) << "nothing moved";
        if (gl_info().software) {
            EXPECT_EQ(state_hash(a), state_hash(b));
        }
        for (std::size_t v = 0; v < a.positions.size(); ++v)
            EXPECT_LE(glm::distance(glm::vec3(a.positions[v]), glm::vec3(b.positions[v])), 1e-3f) << "vertex " << v;
    }

    SimParams params_for_all() const
    {
        SimParams params = on_cpu(GetParam());
        params.seed = 3;
        params.jitter = 1e-3f;
        params.frame_rate = 60;
        params.substeps = 60;
        params.damping = params.method == Method::explicit_euler ? 8.0f : 0.2f;
        params.stiffness_damping = 1e-4f;
        params.warp_stiffness = 40;
        params.weft_stiffness = 30;
        params.cross_stiffness = 5;
        params.shear_modulus = 10;
        params.bending_warp = params.bending_weft = params.bending_bias = 1e-4f;
        params.wind_model = WindModel::aero;
        params.wind_x = 4;
        params.wind_z = -6;
        params.gust_speed = 3;
        params.gust_size = 0.4f;
        params.gust_seed = 5;
        return params;
    }

    std::unique_ptr<Context> context_;
};

TEST_P(FacesParityTest, membrane_plate_and_gusty_air_agree_on_grids_and_meshes)
{
    for (const SheetSource& source : {square_sheet(17, 1, {0, 16}), square_mesh(13, 1, 64)})
        for (const InternalModel internal : {InternalModel::continuum, InternalModel::fabric_springs}) {
            const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
            SimParams params = params_for_all();
            params.internal_model = internal;
            expect_agreement(model, {}, params);
        }
}

TEST_P(FacesParityTest, pins_on_a_moving_handle_and_a_turning_body_agree)
{
    SheetSource source = square_sheet(17, 1, {0});
    source.handle_pins = {{16, 0}, {10, 0}};
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
    Bodies bodies;
    bodies.spheres.push_back({{0.4f, -0.6f, 0.15f}, 0.2f, {}});
    bodies.spheres[0].motion.keyframes = {{0, {0, 0, 0}, {0, 1, 0}, 0}, {1, {0, 0.1, 0}, {0, 1, 0}, 3}};
    bodies.handles.push_back({"hand", {}});
    bodies.handles[0].motion.keyframes = {{0, {0, 0, 0}, {0, 1, 0}, 0}, {1, {0.2, 0.3, 0}, {0, 1, 0}, 0}};
    SimParams params = params_for_all();
    params.internal_model = InternalModel::springs;
    expect_agreement(model, bodies, params);
}

INSTANTIATE_TEST_SUITE_P(Methods, FacesParityTest, testing::ValuesIn(explicit_methods()), kMethodName);

}  // namespace
}  // namespace nuno
