// The stages of a pass, as the simulation calls them.
#include "collision/self_collision.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "collision/brute_force.h"
#include "collision/poses.h"
#include "core/error.h"

namespace nuno {
namespace {

struct Pass
{
    Pose pose = crumpled_sheet(17, 0.1f, 1);
    std::vector<glm::vec4> before = shaken(pose.positions, 0.05f, 1);
    std::vector<glm::vec4> velocities = shaken(std::vector<glm::vec4>(pose.positions.size()), 1.0f, 2);
    ThreadPool pool{1};
    SelfCollision collision{pose.rest, pose.faces, pose.sheets, pool};

    CollisionStep step() { return {before, pose.positions, velocities, 0.01f}; }
};

TEST(SelfCollision, settings_come_from_the_parameters)
{
    SimParams params;
    params.collision = CollisionLevel::none;
    params.culling = Culling::seed;
    params.thickness = 0.25f;
    params.edge_tolerance = 0.125f;
    params.friction = 0.5f;
    params.static_friction = 0.75f;
    const CollisionSettings settings = collision_settings(params);
    EXPECT_EQ(settings.level, CollisionLevel::none);
    EXPECT_EQ(settings.culling, Culling::seed);
    EXPECT_EQ(settings.range.thickness, 0.25f);
    EXPECT_EQ(settings.range.edge_tolerance, 0.125f);
    EXPECT_EQ(settings.friction, 0.5f);
    EXPECT_EQ(settings.static_friction, 0.75f);
}

TEST(SelfCollision, refuses_a_culling_that_breaks_the_promise_of_guaranteed)
{
    SimParams params;
    params.collision = CollisionLevel::guaranteed;
    for (const Culling culling : {Culling::none, Culling::sound}) {
        params.culling = culling;
        EXPECT_NO_THROW(check_collision_settings(params));
    }
    params.culling = Culling::seed;
    EXPECT_THROW(check_collision_settings(params), Error);
    params.collision = CollisionLevel::continuous;
    EXPECT_NO_THROW(check_collision_settings(params));
}

TEST(SelfCollision, culls_soundly_unless_it_is_told_otherwise) { EXPECT_EQ(SimParams{}.culling, Culling::sound); }

// Where everything is proven apart, all pairs of neighbours are counted: those that a query without culling has to look
// at are among them.
TEST(SelfCollision, counts_the_neighbours_that_a_proof_spares)
{
    ThreadPool pool(1);
    Pose pose = flat_sheet(17);
    std::vector<glm::vec4> velocities(pose.positions.size());
    SelfCollision collision(pose.rest, pose.faces, pose.sheets, pool);
    const CollisionStep step{pose.positions, pose.positions, velocities, 0.01f};
    const auto counts = [&](Culling culling) {
        collision.refit(step, {CollisionLevel::discrete, culling, {0.01f, 0.05f}, 0, 0});
        collision.query(step);
        return collision.counts();
    };
    EXPECT_GT(counts(Culling::none).pairs_tested, 0u);
    EXPECT_EQ(counts(Culling::none).pairs_culled, 0u);
    EXPECT_EQ(counts(Culling::sound).pairs_tested, 0u);
    EXPECT_GE(counts(Culling::sound).pairs_culled, counts(Culling::none).pairs_tested);
}

TEST(SelfCollision, discrete_finds_counts_and_answers_the_contacts)
{
    Pass pass;
    const CollisionSettings settings{CollisionLevel::discrete, Culling::none, {0.02f, 0.05f}, 0, 0};
    const std::vector<glm::vec4> untouched = pass.velocities;
    pass.collision.refit(pass.step(), settings);
    ASSERT_TRUE(pass.collision.query(pass.step()));
    const std::span<const Contact> contacts = pass.collision.contacts();
    EXPECT_EQ(std::vector<Contact>(contacts.begin(), contacts.end()),
              brute_force_contacts(pass.pose.positions, pass.pose.faces, settings.range));
    EXPECT_EQ(pass.velocities, untouched);
    EXPECT_EQ(pass.collision.counts().contacts, contacts.size());
    EXPECT_GE(pass.collision.counts().pairs_tested, contacts.size());
    EXPECT_EQ(pass.collision.counts().pairs_culled, 0u);

    const Contact last = contacts.back();
    pass.collision.respond(pass.step());
    const glm::uvec3 face = pass.pose.faces[last.face];
    const glm::vec3 v4(last.weights.x * pass.velocities[face.x] + last.weights.y * pass.velocities[face.y] +
                       last.weights.z * pass.velocities[face.z]);
    const float speed = glm::dot(glm::vec3(pass.velocities[last.vertex]) - v4, last.normal);
    EXPECT_GE(speed, (0.02f - last.distance) / 0.01f - 1e-5f);
}

TEST(SelfCollision, none_does_nothing_but_can_count_what_passed_through)
{
    Pass pass;
    const std::vector<glm::vec4> untouched = pass.velocities;
    pass.collision.refit(pass.step(), {CollisionLevel::none, Culling::none, {0.02f, 0.05f}, 0, 0});
    EXPECT_FALSE(pass.collision.query(pass.step()));
    pass.collision.respond(pass.step());
    EXPECT_EQ(pass.velocities, untouched);
    EXPECT_EQ(pass.collision.counts().pairs_tested, 0u);
    EXPECT_EQ(pass.collision.counts().unresolved, 0u);

    pass.collision.count_pass_through(pass.step());
    EXPECT_EQ(pass.collision.counts().unresolved,
              brute_force_pass_through(pass.before, pass.pose.positions, pass.pose.faces).size());
    EXPECT_GT(pass.collision.counts().unresolved, 0u);
}

TEST(SelfCollision, a_new_pass_starts_its_counts_anew)
{
    Pass pass;
    const CollisionSettings settings{CollisionLevel::discrete, Culling::seed, {0.02f, 0.05f}, 0, 0};
    pass.collision.refit(pass.step(), settings);
    pass.collision.query(pass.step());
    pass.collision.count_pass_through(pass.step());
    const CollisionCounts first = pass.collision.counts();
    EXPECT_GT(first.unresolved, 0u);

    pass.collision.refit(pass.step(), settings);
    EXPECT_EQ(pass.collision.counts().contacts, 0u);
    EXPECT_EQ(pass.collision.counts().unresolved, 0u);
    pass.collision.query(pass.step());
    EXPECT_EQ(pass.collision.counts().contacts, first.contacts);
    EXPECT_EQ(pass.collision.counts().pairs_tested, first.pairs_tested);
    EXPECT_EQ(pass.collision.counts().pairs_culled, first.pairs_culled);
}

TEST(SelfCollision, counting_after_the_query_leaves_the_contacts_as_they_were)
{
    Pass pass, other;
    const CollisionSettings settings{CollisionLevel::discrete, Culling::none, {0.02f, 0.05f}, 0, 0};
    pass.collision.refit(pass.step(), settings);
    pass.collision.query(pass.step());
    pass.collision.count_pass_through(pass.step());
    pass.collision.respond(pass.step());
    other.collision.refit(other.step(), settings);
    other.collision.query(other.step());
    other.collision.respond(other.step());
    EXPECT_EQ(pass.velocities, other.velocities);
}

}  // namespace
}  // namespace nuno
