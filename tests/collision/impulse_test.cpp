// The seed's impulses (section 2.5.2): its own numbers for equal masses, and what must hold for any.
#include "collision/impulse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kThickness = 0.02f, kDuration = 0.01f;

// Vertex 3 above face 0 = (0, 1, 2), at `distance`.
Contact contact_at(float distance) { return {3, 0, {0.2f, 0.3f, 0.5f}, glm::normalize(glm::vec3(1, 2, 2)), distance}; }

struct Scene
{
    std::vector<glm::uvec3> faces = {{0, 1, 2}};
    std::vector<glm::vec4> positions = std::vector<glm::vec4>(4);  // only w is read
    std::vector<glm::vec4> velocities = {
        {0.1f, 0.2f, -0.3f, 7}, {0.4f, 0, 0.1f, 7}, {0, 0, 0.2f, 7}, {-1, -2, -1.5f, 7}};

    explicit Scene(const std::vector<float>& inverse_masses)
    {
        for (int i = 0; i < 4; ++i) positions[i].w = inverse_masses[i];
    }
    void answer(std::vector<Contact> contacts)
    {
        apply_impulses(contacts, faces, positions, velocities, kThickness, kDuration);
    }
    // (v3 - v4).n
    float parting_speed(const Contact& contact) const
    {
        const glm::vec3 w = contact.weights;
        const glm::vec3 v4(w.x * velocities[0] + w.y * velocities[1] + w.z * velocities[2]);
        return glm::dot(glm::vec3(velocities[3]) - v4, contact.normal);
    }
};

// By hand: m = 2 kg, w = (0.2, 0.3, 0.5), so 1 + w0^2 + w1^2 + w2^2 = 1.38; (v3 - v4).n = -1 m/s.
//     I  = 2 * -1 / 1.38 = -1.4492754 kg m/s
//     I' = I - 2 * (0.02 - 0.01) / 0.01 / 1.38 = -2.8985507 kg m/s
TEST(Impulse, equal_masses_give_the_numbers_of_the_paper)
{
    const glm::vec3 n = contact_at(0).normal;
    const ContactParticles particles{{glm::vec3(0), glm::vec3(0), glm::vec3(0), -n}, {0.5f, 0.5f, 0.5f, 0.5f}};
    EXPECT_NEAR(contact_impulse(contact_at(kThickness), particles, kThickness, kDuration), 1.4492754f, 1e-6f);
    EXPECT_NEAR(contact_impulse(contact_at(0.01f), particles, kThickness, kDuration), 2.8985507f, 1e-6f);
}

// v'_i = v_i + w_i I / m and v'_3 = v_3 - I / m, with I = -2.8985507 n as above.
TEST(Impulse, equal_masses_change_the_velocities_as_in_the_paper)
{
    Scene scene({0.5f, 0.5f, 0.5f, 0.5f});
    const Contact contact = contact_at(0.01f);
    for (int i = 0; i < 3; ++i) scene.velocities[i] = glm::vec4(0);
    scene.velocities[3] = glm::vec4(-contact.normal, 0);
    scene.answer({contact});
    const float impulse = -2.8985507f;
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(glm::length(glm::vec3(scene.velocities[i]) - contact.weights[i] * impulse / 2.0f * contact.normal),
                  1e-6f);
    EXPECT_LT(glm::length(glm::vec3(scene.velocities[3]) - (-1.0f - impulse / 2.0f) * contact.normal), 1e-6f);
}

TEST(Impulse, parting_speed_becomes_what_closes_the_gap_in_the_time_given)
{
    const std::vector<float> masses[] = {{1, 1, 1, 1}, {5, 0.1f, 2, 30}, {0, 1, 0, 2}, {0, 0, 0, 3}, {1, 2, 3, 0}};
    for (const std::vector<float>& inverse_masses : masses) {
        for (const float distance : {0.0f, 0.013f, kThickness}) {
            Scene scene(inverse_masses);
            scene.answer({contact_at(distance)});
            EXPECT_NEAR(scene.parting_speed(contact_at(distance)), (kThickness - distance) / kDuration, 2e-6f);
        }
    }
}

// To a few roundings of the momenta that go in.
TEST(Impulse, momentum_of_free_particles_is_kept)
{
    Scene scene({5, 0.1f, 2, 30});
    const auto momentum = [&] {
        glm::dvec3 sum(0);
        for (int i = 0; i < 4; ++i) sum += glm::dvec3(scene.velocities[i]) / double(scene.positions[i].w);
        return sum;
    };
    const glm::dvec3 before = momentum();
    scene.answer({contact_at(0.005f), contact_at(0.001f)});
    EXPECT_LT(glm::length(momentum() - before), 1e-6 * glm::length(before));
}

TEST(Impulse, pinned_particles_do_not_move)
{
    Scene scene({0, 1, 0, 0});
    const std::vector<glm::vec4> before = scene.velocities;
    scene.answer({contact_at(0.01f)});
    for (const int i : {0, 2, 3}) EXPECT_EQ(scene.velocities[i], before[i]);
    EXPECT_NE(scene.velocities[1], before[1]);
}

TEST(Impulse, four_pinned_particles_have_none)
{
    Scene scene({0, 0, 0, 0});
    const std::vector<glm::vec4> before = scene.velocities;
    scene.answer({contact_at(0.01f)});
    EXPECT_EQ(scene.velocities, before);
}

// The foot on a pinned corner: the others have no weight, so nothing of the face can give way, nor can the vertex.
TEST(Impulse, a_pinned_vertex_on_a_pinned_corner_has_none)
{
    Scene scene({0, 1, 1, 0});
    const std::vector<glm::vec4> before = scene.velocities;
    Contact contact = contact_at(0.01f);
    contact.weights = {1, 0, 0};
    scene.answer({contact});
    EXPECT_EQ(scene.velocities, before);
}

TEST(Impulse, a_pair_that_parts_fast_enough_is_left_alone)
{
    Scene scene({1, 1, 1, 1});
    const Contact contact = contact_at(0.01f);
    scene.velocities[3] = glm::vec4(1.5f * contact.normal, 7);
    ASSERT_GT(scene.parting_speed(contact), (kThickness - 0.01f) / kDuration);
    const std::vector<glm::vec4> before = scene.velocities;
    scene.answer({contact});
    EXPECT_EQ(scene.velocities, before);
}

TEST(Impulse, nothing_but_the_velocity_is_written)
{
    Scene scene({1, 2, 3, 4});
    scene.answer({contact_at(0.01f)});
    for (const glm::vec4& v : scene.velocities) EXPECT_EQ(v.w, 7);
}

// Each contact sees the velocities that the one before it left, so the last one holds exactly.
TEST(Impulse, contacts_are_answered_one_after_the_other)
{
    Scene scene({1, 1, 1, 1});
    Contact first = contact_at(0.01f), second = contact_at(0);
    second.normal = glm::normalize(glm::vec3(0, 1, 1));
    scene.answer({first, second});
    EXPECT_NEAR(scene.parting_speed(second), kThickness / kDuration, 2e-6f);
    EXPECT_GT(std::abs(scene.parting_speed(first) - (kThickness - 0.01f) / kDuration), 0.01f);
}

}  // namespace
}  // namespace nuno
