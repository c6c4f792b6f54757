// The number of threads changes nothing.
#include <gtest/gtest.h>

#include "solver/solver_runs.h"

namespace nuno {
namespace {

class ThreadsTest : public testing::TestWithParam<Method>
{
  protected:
    std::uint64_t hash_of_run(const SimParams& params, int threads) const
    {
        ThreadPool pool(threads);
        const auto solver = make_solver(model_, bodies_, params, pool);
        ClothState state = start_state(model_, params);
        solver->upload(state);
        solver->step({params, 0.25, 51});
        solver->step({params, 0.5, 50});
        solver->download_positions(state.positions);
        solver->download_velocities(state.velocities);
        return state_hash(state);
    }

    void expect_same_bits(const SimParams& params) const
    {
        const std::uint64_t one = hash_of_run(params, 1);
        for (const int threads : {2, 3, 1}) EXPECT_EQ(hash_of_run(params, threads), one) << threads << " threads";
    }

    ThreadsTest() { bodies_.spheres.push_back({{0.5f, -0.6f, 0.1f}, 0.2f, {}}); }

    const ClothModel model_ = square_cloth(64, 1, {0, 63});
    Bodies bodies_;
};

TEST_P(ThreadsTest, one_two_and_three_give_the_same_bits)
{
    SimParams params = on_cpu(GetParam());
    params.wind_strength = 3;
    params.stiffness_damping = 1e-4f;
    params.frame_rate = 60;
    params.substeps = 100;
    expect_same_bits(params);
}

TEST_P(ThreadsTest, forces_on_faces_are_the_same_bits_too)
{
    SimParams params = on_cpu(GetParam());
    params.internal_model = InternalModel::continuum;
    params.warp_stiffness = params.weft_stiffness = 40;
    params.shear_modulus = 10;
    params.wind_model = WindModel::aero;
    params.wind_x = params.wind_z = 5;
    params.gust_speed = 3;
    params.frame_rate = 60;
    params.substeps = 100;
    expect_same_bits(params);
}

INSTANTIATE_TEST_SUITE_P(Methods, ThreadsTest, testing::ValuesIn(explicit_methods()), kMethodName);

}  // namespace
}  // namespace nuno
