// The explicit methods on the CPU: what a step must keep, and how runs are cut into steps.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "solver/solver_runs.h"

namespace nuno {
namespace {

// So soft that explicit Euler, too, is stable at the substeps used here.
void soften(SimParams& params) { params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = 1e-3f; }

class ExplicitTest : public testing::TestWithParam<Method>
{};

TEST_P(ExplicitTest, a_sheet_in_free_fall_keeps_its_shape)
{
    const ClothModel model = square_cloth(10, 1);
    SimParams params = on_cpu(GetParam());
    soften(params);
    params.substeps = 200;
    const ClothState start = start_state(model, params), end = run(model, params, start, 200);
    // Springs at rest feel only the rounding of positions, a few ulp of the distance fallen.
    for (std::size_t v = 1; v < start.positions.size(); ++v)
        EXPECT_NEAR(end.positions[v].y - end.positions[0].y, start.positions[v].y - start.positions[0].y, 2e-5);
}

TEST_P(ExplicitTest, momentum_without_outer_forces_is_kept)
{
    const ClothModel model = square_cloth(8, 1);
    SimParams params = on_cpu(GetParam());
    params.gravity_y = params.damping = 0;
    params.substeps = 2000;
    ClothState state = start_state(model, params);
    std::mt19937 random(2);
    std::normal_distribution<float> at(0, 0.01f);
    for (glm::vec4& p : state.positions) p += glm::vec4(at(random), at(random), at(random), 0);
    const ClothState end = run(model, params, state, 50);
    const Momentum left = momentum(end);
    EXPECT_GT(left.size, 1e-4);
    EXPECT_LT(glm::length(left.sum), 1e-4 * left.size);
}

// Cut into steps of any length, a run is the same run; and what is uploaded midway is where it goes on from.
TEST_P(ExplicitTest, a_run_does_not_depend_on_how_it_is_cut_into_steps)
{
    const ClothModel model = square_cloth(9, 1, {0, 8});
    SimParams params = on_cpu(GetParam());
    params.damping = 2;
    params.stiffness_damping = 1e-4f;
    params.substeps = 4000;
    ThreadPool pool(1);
    ClothState whole = start_state(model, params), cut = whole;
    const auto a = make_solver(model, kNoBodies, params, pool), b = make_solver(model, kNoBodies, params, pool);
    a->upload(whole);
    b->upload(cut);
    a->step({params, 0, 30});
    int done = 0;
    for (const int count : {1, 7, 2, 0, 20}) {
        b->step({params, done * double(substep_s(params)), count});
        done += count;
    }
    a->download_positions(whole.positions), a->download_velocities(whole.velocities);
    b->download_positions(cut.positions), b->download_velocities(cut.velocities);
    EXPECT_EQ(state_hash(whole), state_hash(cut));

    a->set_vertex(40, {2, 3, 4, 0});
    a->step({params, 0, 10});
    cut.positions[40] = {2, 3, 4, 0};
    cut.velocities[40] = glm::vec4(glm::vec3(0), cut.velocities[40].w);
    b->upload(cut);
    b->step({params, 0, 10});
    a->download_positions(whole.positions), b->download_positions(cut.positions);
    EXPECT_EQ(whole.positions, cut.positions);
}

INSTANTIATE_TEST_SUITE_P(Methods, ExplicitTest, testing::ValuesIn(explicit_methods()), kMethodName);

TEST(MethodTable, every_method_has_a_name_a_backend_and_a_solver)
{
    const ClothModel model = square_cloth(3, 1);
    ThreadPool pool(1);
    for (const MethodInfo& info : method_table()) {
        EXPECT_EQ(info.name, choice_names(Method{})[std::size_t(info.method)]);
        ASSERT_TRUE(info.on(Backend::cpu));
        const auto solver = make_solver(model, kNoBodies, on_cpu(info.method), pool);
        EXPECT_EQ(solver->name(), std::string(info.name) + " on cpu");
    }
}

}  // namespace
}  // namespace nuno
