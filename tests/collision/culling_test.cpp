// What culling loses of the contacts that brute force finds: soundly nothing; as the seed does nothing on a fold, and
// everything where all normals are alike.
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

// Contacts of brute force that the search with this culling does not give; prints the number.
Lost lost_by_culling(Culling culling, const char* name, const Pose& pose, float thickness)
{
    ThreadPool pool(1);
    const ContactRange range{thickness, 0.05f};
    ElementQuery query(pose.rest, pose.faces, pose.sheets, ElementKinds::vertex_face);
    ContactSearch search;
    const float reach = contact_reach(range, pose.faces, pose.positions);
    const int tasks = query.begin({pose.positions, pose.positions}, {reach, culling}, pool);
    const std::span<const Contact> found = search.find(query, tasks, pose.positions, range, pool);
    const std::vector<Contact> all = brute_force_contacts(pose.positions, pose.faces, range);

    std::vector<Contact> missed;
    std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(missed), comes_before);
    EXPECT_EQ(missed.size() + found.size(), all.size()) << "a contact that brute force does not know";
    std::cout << name << ": culling " << choice_names(culling)[static_cast<std::size_t>(culling)] << " misses "
              << missed.size() << " of " << all.size() << " contacts and tests " << search.pairs_tested() << " pairs\n";
    return {all.size(), missed.size()};
}

struct NamedPose
{
    const char* name;
    Pose pose;
    float thickness;
};

std::vector<NamedPose> hard_poses()
{
    std::vector<NamedPose> poses = {{"flat", flat_sheet(33), 0.02f},
                                    {"fold", folded_sheet(25, 0.05f), 0.06f},
                                    {"roll", rolled_sheet(33, 0.02f), 0.03f},
                                    {"flat C", flat_c(33, 0.01f), 0.02f},
                                    {"spiral ramp", spiral_ramp(33, 0.01f), 0.02f}};
    for (std::uint32_t seed = 1; seed <= 4; ++seed)
        poses.push_back({"crumpled", crumpled_sheet(33, 0.1f, seed), 0.01f});
    return poses;
}

TEST(Culling, sound_misses_nothing)
{
    std::size_t contacts = 0;
    for (const auto& [name, pose, thickness] : hard_poses()) {
        for (const float share : {0.1f, 1.0f, 3.0f}) {
            const Lost lost = lost_by_culling(Culling::sound, name, pose, share * thickness);
            EXPECT_EQ(lost.missed, 0u) << name;
            contacts += lost.of;
        }
    }
    EXPECT_GT(contacts, 1000u);
}

TEST(Culling, seed_misses_nothing_on_a_fold)
{
    const Lost lost = lost_by_culling(Culling::seed, "fold", folded_sheet(25, 0.05f), 0.06f);
    EXPECT_GT(lost.of, 100u);
    EXPECT_EQ(lost.missed, 0u);
}

TEST(Culling, seed_misses_nothing_on_a_roll_of_whole_turns)
{
    const Lost lost = lost_by_culling(Culling::seed, "roll", rolled_sheet(33, 0.02f), 0.03f);
    EXPECT_GT(lost.of, 100u);
    EXPECT_EQ(lost.missed, 0u);
}

TEST(Culling, seed_misses_every_contact_of_a_flat_c_whose_ends_touch)
{
    const Lost lost = lost_by_culling(Culling::seed, "flat C", flat_c(33, 0.01f), 0.02f);
    EXPECT_GT(lost.of, 10u);
    EXPECT_EQ(lost.missed, lost.of);
}

TEST(Culling, seed_misses_every_contact_of_a_spiral_ramp)
{
    const Lost lost = lost_by_culling(Culling::seed, "spiral ramp", spiral_ramp(33, 0.01f), 0.02f);
    EXPECT_GT(lost.of, 100u);
    EXPECT_EQ(lost.missed, lost.of);
}

TEST(Culling, seed_misses_few_on_crumpled_sheets)
{
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Lost lost = lost_by_culling(Culling::seed, "crumpled", crumpled_sheet(33, 0.1f, seed), 0.01f);
        EXPECT_LT(lost.missed, lost.of);
    }
}

}  // namespace
}  // namespace nuno
