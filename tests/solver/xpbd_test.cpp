// Small-step XPBD: one spring, the order of its steps, what it keeps, and that no layout changes the physics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "model/force_model.h"
#include "solver/solver_runs.h"
#include "solver/xpbd/by_lanes.h"
#include "solver/xpbd/cpu_xpbd.h"

namespace nuno {
namespace {

void shake(ClothState& state, float size)
{
    std::mt19937 random(2);
    std::normal_distribution<float> at(0, size);
    for (glm::vec4& p : state.positions)
        if (p.w > 0) p += glm::vec4(at(random), at(random), at(random), 0);
}

// Orders of the constraints: rows of a grid, colours of one, and stars of a mesh that is none.
enum class Order
{
    rows,
    coloured,
    stars
};

class XpbdTest : public testing::TestWithParam<Order>
{
  protected:
    static SimParams xpbd()
    {
        return on_cpu(Method::xpbd, GetParam() == Order::rows       ? Sweep::rows
                                    : GetParam() == Order::coloured ? Sweep::coloured
                                                                    : Sweep::automatic);
    }
    // A sheet of columns x rows in cells of this width and height.
    static ClothModel sheet(int columns, int rows, glm::vec2 cell, std::vector<std::uint32_t> pins, MassLumping lumping)
    {
        SheetSource source;
        source.mesh =
            grid_mesh(columns, rows, {0, 0, 0}, {cell.x * float(columns - 1), 0, 0}, {0, -cell.y * float(rows - 1), 0});
        if (GetParam() == Order::stars) {
            source.mesh = cut_at_random(source.mesh, columns, rows);
        } else {
            source.columns = columns;
            source.rows = rows;
        }
        source.pins = std::move(pins);
        return build_cloth_model(std::span(&source, 1), lumping);
    }
    static ClothModel square(int count, float side, std::vector<std::uint32_t> pins = {},
                             MassLumping lumping = MassLumping::equal)
    {
        return sheet(count, count, glm::vec2(side / float(count - 1)), std::move(pins), lumping);
    }
};
INSTANTIATE_TEST_SUITE_P(Orders, XpbdTest, testing::Values(Order::rows, Order::coloured, Order::stars),
                         [](const testing::TestParamInfo<Order>& order) {
                             return order.param == Order::rows       ? "rows"
                                    : order.param == Order::coloured ? "coloured"
                                                                     : "stars";
                         });

// Two faces whose only stiff spring is the one across their edge. With step s = 2 h / 3, BDF2 of x'' = -k w (x - l0) is
//     y = (4 x0 - x_last) / 3 + s (4 v0 - v_last) / 3,   x1 - l0 = (y - l0) / (1 + s^2 k w),   v1 = v' + (x1 - y) / s,
// and its first substep takes x_last = x0 - h v0, v_last = v0.
TEST(Xpbd, one_spring_follows_the_second_order_backward_difference)
{
    SheetSource source;
    source.mesh.positions = {{0, 0, 0}, {1, 0.5f, 0}, {1, -0.5f, 0}, {2, 0, 0}};
    source.mesh.uvs.resize(4);
    source.mesh.faces = {{0, 2, 1}, {1, 2, 3}};
    source.pins = {0};
    const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::equal);
    SimParams params = on_cpu(Method::xpbd, Sweep::coloured);
    params.structural_stiffness = 0;
    params.gravity_y = params.damping = 0;
    for (const float stiffness : {1.0f, 1e3f, 1e7f}) {
        params.bend_stiffness = stiffness;
        params.substeps = 100;
        const double h = 0.01, s = 2 * h / 3, k = double(stiffness);
        ClothState state = start_state(model, params);
        const double w = double(state.positions[3].w);
        state.positions[3].x += 0.1f;
        double x = double(state.positions[3].x), v = 0, x_last = x, v_last = 0;
        for (int step = 1; step <= 50; ++step) {
            const double v1 = (4 * v - v_last) / 3, y = (4 * x - x_last) / 3 + s * v1;
            x_last = x, v_last = v;
            x = 2 + (y - 2) / (1 + s * s * k * w);
            v = v1 + (x - y) / s;
            if (step % 10 != 0) continue;
            const ClothState end = run(model, params, state, step);
            // Each substep rounds x, near 2, to 1.2e-7, and the root is good to 6e-7 of 2.
            EXPECT_NEAR(double(end.positions[3].x), x, step * 2e-6) << stiffness << ", substep " << step;
        }
    }
}

// In a short substep from a state without a past, v1 = v0 + h g + (2 h / 3) f / m with the forces of springs and plates
// at v = 0; what is left falls with h.
TEST_P(XpbdTest, a_short_substep_adds_the_forces_of_springs_and_plates)
{
    for (const auto& [columns, rows] : {std::pair{10, 10}, {23, 5}, {60, 7}, {3, 40}}) {
        const ClothModel model = sheet(columns, rows, {0.05f, 0.04f}, {1}, MassLumping::area);
        SimParams params = xpbd();
        params.internal_model = InternalModel::fabric_springs;
        params.warp_stiffness = 30, params.weft_stiffness = 50, params.shear_modulus = 10;
        params.bending_warp = 1e-3f, params.bending_weft = 2e-3f, params.bending_bias = 3e-3f;
        params.damping = 0;
        params.substeps = 5000;
        ClothState state = start_state(model, params);
        shake(state, 2e-3f);
        std::vector<glm::dvec3> x, v(state.positions.size()), force(state.positions.size());
        for (const glm::vec4& p : state.positions) x.emplace_back(p);
        const ForceModel forces(model, params);
        forces.forces(x, v, 0, force);
        const ClothState end = run(model, params, state, 1);
        const double h = double(substep_s(params)), g = double(params.gravity_y);
        double worst = 0, scale = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (state.positions[i].w == 0) continue;
            const double m = forces.mass(static_cast<std::uint32_t>(i));
            const glm::dvec3 springs = force[i] / m - glm::dvec3(0, g, 0);
            const glm::dvec3 expected = h * glm::dvec3(0, g, 0) + 2 * h / 3 * springs;
            scale = std::max(scale, glm::length(expected));
            worst = std::max(worst, glm::length(glm::dvec3(end.velocities[i]) - expected));
        }
        // A stiff spring is taken implicitly: its force is smaller by the share s^2 k / m, here up to 2 %.
        EXPECT_LT(worst, 0.05 * scale) << columns << " x " << rows;
    }
}

