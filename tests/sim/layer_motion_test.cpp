// Layers that rest, slide and part at `guaranteed`: contact takes nothing that Coulomb does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "sim/simulation.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr double kGravity = 9.81;

SheetSpec sheet(const std::string& name, int columns, int rows, glm::vec3 origin, glm::vec3 across, glm::vec3 down)
{
    SheetSpec spec;
    spec.name = spec.where = name;
    spec.columns = columns;
    spec.rows = rows;
    spec.origin = origin;
    spec.across = across;
    spec.down = down;
    return spec;
}

// A handle that goes `move` [m] in a second at constant speed, from the start on.
Handle steady_handle(glm::dvec3 move)
{
    Handle handle;
    handle.name = "hand";
    handle.motion.keyframes = {{0, {0, 0, 0}}, {1, move}};
    handle.motion.easing = Easing::linear;
    return handle;
}

SimParams make_params(float friction)
{
    SimParams params;
    params.backend = Backend::cpu;
    params.threads = 1;
    params.method = Method::xpbd;
    params.substeps = 20;
    params.structural_stiffness = 400;
    params.shear_stiffness = 80;
    params.bend_stiffness = 4;
    params.damping = 0;
    params.thickness = 0.005f;
    params.friction = params.static_friction = friction;
    params.collision = CollisionLevel::guaranteed;
    return params;
}

glm::dvec3 middle(Simulation& simulation, std::size_t number)
{
    const Sheet& of = simulation.model().sheets[number];
    glm::dvec3 sum(0);
    for (std::uint32_t v = 0; v < of.vertex_count; ++v)
        sum += glm::dvec3(simulation.state().positions[of.first_vertex + v]);
    return sum / double(of.vertex_count);
}

// How far a small sheet that lies on a large one is carried along [m] where that goes at 1 m/s for half a second.
double carried_way(float friction)
{
    Scene scene;
    scene.name = "slide";
    scene.params = make_params(friction);
    scene.sheets = {sheet("lower", 41, 17, {-0.5f, 0, -0.2f}, {1.4f, 0, 0}, {0, 0, 0.4f}),
                    sheet("upper", 13, 13, {0.1f, 0.0051f, -0.15f}, {0.3f, 0, 0}, {0, 0, 0.3f})};
    PinSpec all;
    all.where = "lower";
    all.handle = "hand";
    for (std::uint32_t v = 0; v < 41 * 17; ++v) all.vertices.push_back(v);
    scene.sheets[0].pins = {all};
    scene.bodies.handles = {steady_handle({-1, 0, 0})};
    scene.params.count_pass_through = true;
    Simulation simulation(scene, scene.params);
    const double start = middle(simulation, 1).x;
    std::uint64_t contacts = 0, unresolved = 0;
    for (int frame = 0; frame < 30; ++frame) {
        const CollisionCounts count = simulation.advance_frame().count;
        contacts += count.contacts;
        unresolved += count.unresolved;
    }
    EXPECT_GT(contacts, 1000u);
    EXPECT_EQ(unresolved, 0u);
    EXPECT_GT(middle(simulation, 1).y, 0.6 * double(scene.params.thickness));
    return start - middle(simulation, 1).x;
}

TEST(LayerMotion, layers_without_friction_slide_freely)
{
    const double carried = carried_way(0);
    EXPECT_LT(std::abs(carried), 0.05 * 0.5) << "of 0.5 m";
    expect_measured("sliding without friction: relative way [m]", 0.5 - carried, 0.5, 0.025);
}

// Until the speeds are equal the upper sheet is carried by mu g t^2 / 2.
TEST(LayerMotion, layers_with_friction_slide_as_coulomb_says)
{
    const double expected = 0.5 * 0.1 * kGravity * 0.25;
    expect_measured("sliding with friction 0.1: carried [m]", carried_way(0.1f), expected, 0.1 * expected);
}

// Pulled off by one side at 1 m/s without gravity, the sheet moves as if there were no other.
TEST(LayerMotion, layers_peel_off_freely)
{
    const auto pulled = [](CollisionLevel level) {
        Scene scene;
        scene.name = "peel";
        scene.params = make_params(0.3f);
        scene.params.gravity_y = 0;
        scene.params.collision = level;
        scene.sheets = {sheet("lower", 17, 17, {0, 0, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}),
                        sheet("upper", 17, 17, {0, 0.0051f, 0}, {0.4f, 0, 0}, {0, 0, 0.4f})};
        PinSpec all, side;
        all.where = side.where = "sheet";
        for (std::uint32_t v = 0; v < 17 * 17; ++v) all.vertices.push_back(v);
        side.handle = "hand";
        side.places = {"left"};
        scene.sheets[0].pins = {all};
        scene.sheets[1].pins = {side};
        scene.bodies.handles = {steady_handle({0.3, 1, 0})};
        Simulation simulation(scene, scene.params);
        for (int frame = 0; frame < 18; ++frame) simulation.advance_frame();
        return middle(simulation, 1).y;
    };
    const double free = pulled(CollisionLevel::none);
    expect_measured("peeling: height of the middle [m]", pulled(CollisionLevel::guaranteed), free, 0.05 * free);
}

// Three sheets fall on the floor and on one another.
TEST(LayerMotion, a_stack_comes_to_rest)
{
    Scene scene;
    scene.name = "rest";
    scene.params = make_params(0.3f);
    scene.params.damping = 0.05f;
    for (int i = 0; i < 3; ++i)
        scene.sheets.push_back(sheet("sheet " + std::to_string(i), 17, 17,
                                     {0.02f * float(i), 0.02f + 0.02f * float(i), 0.01f * float(i)}, {0.4f, 0, 0},
                                     {0, 0, 0.4f}));
    scene.bodies.planes.emplace_back();
    Simulation simulation(scene, scene.params);
    double most = 0;
    std::vector<glm::vec4> last;
    float largest_step = 0;
    for (int frame = 0; frame < 180; ++frame) {
        simulation.advance_frame();
        most = std::max(most, simulation.diagnostics().kinetic_j);
        const std::vector<glm::vec4>& now = simulation.state().positions;
        if (frame >= 150)
            for (std::size_t v = 0; v < now.size(); ++v)
                largest_step = std::max(largest_step, glm::length(glm::vec3(now[v] - last[v])));
        last = now;
    }
    EXPECT_LT(simulation.diagnostics().kinetic_j, 0.01 * most) << "of " << most << " J";
    EXPECT_LT(largest_step, 0.03f * scene.params.thickness) << "a frame: it lies still";
    std::printf("at rest: %.2g of %.2g J, %.2g mm a frame\n", simulation.diagnostics().kinetic_j, most,
                1000 * double(largest_step));
}

}  // namespace
}  // namespace nuno
