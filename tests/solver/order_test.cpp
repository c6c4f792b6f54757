// The order at which the error of every method falls with its substep, on smooth problems (Hairer, Norsett and Wanner,
// Solving ODEs I, II.3): halved, it leaves 2^-p of the error.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/force_model.h"
#include "solver/explicit/cpu_reference.h"
#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

class OrderTest : public testing::TestWithParam<MethodAndSweep>
{
  protected:
    int order() const { return order_of(GetParam().method); }
    // The least substeps at which the error is that of the order, and still well above what floats lose.
    int least(int first, int second, int fourth) const { return order() == 1 ? first : order() == 2 ? second : fourth; }

    SimParams params() const
    {
        SimParams params = on_cpu(GetParam().method, GetParam().sweep);
        params.tolerance = 1e-10f;
        // vbd is implicit Euler where its sweeps have converged.
        if (params.method == Method::vbd) params.iterations = 30;
        return params;
    }

    void expect_order(const char* problem, double coarse, double fine) const
    {
        expect_measured(fmt::format("order of convergence, {}, {}", problem, name_of(GetParam())),
                        std::log2(coarse / fine), order(), 0.1);
    }
};

// v(t) = g m / c (1 - e^(-c t / m)), y(t) = g m / c (t - m / c (1 - e^(-c t / m))), c / m = 1.5 / s. Not for rk4: the
// error of steps so short that in exact numbers its order is within 0.1 of 4 is what floats lose.
class FallTest : public OrderTest
{};

TEST_P(FallTest, free_fall_with_drag_follows_the_closed_form)
{
    const ClothModel model = square_cloth(10, 1);
    SimParams p = params();
    p.damping = 0.3f;
    // So soft that every method is stable and that springs do not answer the rounding of positions.
    p.structural_stiffness = p.shear_stiffness = p.bend_stiffness = 1e-3f;
    const double rate = 0.3 / 0.2, g = -9.81;
    const double speed = g / rate * (1 - std::exp(-rate)), fall = g / rate * (1 - (1 - std::exp(-rate)) / rate);
    double speed_errors[2], fall_errors[2];
    for (int i = 0; i < 2; ++i) {
        p.substeps = (order() == 1 ? 100 : 40) << i;
        const ClothState start = start_state(model, p), end = run(model, p, start, p.substeps);
        speed_errors[i] = std::abs(double(end.velocities[37].y) - speed);
        fall_errors[i] = std::abs(double(end.positions[37].y - start.positions[37].y) - fall);
    }
    expect_order("speed of a fall with drag", speed_errors[0], speed_errors[1]);
    expect_order("way of a fall with drag", fall_errors[0], fall_errors[1]);
    EXPECT_LT(speed_errors[1] / std::abs(speed), 0.01);
}

// x(t) = 1 + a cos(omega t), two periods of 1/2 s on a spring: the error is that of x and v / omega together. It adds up
// over the periods, so that rk4's is well above what floats lose.
class OscillationTest : public OrderTest
{};

TEST_P(OscillationTest, an_oscillation_follows_the_closed_form)
{
    const ClothModel model = one_spring();
    const double omega = 4 * M_PI, amplitude = 0.25;
    SimParams p = params();
    p.gravity_y = p.damping = p.wind_strength = 0;
    p.structural_stiffness = static_cast<float>(double(p.areal_density) * omega * omega);
    ClothState start = start_state(model, p);
    start.positions[1].x = static_cast<float>(1 + amplitude);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        p.substeps = 48 << i;
        const ClothState end = run(model, p, start, p.substeps);
        errors[i] = std::hypot(double(end.positions[1].x) - (1 + amplitude), double(end.velocities[1].x) / omega);
    }
    expect_order("oscillation", errors[0], errors[1]);
    EXPECT_LT(errors[1], 0.05 * amplitude);
}

