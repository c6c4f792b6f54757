// The stages of a pass, as the simulation calls them.
#include "collision/self_collision.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "collision/brute_force.h"
#include "collision/poses.h"

namespace nuno {
namespace {

struct Pass
{
    Pose pose = crumpled_sheet(17, 0.1f, 1);
    std::vector<glm::vec4> before = shaken(pose.positions, 0.05f, 1);
    std::vector<glm::vec4> velocities = shaken(std::vector<glm::vec4>(pose.positions.size()), 1.0f, 2);
    ThreadPool pool{1};
    SelfCollision collision{pose.rest, pose.faces, pool};

    CollisionStep step() { return {before, pose.positions, velocities, 0.01f}; }
};

TEST(SelfCollision, settings_come_from_the_parameters)
{
    SimParams params;
    params.collision = CollisionLevel::none;
    params.culling = Culling::seed;
    params.thickness = 0.25f;
    params.edge_tolerance = 0.125f;
    const CollisionSettings settings = collision_settings(params);
    EXPECT_EQ(settings.level, CollisionLevel::none);
    EXPECT_EQ(settings.culling, Culling::seed);
    EXPECT_EQ(settings.range.thickness, 0.25f);
    EXPECT_EQ(settings.range.edge_tolerance, 0.125f);
}

TEST(SelfCollision, discrete_finds_counts_and_answers_the_contacts)
{
    Pass pass;
    const CollisionSettings settings{CollisionLevel::discrete, Culling::none, {0.02f, 0.05f}};
    const std::vector<glm::vec4> untouched = pass.velocities;
    pass.collision.refit(pass.step(), settings);
    const std::span<const Contact> contacts = pass.collision.query(pass.step());
    EXPECT_EQ(std::vector<Contact>(contacts.begin(), contacts.end()),
              brute_force_contacts(pass.pose.positions, pass.pose.faces, settings.range));
    ASSERT_FALSE(contacts.empty());
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
    pass.collision.refit(pass.step(), {CollisionLevel::none, Culling::none, {0.02f, 0.05f}});
    EXPECT_TRUE(pass.collision.query(pass.step()).empty());
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
    const CollisionSettings settings{CollisionLevel::discrete, Culling::seed, {0.02f, 0.05f}};
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
    const CollisionSettings settings{CollisionLevel::discrete, Culling::none, {0.02f, 0.05f}};
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
