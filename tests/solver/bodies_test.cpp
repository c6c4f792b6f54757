// Cloth against rigid bodies: friction and moving bodies against closed forms, with every method.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "model/formulas.h"
#include "solver/solver_runs.h"
#include "support/bodies.h"
#include "support/body_meshes.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr double kPi = glm::pi<double>();
constexpr double kGravity = 9.81;

// A flat patch of 20 x 20 vertices, 0.2 m wide, its centre at `centre` and its sides along two unit vectors.
ClothModel patch(glm::vec3 centre, glm::vec3 across, glm::vec3 down)
{
    SheetSource sheet;
    sheet.name = "patch";
    sheet.columns = sheet.rows = 20;
    sheet.mesh = grid_mesh(20, 20, centre - 0.1f * (across + down), 0.2f * across, 0.2f * down);
    return build_cloth_model(std::span(&sheet, 1), MassLumping::area);
}

class BodyContactTest : public testing::TestWithParam<MethodAndSweep>
{
  protected:
    BodyContactTest()
    {
        params.backend = Backend::cpu;
        params.method = GetParam().method;
        params.sweep = GetParam().sweep;
        params.substeps = 20;
        params.damping = 0;
        params.thickness = 0.01f;
        // Soft, so that every method is stable; a patch that moves as one does not strain.
        params.structural_stiffness = params.shear_stiffness = params.bend_stiffness = 1e-3f;
        params.tethers = Tethers::none;
    }
    void set_friction(double mu) { params.friction = params.static_friction = static_cast<float>(mu); }
    double h() const { return double(substep_s(params)); }

    // Runs from rest, or from a velocity of every vertex.
    ClothState run(const ClothModel& model, const Bodies& bodies, double seconds, glm::vec3 velocity = {0, 0, 0})
    {
        ThreadPool pool(1);
        const auto solver = make_solver(model, bodies, params, pool);
        ClothState state = start_state(model, params);
        for (glm::vec4& v : state.velocities) v = glm::vec4(velocity, v.w);
        solver->upload(state);
        solver->step({params, 0, static_cast<int>(std::lround(seconds / h()))});
        solver->download_positions(state.positions);
        solver->download_velocities(state.velocities);
        return state;
    }

    SimParams params;
};

double furthest_from(const ClothState& state, const std::vector<glm::vec3>& places)
{
    double most = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        most = std::max(most, double(glm::distance(glm::vec3(state.positions[i]), places[i])));
    return most;
}

glm::dvec3 mean_of(const std::vector<glm::vec4>& values)
{
    glm::dvec3 sum(0);
    for (const glm::vec4& v : values) sum += glm::dvec3(v);
    return sum / double(values.size());
}

// Coulomb: on a slope of angle theta cloth slides where tan(theta) > mu, with a = g (sin theta - mu cos theta).
// Down the slope is the first of `sides`.
struct Slope
{
    explicit Slope(double theta)
        : down(std::cos(theta), -std::sin(theta), 0), normal(std::sin(theta), std::cos(theta), 0)
    {
        bodies.planes.push_back({normal, 0.3f});
        model = patch((0.3f + 0.01f) * normal, down, {0, 0, 1});
    }
    glm::vec3 down, normal;
    Bodies bodies;
    ClothModel model;
};

TEST_P(BodyContactTest, below_the_angle_of_friction_cloth_does_not_creep)
{
    for (const double mu : {0.1, 0.3, 0.6, 1.0}) {
        const Slope slope(std::atan(mu) - kPi / 90);
        set_friction(mu);
        const double creep = furthest_from(run(slope.model, slope.bodies, 2), slope.model.start_positions);
        expect_measured(
            fmt::format("slope 2 degrees below that of friction {}, {}: creep in 2 s, m", mu, name_of(GetParam())),
            creep, 0, 1e-4);
    }
}

TEST_P(BodyContactTest, above_the_angle_of_friction_cloth_slides_at_the_rate_of_coulomb)
{
    for (const double mu : {0.0, 0.1, 0.3, 0.6, 1.0}) {
        const double theta = std::atan(mu) + kPi / 90;
        const Slope slope(theta);
        set_friction(mu);
        const ClothState end = run(slope.model, slope.bodies, 2);
        const double expected = kGravity * (std::sin(theta) - mu * std::cos(theta));
        const double measured = glm::dot(mean_of(end.velocities), glm::dvec3(slope.down)) / 2;
        expect_measured(
            fmt::format("slope 2 degrees above that of friction {}, {}: acceleration, m/s2", mu, name_of(GetParam())),
            measured, expected, 0.02 * expected);
        EXPECT_NEAR(glm::dot(mean_of(end.positions), glm::dvec3(slope.normal)), 0.31, 1e-4) << "mu " << mu;
    }
}

