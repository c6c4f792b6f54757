// Vertices that go through faces: cases made by hand, and the tree against brute force.
#include "collision/pass_through.h"

#include <gtest/gtest.h>

#include "collision/brute_force.h"
#include "collision/poses.h"

namespace nuno {
namespace {

const glm::dvec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

Path still(glm::dvec3 at) { return {at, at}; }

bool through_still_face(glm::dvec3 from, glm::dvec3 to)
{
    return passes_through({from, to}, still(kA), still(kB), still(kC));
}

TEST(PassThrough, through_the_middle_of_a_face_in_either_direction)
{
    EXPECT_TRUE(through_still_face({0.3, 0.3, 1}, {0.3, 0.3, -1}));
    EXPECT_TRUE(through_still_face({0.3, 0.3, -1}, {0.3, 0.3, 1}));
    EXPECT_TRUE(through_still_face({0.9, 0.9, 0.5}, {-0.3, -0.3, -0.5}));
}

TEST(PassThrough, beside_a_face_or_short_of_it)
{
    EXPECT_FALSE(through_still_face({0.6, 0.6, 1}, {0.6, 0.6, -1}));
    EXPECT_FALSE(through_still_face({-0.01, 0.5, 1}, {-0.01, 0.5, -1}));
    EXPECT_FALSE(through_still_face({0.3, 0.3, 1}, {0.3, 0.3, 0.001}));
    EXPECT_FALSE(through_still_face({0.3, 0.3, 1}, {0.4, 0.3, 1}));
}

TEST(PassThrough, exactly_through_an_edge_counts_for_the_faces_on_both_sides)
{
    const Path point{{0.5, 0, 1}, {0.5, 0, -1}};
    EXPECT_TRUE(passes_through(point, still(kA), still(kB), still(kC)));
    EXPECT_TRUE(passes_through(point, still(kB), still(kA), still({0, -1, 0})));
}

TEST(PassThrough, exactly_through_a_corner)
{
    EXPECT_TRUE(through_still_face({0, 0, 1}, {0, 0, -1}));
    EXPECT_TRUE(through_still_face({1, 0, 1}, {1, 0, -1}));
}

TEST(PassThrough, a_face_that_moves_over_a_still_point)
{
    const auto moving = [](glm::dvec3 at) { return Path{at + glm::dvec3(0, 0, -1), at + glm::dvec3(0, 0, 2)}; };
    EXPECT_TRUE(passes_through(still({0.2, 0.2, 0}), moving(kA), moving(kB), moving(kC)));
    EXPECT_FALSE(passes_through(still({0.8, 0.8, 0}), moving(kA), moving(kB), moving(kC)));
    EXPECT_FALSE(passes_through(still({0.2, 0.2, 3}), moving(kA), moving(kB), moving(kC)));
}

TEST(PassThrough, point_and_face_that_move_together)
{
    const auto moving = [](glm::dvec3 at) { return Path{at, at + glm::dvec3(3, -2, 5)}; };
    EXPECT_FALSE(passes_through(moving({0.2, 0.2, 0.01}), moving(kA), moving(kB), moving(kC)));
    EXPECT_FALSE(passes_through(moving({0.2, 0.2, 0}), moving(kA), moving(kB), moving(kC)));
}

// The face z = s x tilts, s = T, and the point is at x = 0.3 + 0.2 T, height h, T = 2 t - 1: its height over the face
// is h - 0.3 T - 0.2 T^2 (times the area), with roots T = (-0.3 +- sqrt(0.09 + 0.8 h)) / 0.4.
bool tilting(double h)
{
    const Path point{{0.1, 0.25, h}, {0.5, 0.25, h}};
    return passes_through(point, still(kA), {{1, 0, -1}, {1, 0, 1}}, still(kC));
}

TEST(PassThrough, in_and_out_again_is_no_passing)
{
    EXPECT_FALSE(tilting(-0.105));  // two roots in the step
    EXPECT_TRUE(tilting(-0.05));    // the other one lies before it
    EXPECT_TRUE(tilting(0.3));
    EXPECT_FALSE(tilting(-0.2));     // none
    EXPECT_FALSE(tilting(-0.1125));  // touches from one side
}

// A step may end exactly on the face: the next one goes on, and together they are one passing or none.
TEST(PassThrough, two_steps_that_meet_on_the_face_count_once)
{
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 above(0.3, 0.3, side), on(0.3, 0.3, 0), below(0.3, 0.3, -side);
        EXPECT_EQ(through_still_face(above, on) + through_still_face(on, below), 1) << side;
        EXPECT_EQ((through_still_face(above, on) + through_still_face(on, above)) % 2, 0) << side;
    }
}

TEST(PassThrough, no_motion_and_no_area_are_no_passing)
{
    EXPECT_FALSE(passes_through(still(kA), still(kA), still(kB), still(kC)));
    EXPECT_FALSE(through_still_face({0.3, 0.3, 0}, {0.3, 0.3, 0}));
    EXPECT_FALSE(passes_through({{0, 0, 1}, {0, 0, -1}}, still(kA), still(kA), still(kA)));
    EXPECT_FALSE(passes_through({{0.5, 0, 1}, {0.5, 0, -1}}, still(kA), still(kB), still(0.5 * kB)));
}

std::vector<VertexFace> by_tree(const Pose& pose, std::span<const glm::vec4> moved, int threads)
{
    ThreadPool pool(threads);
    ElementQuery query(pose.rest, pose.faces, pose.sheets, ElementKinds::vertex_face);
    return find_pass_through(query, pose.positions, moved, pool);
}

TEST(PassThrough, nothing_passes_where_nothing_moves)
{
    for (const Pose& pose : {flat_sheet(17), crumpled_sheet(17, 0.1f, 1), face_soup(100, 1)})
        EXPECT_TRUE(by_tree(pose, pose.positions, 1).empty());
}

TEST(PassThrough, the_tree_agrees_with_brute_force)
{
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        for (const Pose& pose : {crumpled_sheet(17, 0.1f, seed), stacked_sheets(8, 4, seed), face_soup(100, seed)}) {
            for (const float distance : {0.01f, 0.1f}) {
                const std::vector<glm::vec4> moved = shaken(pose.positions, distance, seed + 100);
                const std::vector<VertexFace> expected = brute_force_pass_through(pose.positions, moved, pose.faces);
                EXPECT_GT(expected.size(), 0u);
                EXPECT_EQ(by_tree(pose, moved, 1), expected);
            }
        }
    }
}

