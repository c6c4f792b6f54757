// Contacts between layers, as solvers keep them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include <glm/geometric.hpp>

#include "model/formulas.h"
#include "solver/base/contact_colours.h"
#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr float kThickness = 0.01f;

// Two faces of three vertices each, one `height` above the other; the upper one's middle over the lower one.
ClothModel two_faces(float height)
{
    SheetSource lower, upper;
    lower.name = "lower";
    lower.mesh.positions = {{-3, 0, -2}, {3, 0, -2}, {0, 0, 4}};
    lower.mesh.faces = {{0, 2, 1}};
    lower.pins = {0, 1, 2};
    upper.name = "upper";
    upper.mesh.positions = {{-0.1f, height, -0.1f}, {0.1f, height, -0.1f}, {0, height, 0.1f}};
    upper.mesh.faces = {{0, 2, 1}};
    const std::vector<SheetSource> sheets{lower, upper};
    return build_cloth_model(sheets, MassLumping::area);
}

// Each vertex of the upper face over the lower one.
std::vector<LayerContact> resting_contacts()
{
    std::vector<LayerContact> contacts;
    for (std::uint32_t v = 3; v < 6; ++v)
        contacts.push_back({{v, 0, 1, 2}, {0, 1, 0}, CONTACT_VERTEX_FACE, kThickness});
    return contacts;
}

SimParams layer_params(Method method, float friction)
{
    SimParams params = on_cpu(method);
    params.frame_rate = 60;
    params.substeps = 20;
    params.structural_stiffness = 50;
    params.shear_stiffness = params.bend_stiffness = 0;
    params.damping = 0;
    params.wind_strength = 0;
    params.friction = params.static_friction = friction;
    return params;
}

// The upper face after so many substeps from this velocity on, all of its contacts kept.
ClothState slide(const ClothModel& model, const SimParams& params, glm::vec3 velocity, int substeps)
{
    ThreadPool pool(1);
    const auto solver = make_solver(model, kNoBodies, params, pool);
    ClothState state = start_state(model, params);
    for (std::size_t v = 3; v < 6; ++v) state.velocities[v] = glm::vec4(velocity, state.velocities[v].w);
    solver->upload(state);
    solver->set_contacts(resting_contacts(), model.vertex_count(), ContactOrder::steady);
    for (int k = 0; k < substeps; ++k) {
        solver->step({params, k * double(substep_s(params)), 1});
        solver->keep_contacts(params);
    }
    return state_of(*solver, model);
}

std::vector<Method> all_methods()
{
    return methods_that([](const MethodInfo&) { return true; });
}

TEST(LayerContacts, a_face_comes_to_rest_at_the_thickness_above_another)
{
    const ClothModel model = two_faces(kThickness);
    for (const Method method : all_methods()) {
        const ClothState end = slide(model, layer_params(method, 0), {0, 0, 0}, 120);
        for (std::size_t v = 3; v < 6; ++v) {
            EXPECT_NEAR(end.positions[v].y, kThickness, 2e-5f) << name_of(method);
            EXPECT_LT(std::abs(end.velocities[v].y), 0.05f) << name_of(method);
        }
    }
}

// Coulomb: a layer that slides at v loses mu g t, and so goes v t - mu g t^2 / 2 until it stands.
TEST(LayerContacts, a_sliding_face_is_slowed_as_coulomb_says)
{
    const ClothModel model = two_faces(kThickness);
    const int substeps = 120;
    for (const Method method : all_methods())
        for (const double friction : {0.0, 0.2, 0.5}) {
            const SimParams params = layer_params(method, float(friction));
            const double t = substeps * double(substep_s(params)), g = 9.81, v = 1;
            const double moving = friction > 0 ? std::min(t, v / (friction * g)) : t;
            const double expected = v * moving - friction * g * moving * moving / 2;
            const ClothState end = slide(model, params, {float(v), 0, 0}, substeps);
            expect_measured(fmt::format("way of a sliding layer, {}, mu {}: m", name_of(method), friction),
                            double(end.positions[5].x), expected, 0.02 * expected);
        }
}

// However short the substeps: what is too near parts at the speed that is allowed, not faster.
TEST(LayerContacts, layers_that_start_too_near_part_without_a_kick)
{
    const ClothModel model = two_faces(0.2f * kThickness);
    for (const Method method : all_methods())
        for (const int substeps : {10, 40, 160}) {
            SimParams params = layer_params(method, 0);
            params.substeps = substeps;
            params.gravity_y = 0;
            const ClothState end = slide(model, params, {0, 0, 0}, substeps / 5);
            for (std::size_t v = 3; v < 6; ++v) {
                EXPECT_GT(end.velocities[v].y, 0.0f) << name_of(method);
                EXPECT_LT(end.velocities[v].y, 0.06f) << name_of(method) << " " << substeps;
            }
        }
}

TEST(LayerContacts, a_face_that_leaves_is_not_held_back)
{
    const ClothModel model = two_faces(kThickness);
    SimParams params = layer_params(Method::xpbd, 0.5f);
    params.gravity_y = 0;
    const ClothState end = slide(model, params, {0, 1, 0}, 60);
    for (std::size_t v = 3; v < 6; ++v) EXPECT_NEAR(end.positions[v].y, kThickness + 60 * substep_s(params), 1e-4f);
}

TEST(LayerContacts, a_fast_face_is_stopped_by_a_contact_that_remembers_its_side)
{
    const ClothModel model = two_faces(0.05f);
    for (const Method method : all_methods()) {
        const ClothState end = slide(model, layer_params(method, 0), {0, -60, 0}, 60);
        for (std::size_t v = 3; v < 6; ++v) EXPECT_GT(end.positions[v].y, 0.0f) << name_of(method);
    }
}