// x(t) = v t + g t^2 / 2 is a solution that BDF2 reproduces; the first substep takes x_last = x0 - h v0, which is
// g h^2 / 2 off, and leaves half of that.
TEST_P(XpbdTest, free_fall_is_exact_but_for_the_first_substep)
{
    const ClothModel model = square(20, 1);
    SimParams params = xpbd();
    params.damping = 0;
    // So soft that the springs do not answer the rounding of positions.
    params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = 1e-3f;
    params.substeps = 600;
    const ClothState start = start_state(model, params), end = run(model, params, start, 600);
    const double h = 1.0 / 600;
    for (std::size_t v = 0; v < start.positions.size(); ++v) {
        EXPECT_NEAR(double(end.velocities[v].y), -9.81, 1e-4);
        EXPECT_NEAR(double(end.positions[v].y - start.positions[v].y), -9.81 / 2, 9.81 * h * h + 3e-5);
        EXPECT_NEAR(double(end.positions[v].x), double(start.positions[v].x), 2e-5);
    }
}

TEST_P(XpbdTest, momentum_without_outer_forces_is_kept)
{
    const ClothModel model = square(40, 1, {}, MassLumping::area);
    SimParams params = xpbd();
    params.gravity_y = params.damping = 0;
    params.structural_stiffness = 1e4f;
    params.substeps = 600;
    ClothState state = start_state(model, params);
    shake(state, 0.005f);
    const ClothState end = run(model, params, state, 50);
    const Momentum left = momentum(end);
    EXPECT_GT(left.size, 1e-3);
    EXPECT_LT(glm::length(left.sum), 1e-3 * left.size);
}

// The products of projections of a sweep and its reverse have real eigenvalues in 0 .. 1: nothing grows, however stiff
// the springs and wherever the pins.
TEST_P(XpbdTest, no_energy_is_gained_however_stiff_the_springs)
{
    for (const std::vector<std::uint32_t>& pins :
         {std::vector<std::uint32_t>{}, {0, 47}, {47 * 48, 48 * 48 - 1}, {0, 47 * 48}})
        for (const float stiffness : {10.0f, 1e4f, 1e8f}) {
            const ClothModel model = square(48, 1, pins);
            SimParams params = xpbd();
            params.gravity_y = params.damping = 0;
            params.structural_stiffness = params.shear_stiffness = stiffness;
            params.bend_stiffness = stiffness / 50;
            params.substeps = 300;
            ClothState state = start_state(model, params);
            std::mt19937 random(3);
            std::normal_distribution<float> at(0, 0.1f);
            for (std::size_t v = 0; v < state.velocities.size(); ++v)
                if (state.positions[v].w > 0) state.velocities[v] += glm::vec4(at(random), at(random), at(random), 0);
            const double before = kinetic_energy(state);
            for (const int substeps : {5, 50, 200})
                EXPECT_LT(kinetic_energy(run(model, params, state, substeps)), before)
                    << stiffness << ", " << substeps << " substeps, " << pins.size() << " pins";
        }
}

