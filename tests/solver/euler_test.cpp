// Euler on the CPU against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/method_table.h"
#include "support/sheets.h"

namespace nuno {
namespace {

const Colliders kNoColliders;

SimParams on_cpu(Method method)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.method = method;
    params.frame_rate = 1;
    return params;
}

// So soft that explicit Euler, too, is stable at the substeps used here.
void soften(SimParams& params) { params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = 1e-3f; }

ClothState run(const ClothModel& model, const SimParams& params, ClothState state, int substeps)
{
    ThreadPool pool(1);
    const auto solver = make_solver(model, kNoColliders, params, pool);
    solver->upload(state);
    solver->step({params, 0, substeps});
    solver->download_positions(state.positions);
    solver->download_velocities(state.velocities);
    return state;
}

// A triangle whose upper corners are pinned; its lower one swings in y on two springs.
ClothModel pendulum_triangle(float half_width, float depth)
{
    SheetSource source;
    source.mesh.positions = {{-half_width, 0, 0}, {half_width, 0, 0}, {0, -depth, 0}};
    source.mesh.uvs.resize(3);
    source.mesh.faces = {{0, 2, 1}};
    source.pins = {0, 1};
    return build_cloth_model(std::span(&source, 1), MassLumping::equal);
}

int order_of(Method method)
{
    for (const MethodInfo& info : method_table())
        if (info.method == method) return info.order;
    return 0;
}

class EulerTest : public testing::TestWithParam<Method>
{};

// v(t) = (m g / c) (1 - e^(-c t / m)), y(t) = (m g / c) (t - (m / c) (1 - e^(-c t / m))); halving h
// divides the error by 2 to the order of the method.
TEST_P(EulerTest, free_fall_with_drag_follows_the_closed_form_at_the_order_of_the_method)
{
    const ClothModel model = square_cloth(10, 1);
    SimParams params = on_cpu(GetParam());
    params.damping = 0.3f;
    soften(params);
    const double rate = 0.3 / 0.2, g = -9.81;  // c / m [1/s]
    const double speed = g / rate * (1 - std::exp(-rate)), fall = g / rate * (1 - (1 - std::exp(-rate)) / rate);
    double speed_errors[2], fall_errors[2];
    for (int i = 0; i < 2; ++i) {
        params.substeps = 100 << i;
        const ClothState start = start_state(model, params), end = run(model, params, start, params.substeps);
        speed_errors[i] = std::abs(double(end.velocities[37].y) - speed);
        fall_errors[i] = std::abs(double(end.positions[37].y - start.positions[37].y) - fall);
    }
    const double expected = std::pow(2, order_of(GetParam()));
    EXPECT_NEAR(speed_errors[0] / speed_errors[1], expected, 0.05);
    EXPECT_NEAR(fall_errors[0] / fall_errors[1], expected, 0.05);
    EXPECT_LT(speed_errors[1] / std::abs(speed), 0.01);
}

TEST_P(EulerTest, a_sheet_in_free_fall_keeps_its_shape)
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

TEST_P(EulerTest, momentum_without_outer_forces_is_kept)
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
    glm::dvec3 momentum(0), motion(0);
    for (const glm::vec4& v : end.velocities)
        for (int c = 0; c < 3; ++c) momentum[c] += double(v[c]), motion[c] += std::abs(double(v[c]));
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(motion[c], 0.01);
        EXPECT_LT(std::abs(momentum[c]), 1e-4 * motion[c]);
    }
}

// So that a new method is tested without being named here.
std::vector<Method> every_method()
{
    std::vector<Method> methods;
    for (const MethodInfo& info : method_table())
        if (info.on_cpu) methods.push_back(info.method);
    return methods;
}

INSTANTIATE_TEST_SUITE_P(Methods, EulerTest, testing::ValuesIn(every_method()));

// Along y the two springs act as k_eff = 2 k (depth / length)^2; symplectic Euler oscillates at (2 / h) asin(omega h /
// 2).
TEST(SymplecticEuler, a_mass_on_springs_swings_with_the_period_of_theory)
{
    const float half_width = 0.3f, depth = 0.4f;
    const ClothModel model = pendulum_triangle(half_width, depth);
    SimParams params = on_cpu(Method::symplectic_euler);
    params.structural_stiffness = 20;
    params.gravity_y = params.damping = 0;
    params.substeps = 2000;
    const double h = double(substep_s(params)), mass = double(model.areas[2]) * 0.2;
    const double omega = std::sqrt(2 * 20 * 0.64 / mass), period = 2 * M_PI / (2 / h * std::asin(omega * h / 2));
    ClothState state = start_state(model, params);
    const float rest = state.positions[2].y;
    state.positions[2].y -= 1e-3f;
    int crossings = 0;
    double last = 0, first = 0;
    for (int step = 1; crossings < 41; ++step) {
        const float before = state.positions[2].y - rest;
        state = run(model, params, state, 1);
        const float after = state.positions[2].y - rest;
        if ((before < 0) == (after < 0)) continue;
        last = (step - double(after) / double(after - before)) * h;
        if (crossings++ == 0) first = last;
    }
    // 40 crossings are 20 periods. The spring's third-order term shortens them by less than (1e-3 / 0.5)^2.
    EXPECT_NEAR((last - first) / 20, period, 2e-4 * period);
}

// Explicit Euler multiplies the amplitude by sqrt(1 + (omega h)^2) each substep (accuracy: |lambda|^2 = 1 + W^2).
TEST(ExplicitEuler, undamped_it_gains_energy_as_theory_says)
{
    const ClothModel model = pendulum_triangle(0.3f, 0.4f);
    SimParams params = on_cpu(Method::explicit_euler);
    params.structural_stiffness = 20;
    params.gravity_y = params.damping = 0;
    params.substeps = 1000;
    const double h = double(substep_s(params)), mass = double(model.areas[2]) * 0.2, k = 2 * 20 * 0.64;
    const double w = std::sqrt(k / mass) * h;
    ClothState state = start_state(model, params);
    const double rest = double(state.positions[2].y);
    state.positions[2].y += 1e-4f;
    const auto energy = [&](const ClothState& s) {
        const double y = double(s.positions[2].y) - rest, v = double(s.velocities[2].y);
        return 0.5 * k * y * y + 0.5 * mass * v * v;
    };
    const double before = energy(state);
    const double after = energy(run(model, params, state, 300));
    EXPECT_NEAR(std::log(after / before), 300 * std::log1p(w * w), 0.02 * 300 * std::log1p(w * w));
}

TEST(MethodTable, every_method_has_a_name_a_backend_and_a_solver)
{
    const ClothModel model = square_cloth(3, 1);
    ThreadPool pool(1);
    ASSERT_EQ(method_table().size(), choice_names(Method{}).size());
    for (const MethodInfo& info : method_table()) {
        EXPECT_EQ(info.name, choice_names(Method{})[std::size_t(info.method)]);
        ASSERT_TRUE(info.on_cpu);
        const auto solver = make_solver(model, kNoColliders, on_cpu(info.method), pool);
        EXPECT_EQ(solver->name(), std::string(info.name) + " on cpu");
    }
}

}  // namespace
}  // namespace nuno