// The slope at which cloth begins to slide, found by halving: tan(theta) = mu. Past it by 1 %, it has slid 4 mm in 0.5
// s.
TEST_P(BodyContactTest, the_slope_at_which_cloth_begins_to_slide_is_that_of_friction)
{
    const double mu = 0.3;
    set_friction(mu);
    double held = 0.9 * mu, slid = 1.1 * mu;
    for (int i = 0; i < 5; ++i) {
        const double middle = (held + slid) / 2;
        const Slope slope(std::atan(middle));
        const double way = furthest_from(run(slope.model, slope.bodies, 0.5), slope.model.start_positions);
        (way > 1e-3 ? slid : held) = middle;
    }
    expect_measured(fmt::format("slope at which cloth slides, {}: tangent", name_of(GetParam())), (held + slid) / 2, mu,
                    0.01 * mu);
}

TEST_P(BodyContactTest, static_friction_above_the_kinetic_holds_a_steeper_slope)
{
    const Slope slope(std::atan(0.5));
    params.friction = 0.3f;
    params.static_friction = 0.6f;
    EXPECT_LT(furthest_from(run(slope.model, slope.bodies, 1), slope.model.start_positions), 1e-4);
    params.static_friction = 0.1f;  // never less than the kinetic one
    EXPECT_GT(furthest_from(run(slope.model, slope.bodies, 1), slope.model.start_positions), 0.5);
}

TEST_P(BodyContactTest, on_the_flat_cloth_stops_after_v_squared_over_2_mu_g)
{
    Bodies bodies;
    bodies.planes.push_back({{0, 1, 0}, 0});
    const ClothModel model = patch({0, 0.01f, 0}, {1, 0, 0}, {0, 0, 1});
    set_friction(0.3);
    const ClothState end = run(model, bodies, 1, {2, 0, 0});
    const double expected = 2 * 2 / (2 * 0.3 * kGravity), measured = mean_of(end.positions).x;
    // First order: v0 h.
    expect_measured(fmt::format("stopping distance on the flat, {}: m", name_of(GetParam())), measured, expected,
                    2 * h());
    EXPECT_NEAR(mean_of(end.velocities).x, 0, 1e-6);
}

TEST_P(BodyContactTest, a_box_that_is_pushed_carries_cloth_as_long_as_static_friction_bears_it)
{
    // 3 s^2 - 2 s^3 over 1 m in 2 s: at most 6 / 4 m/s2, which mu g bears for mu > 0.153.
    Bodies bodies;
    bodies.boxes.push_back({{0, -0.5f, 0}, {1, 1, 1}, {1, 0, 0, 0}, {}});
    bodies.boxes[0].motion.keyframes = {{0, {0, 0, 0}}, {2, {1, 0.2, 0}}};
    const ClothModel model = patch({0, 0.01f, 0}, {1, 0, 0}, {0, 0, 1});
    std::vector<glm::vec3> carried = model.start_positions;
    for (glm::vec3& x : carried) x += glm::vec3(1, 0.2f, 0);
    set_friction(0.25);
    EXPECT_LT(furthest_from(run(model, bodies, 2.5), carried), 1e-4);
    set_friction(0.05);
    EXPECT_GT(furthest_from(run(model, bodies, 2.5), carried), 0.05);
}

TEST_P(BodyContactTest, a_turntable_turns_the_cloth_on_it)
{
    // Half a turn about y in 2 s; at r = 0.34 m (3/4 pi)^2 r + tangential needs less than mu g = 9.81.
    Bodies bodies;
    bodies.boxes.push_back({{0, -0.1f, 0}, {2, 0.2f, 2}, {1, 0, 0, 0}, {}});
    bodies.boxes[0].motion.keyframes = {{0, {}, {0, 1, 0}, 0}, {2, {}, {0, 1, 0}, kPi}};
    const ClothModel model = patch({0.2f, 0.01f, 0}, {1, 0, 0}, {0, 0, 1});
    std::vector<glm::vec3> turned = model.start_positions;
    for (glm::vec3& x : turned) x = {-x.x, x.y, -x.z};
    set_friction(1);
    EXPECT_LT(furthest_from(run(model, bodies, 2), turned), 1e-4);
}

