// What the seed's culling loses, against brute force: nothing on a fold, everything where all normals are alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "collision/brute_force.h"
#include "collision/discrete.h"
#include "collision/poses.h"

namespace nuno {
namespace {

struct Lost
{
    std::size_t of = 0, missed = 0;
};

// Contacts of brute force that the search with Culling::seed does not give; prints the number.
Lost lost_by_culling(const char* name, const Pose& pose, float thickness)
{
    ThreadPool pool(1);
    const ContactRange range{thickness, 0.05f};
    BoxTree tree(pose.rest, pose.faces);
    ContactSearch search;
    tree.refit(pose.positions, contact_margin(range), pool);
    tree.bound_normals(pose.positions, pool);
    const std::span<const Contact> found = search.find(tree, pose.positions, range, Culling::seed, pool);
    const std::vector<Contact> all = brute_force_contacts(pose.positions, pose.faces, range);

    std::vector<Contact> missed;
    std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(missed), comes_before);
    EXPECT_EQ(missed.size() + found.size(), all.size()) << "a contact that brute force does not know";
    std::cout << name << ": the seed's culling misses " << missed.size() << " of " << all.size() << " contacts, skips "
              << search.counts().pairs_culled << " pairs and tests " << search.counts().pairs_tested << "\n";
    return {all.size(), missed.size()};
}

TEST(Culling, seed_skips_a_flat_sheet_altogether)
{
    ThreadPool pool(1);
    const Pose pose = flat_sheet(17);
    BoxTree tree(pose.rest, pose.faces);
    PairQuery query;
    tree.refit(pose.positions, {}, pool);
    tree.bound_normals(pose.positions, pool);
    query.begin(tree, Culling::seed);
    EXPECT_TRUE(query.run(0, [](std::uint32_t) { return Bounds{}; }).empty());
    EXPECT_EQ(query.counts().visits, 1u);
    EXPECT_EQ(query.counts().pairs_culled, 512u * 289u);
}

TEST(Culling, seed_misses_nothing_on_a_fold)
{
    const Lost lost = lost_by_culling("fold", folded_sheet(25, 0.05f), 0.06f);
    EXPECT_GT(lost.of, 100u);
    EXPECT_EQ(lost.missed, 0u);
}

TEST(Culling, seed_misses_nothing_on_a_roll_of_whole_turns)
{
    const Lost lost = lost_by_culling("roll", rolled_sheet(33, 0.02f), 0.03f);
    EXPECT_GT(lost.of, 100u);
    EXPECT_EQ(lost.missed, 0u);
}

TEST(Culling, seed_misses_every_contact_of_a_flat_c_whose_ends_touch)
{
    const Lost lost = lost_by_culling("flat C", flat_c(33, 0.01f), 0.02f);
    EXPECT_GT(lost.of, 10u);
    EXPECT_EQ(lost.missed, lost.of);
}

TEST(Culling, seed_misses_every_contact_of_a_spiral_ramp)
{
    const Lost lost = lost_by_culling("spiral ramp", spiral_ramp(33, 0.01f), 0.02f);
    EXPECT_GT(lost.of, 100u);
    EXPECT_EQ(lost.missed, lost.of);
}

TEST(Culling, seed_misses_few_on_crumpled_sheets)
{
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Lost lost = lost_by_culling("crumpled", crumpled_sheet(33, 0.1f, seed), 0.01f);
        EXPECT_LT(lost.missed, lost.of);
    }
}

// A face without area may have any normal, so no node above it is skipped.
TEST(Culling, a_face_without_area_is_never_skipped)
{
    ThreadPool pool(1);
    Pose pose = flat_sheet(3);
    const glm::uvec3 face = pose.faces[3];
    pose.positions[face.y] = pose.positions[face.x];
    BoxTree tree(pose.rest, pose.faces);
    tree.refit(pose.positions, {}, pool);
    tree.bound_normals(pose.positions, pool);
    TreeQuery query;
    tree.visit(tree.root(), query, Culling::seed);
    EXPECT_EQ(query.pairs_culled, 0u);
}

}  // namespace
}  // namespace nuno
