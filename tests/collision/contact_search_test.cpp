// The tree finds what brute force finds, bit for bit and in the same order, with any number of threads.
#include <gtest/gtest.h>

#include <cmath>

#include "collision/brute_force.h"
#include "collision/discrete.h"
#include "collision/poses.h"

namespace nuno {
namespace {

struct Found
{
    std::vector<Contact> contacts;
    std::uint64_t pairs_tested;
};

// Without culling, or with the sound one: no difference is to be seen.
Found search(const Pose& pose, const ContactRange& range, int threads = 1, Culling culling = Culling::none)
{
    ThreadPool pool(threads);
    ElementQuery query(pose.rest, pose.faces, pose.sheets, ElementKinds::vertex_face);
    ContactSearch search;
    const float reach = contact_reach(range, pose.faces, pose.positions);
    const int tasks = query.begin({pose.positions, pose.positions}, {reach, culling}, pool);
    const std::span<const Contact> contacts = search.find(query, tasks, pose.positions, range, pool);
    return {{contacts.begin(), contacts.end()}, search.pairs_tested()};
}

// Thin and thick against the spacing of the vertices, with and without a tolerance at the edges. Returns the contacts
// there were.
std::size_t expect_as_brute_force(const Pose& pose, float spacing)
{
    std::size_t count = 0;
    for (const float thickness : {0.0f, 0.02f, 0.3f, 1.5f}) {
        for (const float edge_tolerance : {0.0f, 0.05f, 1.0f}) {
            SCOPED_TRACE("thickness " + std::to_string(thickness) + " spacings, edge_tolerance " +
                         std::to_string(edge_tolerance));
            const ContactRange range{thickness * spacing, edge_tolerance};
            const std::vector<Contact> expected = brute_force_contacts(pose.positions, pose.faces, range);
            EXPECT_EQ(search(pose, range).contacts, expected);
            if (edge_tolerance == 0.05f) {
                EXPECT_EQ(search(pose, range, 1, Culling::sound).contacts, expected);
            }
            count += expected.size();
        }
    }
    return count;
}

TEST(ContactSearch, agrees_with_brute_force_on_a_flat_sheet) { expect_as_brute_force(flat_sheet(17), 1.0f / 16); }

TEST(ContactSearch, agrees_with_brute_force_on_crumpled_sheets)
{
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        for (const float amplitude : {0.02f, 0.1f, 0.4f})
            EXPECT_GT(expect_as_brute_force(crumpled_sheet(17, amplitude, seed), 1.0f / 16), 0u);
    }
}

TEST(ContactSearch, agrees_with_brute_force_on_a_sheet_folded_by_180_degrees)
{
    for (const float gap : {0.001f, 0.01f, 0.1f})
        EXPECT_GT(expect_as_brute_force(folded_sheet(21, gap), 0.05f), 0u) << gap;
}

TEST(ContactSearch, agrees_with_brute_force_on_a_rolled_sheet)
{
    for (const float gap : {0.01f, 0.03f})
        EXPECT_GT(expect_as_brute_force(rolled_sheet(25, gap), 1.0f / 24), 0u) << gap;
}

TEST(ContactSearch, agrees_with_brute_force_on_several_sheets)
{
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        EXPECT_GT(expect_as_brute_force(stacked_sheets(12, 4, seed), 1.0f / 11), 0u);
    }
}

TEST(ContactSearch, agrees_with_brute_force_on_random_faces_some_without_area)
{
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        EXPECT_GT(expect_as_brute_force(face_soup(60 + static_cast<int>(seed), seed), 0.1f), 0u);
    }
}

TEST(ContactSearch, agrees_with_brute_force_far_from_the_origin)
{
    for (const float offset : {-30.0f, 1000.0f, 1e5f}) {
        SCOPED_TRACE(offset);
        Pose pose = crumpled_sheet(17, 0.1f, 1);
        for (glm::vec4& p : pose.positions) p += glm::vec4(offset, -offset, 0.5f * offset, 0);
        expect_as_brute_force(pose, 1.0f / 16);
    }
}

