// How a rigid body moves: keyframes, and its pose at any time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace nuno {

// x_world = rotation x_body + position.
struct Pose
{
    glm::dvec3 position{0, 0, 0};  // [m]
    glm::dmat3 rotation{1};
};

// Where a body is at one time, seen from where the scene places it: turned about the pivot, then moved.
struct Keyframe
{
    double time_s = 0;
    glm::dvec3 move{0, 0, 0};  // [m]
    glm::dvec3 axis{0, 1, 0};  // unit
    double angle = 0;          // [rad]; may be more than a turn
};

enum class Easing : std::int32_t
{
    smooth,  // 3 s^2 - 2 s^3 of the way: at rest in every keyframe
    linear   // at constant speed from one to the next
};

// What a hand adds to a motion: evenly from one way [m] at one time to another at another; before and after them it
// stays.
struct BodyShift
{
    double from_s = 0, to_s = 0;
    glm::dvec3 from{0, 0, 0}, to{0, 0, 0};

    glm::dvec3 at(double time_s) const;
    bool operator==(const BodyShift&) const = default;
};

// Before the first keyframe the body is where that one says, after the last where the last says, or, where it repeats,
// at the first again. Neither keyframes nor a shift: it does not move.
struct BodyMotion
{
    std::vector<Keyframe> keyframes;  // in order of time, no two at the same
    Easing easing = Easing::smooth;
    bool repeat = false;
    std::optional<glm::dvec3> pivot;  // [m]; none: the body's own centre
    BodyShift shift{};
    std::string group;  // bodies of one group follow a hand together; empty: it follows alone

    bool moves() const { return !keyframes.empty() || shift != BodyShift{}; }
};

// The motion at a time, without its pivot: a rotation and a way [m], the shift among it. Between two keyframes about one axis the angle runs
// evenly, so that it may be many turns; otherwise the rotation takes the short way round (slerp).
struct Displacement
{
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 move{0, 0, 0};
};
Displacement displacement_at(const BodyMotion& motion, double time_s);

// `rest`, moved: x(t) = pivot + move + Q (x_rest - pivot).
Pose pose_at(const BodyMotion& motion, const Pose& rest, double time_s);

// The rotation about a unit axis by an angle [rad].
glm::dquat rotation_about(const glm::dvec3& axis, double angle);

}  // namespace nuno
