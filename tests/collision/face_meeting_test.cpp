// Two faces in one pose: how they meet, by cases made by hand, down to faces without area and the least floats.
#include "collision/face_meeting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision/orientation.h"

namespace nuno {
namespace {

const glm::vec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);
const FaceCorners kFloor{{kA, kB, kC}, {0, 1, 2}};

Meeting with_floor(glm::vec3 p, glm::vec3 q, glm::vec3 r)
{
    const FaceCorners face{{p, q, r}, {3, 4, 5}};
    const Meeting kind = meet(kFloor, face).kind;
    EXPECT_EQ(meet(face, kFloor).kind, kind);
    return kind;
}

// Corner 0 of the floor in common.
Meeting beside_corner(glm::vec3 q, glm::vec3 r) { return meet(kFloor, {{kA, q, r}, {0, 4, 5}}).kind; }

TEST(Orientation, is_exact_where_double_is_not)
{
    const float one = 1, next = std::nextafter(1.0f, 2.0f), tiny = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(volume_sign({1e6f, 0, 0}, {0, 1e6f, 0}, {0, 0, 1e6f}, {tiny, 0, 1e6f}), 1);
    EXPECT_EQ(volume_sign({1e6f, 0, 0}, {0, 1e6f, 0}, {0, 0, 1e6f}, {-tiny, 0, 1e6f}), -1);
    EXPECT_EQ(volume_sign({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}), 1);
    EXPECT_EQ(volume_sign({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {5, 7, 0}), 0);
    EXPECT_EQ(volume_sign({one, one, one}, {next, next, next}, {3, 3, 3}, {5, 2, 1}), 0);
    EXPECT_EQ(area_sign({1e6f, 1e6f, 0}, {0, 0, 0}, {-1e6f, -1e6f, 0}, 2), 0);
    EXPECT_EQ(area_sign({1e6f, 1e6f, 0}, {0, 0, 0}, {-1e6f, -1e6f - 0.0625f, 0}, 2), 1);
    EXPECT_EQ(area_sign({0, 0, 0}, {1, tiny, 0}, {1e6f, 0, 0}, 2), -1);
}

TEST(FaceMeeting, an_edge_through_the_inside_is_a_crossing_and_is_named)
{
    const FaceCorners face{{glm::vec3(0.2f, 0.2f, 1), {0.3f, 0.2f, -1}, {0.2f, 0.3f, 2}}, {3, 4, 5}};
    const FaceMeeting meeting = meet(kFloor, face);
    EXPECT_EQ(meeting.kind, Meeting::crossing);
    ASSERT_EQ(meeting.crossing_count, 2);
    EXPECT_FALSE(meeting.crossings[0].edge_of_first);
    EXPECT_EQ(meeting.crossings[0].edge, 0);
    EXPECT_FALSE(meeting.crossings[1].edge_of_first);
    EXPECT_EQ(meeting.crossings[1].edge, 1);
}

TEST(FaceMeeting, without_points_in_common)
{
    EXPECT_EQ(with_floor({0.2f, 0.2f, 1}, {0.3f, 0.2f, 1e-30f}, {0.2f, 0.3f, 2}), Meeting::none);
    EXPECT_EQ(with_floor({2, 2, 1}, {2, 2, -1}, {3, 2, 0}), Meeting::none);
    EXPECT_EQ(with_floor({1, 1, 0}, {2, 1, 0}, {1, 2, 0}), Meeting::none);
}

TEST(FaceMeeting, a_corner_or_an_edge_on_the_other_face_touches)
{
    EXPECT_EQ(with_floor({0.2f, 0.2f, 0}, {0.3f, 0.2f, 1}, {0.2f, 0.3f, 2}), Meeting::touching);
    EXPECT_EQ(with_floor({1, 0, 0}, {1, 0, 1}, {2, 0, 1}), Meeting::touching);
    EXPECT_EQ(with_floor({0.5f, 0, 0}, {0.5f, -1, 1}, {0.5f, -1, 0}), Meeting::touching);
    EXPECT_EQ(with_floor({-1, 0.25f, 0}, {2, 0.25f, 0}, {0, 0.25f, 1}), Meeting::touching);
    EXPECT_EQ(with_floor({0.1f, 0.1f, 0}, {0.2f, 0.1f, 0}, {0.1f, 0.2f, 0}), Meeting::touching);
    EXPECT_EQ(with_floor(kA, kB, kC), Meeting::touching);
    EXPECT_EQ(with_floor({-9, -9, 0}, {9, -9, 0}, {0, 20, 0}), Meeting::touching);
}

TEST(FaceMeeting, a_face_without_area_is_the_segment_or_point_that_is_left)
{
    EXPECT_EQ(with_floor({0.2f, 0.2f, 1}, {0.2f, 0.2f, 0.5f}, {0.2f, 0.2f, -1}), Meeting::crossing);
    EXPECT_EQ(with_floor({0.2f, 0.2f, 1}, {0.2f, 0.2f, 0.5f}, {0.2f, 0.2f, 0}), Meeting::touching);
    EXPECT_EQ(with_floor({0.2f, 0.2f, 1}, {0.2f, 0.2f, 0.5f}, {0.2f, 0.2f, 0.25f}), Meeting::none);
    EXPECT_EQ(with_floor({0.2f, 0.2f, 0}, {0.2f, 0.2f, 0}, {0.2f, 0.2f, 0}), Meeting::touching);
    EXPECT_EQ(with_floor({2, 0.2f, 0}, {2, 0.2f, 0}, {2, 0.2f, 0}), Meeting::none);
    EXPECT_EQ(with_floor({-1, 0.5f, 0}, {0.1f, 0.5f, 0}, {2, 0.5f, 0}), Meeting::touching);
    const FaceCorners line{{glm::vec3(0), glm::vec3(1), glm::vec3(2)}, {0, 1, 2}};
    EXPECT_EQ(meet(line, {{glm::vec3(1), glm::vec3(3), glm::vec3(4)}, {3, 4, 5}}).kind, Meeting::touching);
    EXPECT_EQ(meet(line, {{glm::vec3(3), glm::vec3(4), glm::vec3(5)}, {3, 4, 5}}).kind, Meeting::none);
    EXPECT_EQ(meet(line, {{glm::vec3(0, 0, 2), glm::vec3(1), glm::vec3(2, 2, 0)}, {3, 4, 5}}).kind, Meeting::touching);
}

TEST(FaceMeeting, faces_with_a_vertex_in_common_meet_at_the_opposite_edges)
{
    EXPECT_EQ(beside_corner({-1, 0, 0}, {0, -1, 0}), Meeting::none);
    EXPECT_EQ(beside_corner({-1, 0, 1}, {0, -1, 1}), Meeting::none);
    EXPECT_EQ(beside_corner({0.3f, 0.3f, -1}, {0.3f, 0.3f, 1}), Meeting::crossing);
    EXPECT_EQ(beside_corner({0.3f, 0.3f, -1}, {0.5f, 0.5f, 0}), Meeting::touching);
    EXPECT_EQ(beside_corner({0.1f, 0.2f, 0}, {0.2f, 0.1f, 0}), Meeting::touching);
    EXPECT_EQ(beside_corner({1, 0, 0}, {0.5f, -1, 0}), Meeting::touching);
}

TEST(FaceMeeting, faces_with_an_edge_in_common_meet_where_they_are_folded_together)
{
    const auto apex = [](glm::vec3 p) { return meet(kFloor, {{kA, kB, p}, {0, 1, 5}}).kind; };
    EXPECT_EQ(apex({0.5f, -1, 0}), Meeting::none);
    EXPECT_EQ(apex({0.5f, 1, 1e-30f}), Meeting::none);
    EXPECT_EQ(apex({0.5f, 1, 0}), Meeting::touching);
    EXPECT_EQ(apex({0.5f, 0, 0}), Meeting::none);
    EXPECT_EQ(meet(kFloor, {{kC, kA, kB}, {2, 0, 1}}).kind, Meeting::touching);
}

}  // namespace
}  // namespace nuno