// A 5 x 5 sheet with a damper swings on two pegs for 0.25 s; the truth is `reference` at a hundredth of the error.
ClothModel swinging_sheet()
{
    SheetSource source = square_sheet(5, 1, {0, 4});
    for (const glm::vec3& p : source.mesh.positions) source.start.emplace_back(p.x, 0.8f * p.y, 0.6f * p.y);
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

SimParams swinging(SimParams params)
{
    params.structural_stiffness = 40;
    params.shear_stiffness = 20;
    params.bend_stiffness = 7;
    params.damping = 0.1f;
    params.frame_rate = 4;
    return params;
}

TEST_P(OrderTest, a_damped_swinging_sheet_converges_to_the_reference)
{
    const ClothModel model = swinging_sheet();
    SimParams p = swinging(params());
    SimParams exact = swinging(on_cpu(Method::reference));
    exact.tolerance = 1e-7f;
    // Rayleigh damping, too, where the method has it.
    if (method_info(p.method).takes_dampers) p.stiffness_damping = exact.stiffness_damping = 2e-3f;
    const ClothState start = start_state(model, p), truth = run(model, exact, start, 1);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        p.substeps = least(400, 32, 20) << i;
        errors[i] = rms_distance(run(model, p, start, p.substeps), truth);
    }
    expect_order("swinging sheet", errors[0], errors[1]);
}

std::vector<MethodAndSweep> methods_of_fixed_steps()
{
    std::vector<MethodAndSweep> all = methods_and_sweeps();
    std::erase_if(all, [](const MethodAndSweep& each) { return each.method == Method::reference; });
    return all;
}

std::vector<MethodAndSweep> methods_of_order(int least, int most)
{
    std::vector<MethodAndSweep> all = methods_of_fixed_steps();
    std::erase_if(
        all, [=](const MethodAndSweep& each) { return order_of(each.method) < least || order_of(each.method) > most; });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Methods, OrderTest, testing::ValuesIn(methods_of_fixed_steps()), kMethodName);
INSTANTIATE_TEST_SUITE_P(Methods, FallTest, testing::ValuesIn(methods_of_order(1, 2)), kMethodName);
INSTANTIATE_TEST_SUITE_P(Methods, OscillationTest, testing::ValuesIn(methods_of_order(3, 4)), kMethodName);

// Dormand and Prince's method with steps of one length, in double.
TEST(ReferenceOrder, the_runge_kutta_pair_of_the_reference_is_of_order_5)
{
    const ClothModel model = swinging_sheet();
    SimParams params = swinging(on_cpu(Method::reference));
    params.stiffness_damping = 2e-3f;
    const ForceModel forces(model, params);
    const ClothState state = start_state(model, params);
    const auto acceleration = [&](std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time,
                                  std::span<glm::dvec3> a) {
        forces.forces(x, v, time, a);
        for (std::size_t i = 0; i < a.size(); ++i) a[i] *= double(state.positions[i].w);
    };
    const auto end_after = [&](int steps) {
        DormandPrince method(model.vertex_count());
        MotionInDouble now{{}, std::vector<glm::dvec3>(model.vertex_count())}, next = now;
        for (const glm::vec4& p : state.positions) now.x.emplace_back(p);
        next.x = now.x;
        for (int i = 0; i < steps; ++i) {
            method.step(acceleration, now, 0.25 * i / steps, 0.25 / steps, i == 0, next);
            method.accept();
            std::swap(now, next);
        }
        return now.x;
    };
    const auto error = [&](const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
        return std::sqrt(sum);
    };
    const std::vector<glm::dvec3> truth = end_after(2000);
    expect_measured("order of convergence, swinging sheet, reference at fixed steps",
                    std::log2(error(end_after(80), truth) / error(end_after(160), truth)), 5, 0.1);
}

// The error of a step is held to `tolerance`, err ~ h^5: a hundredth of it asks for 100^(1/5) times the steps.
TEST(ReferenceOrder, a_smaller_tolerance_takes_the_steps_of_order_5)
{
    const ClothModel model = swinging_sheet();
    SimParams params = swinging(on_cpu(Method::reference));
    long counts[2];
    for (int i = 0; i < 2; ++i) {
        params.tolerance = i == 0 ? 1e-6f : 1e-8f;
        ThreadPool pool(1);
        CpuReference solver(model, kNoBodies, params, pool);
        solver.upload(start_state(model, params));
        solver.step({params, 0, 1});
        counts[i] = solver.step_count();
    }
    expect_measured("reference: steps at a hundredth of the tolerance over steps at it", double(counts[1]) / counts[0],
                    std::pow(100, 0.2), 0.15);
}

}  // namespace
}  // namespace nuno