// Every face is flattened to a needle, so that weights and normals are mostly rounding.
TEST(ContactSearch, agrees_with_brute_force_on_a_sheet_pressed_almost_into_a_line)
{
    for (const float width : {1e-3f, 1e-5f, 1e-7f, 0.0f}) {
        SCOPED_TRACE(width);
        Pose pose = crumpled_sheet(17, 0.1f, 2);
        for (glm::vec4& p : pose.positions) p = glm::vec4(p.x, 0.3f * p.x + width * p.y, width * p.z - p.x, 1);
        expect_as_brute_force(pose, 1.0f / 16);
    }
}

TEST(ContactSearch, agrees_with_brute_force_on_a_mesh_large_enough_for_threads)
{
    const Pose pose = crumpled_sheet(48, 0.15f, 1);
    const ContactRange range{0.005f, 0.05f};
    const std::vector<Contact> expected = brute_force_contacts(pose.positions, pose.faces, range);
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(search(pose, range).contacts, expected);
}

TEST(ContactSearch, does_not_depend_on_the_number_of_threads)
{
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Pose pose = crumpled_sheet(64, 0.1f, seed);
        const ContactRange range{0.004f, 0.05f};
        const Found one = search(pose, range, 1);
        EXPECT_GT(one.contacts.size(), 100u);
        for (const int threads : {2, 3}) {
            const Found more = search(pose, range, threads);
            EXPECT_EQ(more.contacts, one.contacts);
            EXPECT_EQ(more.pairs_tested, one.pairs_tested);
        }
    }
}

TEST(ContactSearch, a_second_search_gives_the_contacts_of_its_own_pose)
{
    ThreadPool pool(1);
    const Pose pose = crumpled_sheet(17, 0.1f, 1);
    const ContactRange range{0.02f, 0.05f};
    ElementQuery query(pose.rest, pose.faces, pose.sheets, ElementKinds::vertex_face);
    ContactSearch search;
    for (const float shake : {0.0f, 0.05f, 0.01f}) {
        const std::vector<glm::vec4> positions = shaken(pose.positions, shake, 7);
        const float reach = contact_reach(range, pose.faces, positions);
        const int tasks = query.begin({positions, positions}, {reach, Culling::none}, pool);
        const std::span<const Contact> contacts = search.find(query, tasks, positions, range, pool);
        EXPECT_EQ(std::vector<Contact>(contacts.begin(), contacts.end()),
                  brute_force_contacts(positions, pose.faces, range));
    }
}

TEST(ContactSearch, a_flat_sheet_at_rest_thinner_than_its_spacing_has_no_contact)
{
    const Pose pose = flat_sheet(33);
    EXPECT_TRUE(search(pose, {0.9f / 32, 0.05f}).contacts.empty());
}

// Neighbours are looked at too: the sheet is so sharply folded that a vertex meets a face which shares an edge with its
// own.
TEST(ContactSearch, finds_a_vertex_folded_onto_the_face_across_its_edge)
{
    Pose pose;
    pose.rest = {{0, 0, 0}, {1, 0, 0}, {0.5f, 1, 0}, {0.5f, -1, 0}};
    pose.positions = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0.5f, 1, 0, 1}, {0.5f, 0.6f, 0.01f, 1}};
    pose.faces = {{0, 1, 2}, {1, 0, 3}};
    const std::vector<Contact> contacts = search(pose, {0.02f, 0.05f}).contacts;
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].vertex, 3u);
    EXPECT_EQ(contacts[0].face, 0u);
    EXPECT_FLOAT_EQ(contacts[0].distance, 0.01f);
    EXPECT_EQ(contacts[0].normal, glm::vec3(0, 0, 1));
    EXPECT_FLOAT_EQ(contacts[0].weights.z, 0.6f);
}

TEST(ContactSearch, normal_points_to_the_side_of_the_vertex)
{
    Pose pose;
    pose.rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}, {1, 0, 5}, {0, 1, 5}};
    pose.positions = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0.2f, 0.2f, -0.01f, 1}, {1, 0, -2, 1}, {0, 1, -2, 1}};
    pose.faces = {{0, 1, 2}, {3, 4, 5}};
    const std::vector<Contact> contacts = search(pose, {0.02f, 0.05f}).contacts;
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].normal, glm::vec3(0, 0, -1));
    EXPECT_FLOAT_EQ(contacts[0].distance, 0.01f);
}

}  // namespace
}  // namespace nuno