TEST(PassThrough, does_not_depend_on_the_number_of_threads)
{
    const Pose pose = crumpled_sheet(64, 0.1f, 1);
    const std::vector<glm::vec4> moved = shaken(pose.positions, 0.01f, 1);
    const std::vector<VertexFace> one = by_tree(pose, moved, 1);
    EXPECT_GT(one.size(), 100u);
    EXPECT_EQ(by_tree(pose, moved, 2), one);
    EXPECT_EQ(by_tree(pose, moved, 3), one);
}

// A sheet thrown through another: all its vertices that were over it have passed.
TEST(PassThrough, a_sheet_thrown_through_another_is_counted_vertex_by_vertex)
{
    Pose pose = flat_sheet(9);
    Pose large = flat_sheet(5);
    for (glm::vec4& p : large.positions) p = glm::vec4(2.0f * p.x - 0.51f, 2.0f * p.y - 0.47f, 0.1f, 1.0f);
    add_sheets(pose, large);
    std::vector<glm::vec4> moved = pose.positions;
    for (int i = 0; i < 81; ++i) moved[i].z += 1.0f;

    std::vector<VertexFace> passed = by_tree(pose, moved, 1);
    std::vector<bool> has_passed(pose.rest.size());
    for (const VertexFace& pair : passed) has_passed[pair.vertex] = true;
    for (int i = 0; i < 81; ++i) EXPECT_TRUE(has_passed[i]) << i;
}

}  // namespace
}  // namespace nuno
