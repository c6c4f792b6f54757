// Cloth in a steady wind against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/stability.h"
#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

// sigma 0.2 kg/m2, Cn 2, rho 1.2 kg/m3.
SimParams windy(Method method)
{
    SimParams params = on_cpu(method);
    params.internal_model = InternalModel::fabric_springs;
    params.warp_stiffness = params.weft_stiffness = 400;
    params.shear_modulus = 50;
    params.wind_model = WindModel::aero;
    params.skin_coefficient = 0;
    params.damping = 1;
    params.stiffness_damping = 1e-4f;
    params.frame_rate = 1;
    return params;
}

// A limp strip hung by its top edge in steady wind U hangs straight at theta from the vertical,
//   sin theta / cos^2 theta = q = rho Cn U^2 / (2 sigma g).
TEST(SteadyWind, a_limp_strip_hangs_straight_at_the_angle_of_the_closed_form)
{
    for (const int rows : {17, 25, 33})
        for (const double speed : {1.0, 2.0, 4.0}) {
            SheetSource source;
            source.name = "strip";
            source.mesh = grid_mesh(3, rows, {0, 0, 0}, {0.1f, 0, 0}, {0, -1, 0});
            source.columns = 3;
            source.rows = rows;
            source.pins = {0, 1, 2};
            for (const glm::vec3& p : source.mesh.positions)
                source.start.emplace_back(p.x, 0.7071068f * p.y, -0.7071068f * p.y);
            const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
            SimParams params = windy(Method::symplectic_euler);
            params.wind_z = static_cast<float>(speed);
            params.damping = 8;
            params.substeps = 3 * least_stable_substeps(model, params);
            const ClothState end = run(model, params, start_state(model, params), 30 * params.substeps);
            const double q = 1.2 * 2 * speed * speed / (2 * 0.2 * 9.81);
            const double expected = std::asin((std::sqrt(1 + 4 * q * q) - 1) / (2 * q)) * 180 / M_PI;
            const auto expect_angle = [&](const char* where, int row, double tolerance) {
                const glm::vec4 p = end.positions[std::size_t(3 * row + 1)];
                expect_measured(
                    fmt::format("limp strip of {} rows in wind of {} m/s, {}: angle, degrees", rows, speed, where),
                    std::atan2(double(p.z), -double(p.y)) * 180 / M_PI, expected, tolerance);
            };
            expect_angle("half way down", rows / 2, 0.1);
            // Which nothing pulls straight, so that it flutters.
            expect_angle("the free end", rows - 1, 1);
        }
}

// A flat cloth falls face-on at sqrt(2 sigma g / (rho Cn)); on the way v = v_end tanh(g t / v_end).
TEST(SteadyWind, a_flat_cloth_falls_at_its_terminal_speed)
{
    const ClothModel model = square_cloth(5, 1, {}, MassLumping::area);
    const double end_speed = std::sqrt(2 * 0.2 * 9.81 / (1.2 * 2));
    for (const Method method : {Method::symplectic_euler, Method::verlet, Method::rk4}) {
        SimParams params = windy(method);
        params.damping = 0;
        params.gravity_y = 0;
        params.gravity_z = -9.81f;
        params.substeps = 500;
        const ClothState start = start_state(model, params);
        const double early = -double(run(model, params, start, 50).velocities[12].z);
        const double late = -double(run(model, params, start, 1000).velocities[12].z);
        const double expected_early = end_speed * std::tanh(9.81 * 0.1 / end_speed);
        expect_measured(fmt::format("fall of a flat cloth after 0.1 s, {}: m/s", name_of(method)), early,
                        expected_early, 0.01 * expected_early);
        expect_measured(fmt::format("terminal speed of a flat cloth, {}: m/s", name_of(method)), late, end_speed, 1e-3);
    }
}

}  // namespace
}  // namespace nuno