std::uint64_t hash_of_run(const ClothModel& model, const SimParams& params, ClothState state, int threads, int lanes)
{
    ThreadPool pool(threads);
    CpuXpbd solver(model, kNoBodies, params, pool, lanes);
    solver.upload(state);
    solver.step({params, 0, 21});
    return state_hash(state_of(solver, model));
}

TEST_P(XpbdTest, threads_and_widths_of_vectors_change_no_bit)
{
    const ClothModel model = square(70, 2, {0, 69}, MassLumping::area);
    SimParams params = xpbd();
    params.tethers = Tethers::pins;
    params.structural_stiffness = 1e4f;
    params.bending_warp = params.bending_weft = params.bending_bias = 1e-4f;
    params.substeps = 300;
    ClothState start = start_state(model, params);
    shake(start, 1e-3f);
    for (const float limit : {0.0f, 0.05f}) {
        params.strain_limit = limit;
        const std::uint64_t expected = hash_of_run(model, params, start, 1, 4);
        for (const int threads : {1, 2, 3})
            for (int lanes = 4; lanes <= machine_lanes(); lanes *= 2)
                EXPECT_EQ(hash_of_run(model, params, start, threads, lanes), expected)
                    << threads << " threads, " << lanes << " lanes, limit " << limit;
    }
}

TEST(Xpbd, rows_and_colours_hang_the_same_cloth)
{
    for (const auto& [columns, rows] : {std::pair{17, 17}, {40, 12}, {5, 33}, {2, 2}}) {
        SheetSource source;
        source.mesh = grid_mesh(columns, rows, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
        source.columns = columns;
        source.rows = rows;
        source.pins = {0, static_cast<std::uint32_t>(columns) - 1};
        const ClothModel model = build_cloth_model(std::span(&source, 1), MassLumping::area);
        ClothState ends[2];
        for (const Sweep sweep : {Sweep::rows, Sweep::coloured}) {
            SimParams params = on_cpu(Method::xpbd, sweep);
            params.tethers = Tethers::pins;
            params.structural_stiffness = 500;
            params.shear_stiffness = 250;
            params.gravity_z = 1;
            params.substeps = 1200;
            ends[sweep == Sweep::coloured] = run(model, params, start_state(model, params), 600);
        }
        EXPECT_LT(rms_distance(ends[0], ends[1]), 5e-3) << columns << " x " << rows;
    }
}

TEST_P(XpbdTest, a_held_vertex_stays_and_its_tethers_follow_it)
{
    const ClothModel model = square(24, 1, {0});
    SimParams params = xpbd();
    params.tethers = Tethers::pins;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.substeps = 600;
    ThreadPool pool(1);
    CpuXpbd solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    solver.upload(state);
    const std::uint32_t held = 24 * 24 - 1;
    const glm::vec4 from = state.positions[held];
    glm::vec4 place = from;
    for (int frame = 1; frame <= 60; ++frame) {
        place = from + glm::vec4(0, 0.5f, 0.7f, 0) * (float(frame) / 60);
        place.w = 0;
        solver.set_vertex(held, place);
        solver.step({params, frame / 60.0, 10});
    }
    solver.download_positions(state.positions);
    EXPECT_EQ(state.positions[held], place);
    double longest = 0;
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v)
        for (const std::uint32_t anchor : {0u, held}) {
            const double rest = double(glm::distance(model.rest_positions[v], model.rest_positions[anchor]));
            const double now = double(glm::distance(glm::vec3(state.positions[v]), glm::vec3(state.positions[anchor])));
            if (rest > 0.2) longest = std::max(longest, now / rest);
        }
    EXPECT_LT(longest, 1.01);
}

TEST_P(XpbdTest, a_strain_limit_holds_soft_springs)
{
    const ClothModel model = square(12, 1, {0, 11});
    double stretch[2];
    for (const bool limited : {false, true}) {
        SimParams params = xpbd();
        params.structural_stiffness = 20;
        params.shear_stiffness = 10;
        params.strain_limit = limited ? 0.02f : 0;
        params.damping = 1;
        params.substeps = 1200;
        const ClothState end = run(model, params, start_state(model, params), 2400);
        stretch[limited] = largest_thread_strain(model, end);
    }
    EXPECT_GT(stretch[0], 0.1);
    EXPECT_LT(stretch[1], 0.025);
}

}  // namespace
}  // namespace nuno