TEST_P(BodyContactTest, no_vertex_is_left_inside_a_moving_shape)
{
    const Bodies bodies = one_of_each_shape();
    const SheetSource sheet = sheet_over_the_shapes(17);
    const ClothModel model = build_cloth_model(std::span(&sheet, 1), MassLumping::area);
    params.damping = 0.2f;
    const ClothState end = run(model, bodies, 0.4);
    const auto placed = placed_bodies(bodies);
    int touching = 0;
    for (const glm::vec4& p : end.positions) {
        const Pose sphere = pose_at(*placed[1].motion, placed[1].rest, 0.4);
        const Pose box = pose_at(*placed[3].motion, placed[3].rest, 0.4);
        const double from_sphere = glm::distance(glm::dvec3(p), sphere.position) - 0.15;
        const glm::dvec3 q = glm::transpose(box.rotation) * (glm::dvec3(p) - box.position);
        const double from_box = formulas_f64::box_surface(q, glm::dvec3(placed[3].half_size)).distance;
        EXPECT_GT(from_sphere, 0.01 - 2e-3);
        EXPECT_GT(from_box, 0.01 - 2e-3);
        touching += from_sphere < 0.011 || from_box < 0.011;
    }
    EXPECT_GT(touching, 5);
}

TEST_P(BodyContactTest, a_mesh_of_a_box_holds_cloth_as_the_box_does)
{
    const glm::vec3 size(0.6f, 0.2f, 0.6f);
    Bodies as_box, as_mesh;
    as_box.boxes.push_back({{0, -0.1f, 0}, size, {1, 0, 0, 0}, {}});
    const auto grid = std::make_shared<DistanceGrid>(make_distance_grid(box_mesh(size), 0.01f, "box"));
    as_mesh.meshes.push_back({box_mesh(size), grid, {0, -0.1f, 0}, {1, 0, 0, 0}, {}});
    const ClothModel model = patch({0.02f, 0.05f, 0.03f}, {1, 0, 0}, {0, 0, 1});
    set_friction(0.3);
    const ClothState a = run(model, as_box, 0.5, {0.5f, 0, 0}), b = run(model, as_mesh, 0.5, {0.5f, 0, 0});
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        EXPECT_LE(glm::distance(glm::vec3(a.positions[i]), glm::vec3(b.positions[i])), 1e-5f);
}

TEST_P(BodyContactTest, pins_go_with_their_handle_and_pull_the_cloth)
{
    Bodies bodies;
    bodies.handles.push_back({"hand", {}});
    bodies.handles[0].motion.keyframes = {{0, {}}, {0.5, {0, 0.3, 0}, {0, 1, 0}, 0.5}};
    SheetSource sheet = square_sheet(9, 0.4f, {});
    sheet.handle_pins = {{0, 0}, {8, 0}};
    const ClothModel model = build_cloth_model(std::span(&sheet, 1), MassLumping::area);
    params.structural_stiffness = params.shear_stiffness = 5;
    params.damping = 8;
    params.substeps = 100;
    const ClothState end = run(model, bodies, 0.5);
    const glm::quat turn = glm::angleAxis(0.5f, glm::vec3(0, 1, 0));
    for (const std::uint32_t v : {0u, 8u}) {
        const glm::vec3 expected = turn * model.start_positions[v] + glm::vec3(0, 0.3f, 0);
        EXPECT_LE(glm::distance(glm::vec3(end.positions[v]), expected), 1e-6f);
        EXPECT_LE(glm::length(glm::vec3(end.velocities[v])), 0.05f) << "at rest in a keyframe";
        EXPECT_EQ(end.positions[v].w, 0);
    }
    EXPECT_GT(mean_of(end.positions).y, -0.4) << "fell without the pins";
}

std::vector<MethodAndSweep> all_but_the_reference()
{
    std::vector<MethodAndSweep> all = methods_and_sweeps();
    std::erase_if(all, [](const MethodAndSweep& each) { return each.method == Method::reference; });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Methods, BodyContactTest, testing::ValuesIn(all_but_the_reference()), kMethodName);

}  // namespace
}  // namespace nuno
