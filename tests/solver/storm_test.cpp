// Cloth in a storm.
#include <gtest/gtest.h>

#include <cmath>

#include "model/stability.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

// Air at 100 m/s on a coarse substep: the force is bounded, so that the air cannot throw the cloth about.
TEST(Storm, wind_of_100_metres_a_second_blows_no_explicit_method_up)
{
    const ClothModel model = square_cloth(9, 1, {0, 8}, MassLumping::area);
    for (const Method method : {Method::symplectic_euler, Method::verlet, Method::rk4}) {
        SimParams params = on_cpu(method);
        params.internal_model = InternalModel::fabric_springs;
        params.wind_model = WindModel::aero;
        params.damping = 1;
        params.frame_rate = 1;
        params.warp_stiffness = params.weft_stiffness = 20000;
        params.shear_modulus = 2000;
        params.stiffness_damping = 1e-5f;
        params.skin_coefficient = 0.02f;
        params.wind_x = 30;
        params.wind_z = 100;
        params.gust_speed = 50;
        params.gust_size = 0.3f;
        params.substeps = least_stable_substeps(model, params);
        const ClothState end = run(model, params, start_state(model, params), 2 * params.substeps);
        ASSERT_EQ(first_lost(end.positions), std::nullopt) << int(method);
        for (const glm::vec4& p : end.positions) EXPECT_LT(std::hypot(p.x, p.y, p.z), 3.0f);
    }
}

// Still air takes half of the speed of a vertex at most, whatever its mass: where the neighbours are heavier than it by
// 1e4, the force on a face is bounded by the lightest of its corners.
TEST(Storm, still_air_turns_no_vertex_round_however_light)
{
    constexpr float speed = 10;
    ClothModel model = square_cloth(9, 1, {}, MassLumping::area);
    for (std::uint32_t v = 1; v < model.vertex_count(); v += 2) model.areas[v] /= 1e4f;
    for (const Method method : methods_that([](const MethodInfo& info) { return info.method != Method::reference; })) {
        SimParams params = on_cpu(method);
        params.wind_model = WindModel::aero;
        params.damping = params.gravity_y = 0;
        params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = 1e-9f;
        params.frame_rate = 60;
        ClothState state = start_state(model, params);
        for (glm::vec4& v : state.velocities) v.z = speed;
        for (const glm::vec4& v : run(model, params, state, 1).velocities) {
            EXPECT_GE(v.z, 0.499f * speed) << name_of(method);
            EXPECT_LT(v.z, speed) << name_of(method);
        }
    }
}

}  // namespace
}  // namespace nuno