TEST(ContactColours, no_colour_has_a_vertex_twice_and_none_is_lost)
{
    std::mt19937 random(7);
    std::vector<LayerContact> contacts;
    for (int i = 0; i < 3000; ++i) {
        std::set<std::uint32_t> vertices;
        while (vertices.size() < 4) vertices.insert(random() % 40);
        auto v = vertices.begin();
        const std::uint32_t a = *v++, b = *v++, c = *v++, d = *v;
        contacts.push_back({{a, b, c, d}, {0, 0, 1}, float(i), 0.01f});
    }
    const ContactColours colours = colour_contacts(contacts, 40, ContactOrder::steady);
    ASSERT_EQ(colours.contacts.size(), contacts.size());
    EXPECT_GT(colours.starts.size(), 65u) << "more colours than one mask has bits";
    std::set<float> numbers;
    for (std::size_t colour = 0; colour + 1 < colours.starts.size(); ++colour) {
        std::set<std::uint32_t> vertices;
        for (std::uint32_t i = colours.starts[colour]; i < colours.starts[colour + 1]; ++i) {
            numbers.insert(colours.contacts[i].kind);
            for (int corner = 0; corner < 4; ++corner)
                EXPECT_TRUE(vertices.insert(colours.contacts[i].vertices[corner]).second);
        }
    }
    EXPECT_EQ(numbers.size(), contacts.size());
}

// Layers at rest quiver where contacts are answered in another order in every pass.
TEST(ContactColours, few_contacts_that_come_or_go_leave_the_others_as_they_were)
{
    std::mt19937 random(13);
    std::vector<LayerContact> contacts;
    for (int i = 0; i < 2000; ++i) {  // each vertex in about 16 of them
        const std::uint32_t a = random() % 496;
        contacts.push_back(
            {{a, a + 1 + random() % 4, a + 5 + random() % 4, a + 9 + random() % 4}, {0, 0, 1}, 0, 0.01f});
        contacts.back().normal.x = float(i);
    }
    const auto colours_of = [](std::span<const LayerContact> some) {
        const ContactColours colours = colour_contacts(some, 512, ContactOrder::steady);
        std::map<float, std::uint32_t> colour_of;
        for (std::uint32_t colour = 0; colour + 1 < colours.starts.size(); ++colour)
            for (std::uint32_t i = colours.starts[colour]; i < colours.starts[colour + 1]; ++i)
                colour_of[colours.contacts[i].normal.x] = colour;
        return colour_of;
    };
    const auto before = colours_of(contacts);
    for (const std::size_t gone : {0, 700, 1999}) {
        std::vector<LayerContact> fewer = contacts;
        fewer.erase(fewer.begin() + std::ptrdiff_t(gone));
        int changed = 0;
        for (const auto& [number, colour] : colours_of(fewer)) changed += before.at(number) != colour;
        EXPECT_LT(changed, 20) << gone;
    }
}

TEST(ContactColours, none_is_empty)
{
    std::vector<LayerContact> contacts;
    for (std::uint32_t i = 0; i < 5; ++i) contacts.push_back({{i, i + 10, i + 20, i + 30}, {0, 0, 1}, 0, 0.01f});
    const ContactColours colours = colour_contacts(contacts, 40, ContactOrder::steady);
    for (std::size_t colour = 0; colour + 1 < colours.starts.size(); ++colour)
        EXPECT_LT(colours.starts[colour], colours.starts[colour + 1]);
    EXPECT_EQ(colours.starts.back(), 5u);
    EXPECT_EQ(colour_contacts({}, 40, ContactOrder::first_free).starts.size(), 1u);
}

// The least distance over a fine net of points of both sides, which is never below the true one.
double sampled_distance(float kind, const glm::dvec3 (&x)[4])
{
    double least = INFINITY;
    constexpr int kNet = 60;
    for (int i = 0; i <= kNet; ++i)
        for (int j = 0; j <= kNet; ++j) {
            const double s = double(i) / kNet, t = double(j) / kNet;
            if (kind == CONTACT_EDGE_EDGE)
                least = std::min(least, glm::length(x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2])));
            else if (s + t <= 1)
                least = std::min(least, glm::length(x[0] - x[1] - s * (x[2] - x[1]) - t * (x[3] - x[1])));
        }
    return least;
}

TEST(ClosestPoints, are_no_further_than_any_of_a_net_of_points)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-1, 1);
    for (const float kind : {CONTACT_VERTEX_FACE, CONTACT_EDGE_EDGE})
        for (int n = 0; n < 400; ++n) {
            glm::dvec3 x[4];
            for (glm::dvec3& p : x) p = {place(random), place(random), place(random)};
            if (n % 5 == 0) x[3] = x[2];                                                     // no area, a point
            if (n % 7 == 0 && kind == CONTACT_EDGE_EDGE) x[3] = x[2] + 0.5 * (x[1] - x[0]);  // parallel edges
            const formulas_f64::ClosestPoints c = formulas_f64::closest_of_layers(kind, x[0], x[1], x[2], x[3]);
            const glm::dvec3 sum = c.w0 * x[0] + c.w1 * x[1] + c.w2 * x[2] + c.w3 * x[3];
            EXPECT_LT(glm::length(sum - c.separation), 1e-12);
            EXPECT_LE(glm::length(c.separation), sampled_distance(kind, x) + 1e-9) << kind << " " << n;
            const double of_a = kind == CONTACT_EDGE_EDGE ? c.w0 + c.w1 : c.w0;
            EXPECT_NEAR(of_a, 1, 1e-12);
            EXPECT_NEAR(c.w0 + c.w1 + c.w2 + c.w3, 0, 1e-12);
        }
}

}  // namespace
}  // namespace nuno
