// Keyframes to poses.
#include "model/body_motion.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

glm::dquat rotation_of(const Keyframe& key) { return rotation_about(key.axis, key.angle); }

// A keyframe without a turn has every axis.
bool same_axis(const Keyframe& a, const Keyframe& b) { return a.axis == b.axis || a.angle == 0 || b.angle == 0; }

Displacement between(const Keyframe& a, const Keyframe& b, double part)
{
    Displacement now;
    now.move = a.move + part * (b.move - a.move);
    if (same_axis(a, b))
        now.rotation = rotation_about(a.angle == 0 ? b.axis : a.axis, a.angle + part * (b.angle - a.angle));
    else
        now.rotation = glm::slerp(rotation_of(a), rotation_of(b), part);
    return now;
}

// The time within the keyframes that stands for `time_s`.
double local_time(const BodyMotion& motion, double time_s)
{
    const double first = motion.keyframes.front().time_s, last = motion.keyframes.back().time_s;
    if (motion.repeat && time_s > first && last > first) return first + std::fmod(time_s - first, last - first);
    return std::clamp(time_s, first, last);
}

Displacement of_keyframes(const BodyMotion& motion, double time_s)
{
    const std::vector<Keyframe>& keys = motion.keyframes;
    if (keys.empty()) return {};
    const double t = local_time(motion, time_s);
    const auto next = std::find_if(keys.begin() + 1, keys.end(), [&](const Keyframe& key) { return key.time_s > t; });
    if (next == keys.end()) return {rotation_of(keys.back()), keys.back().move};
    const Keyframe &a = *(next - 1), &b = *next;
    const double part = (t - a.time_s) / (b.time_s - a.time_s);
    return between(a, b, motion.easing == Easing::smooth ? part * part * (3 - 2 * part) : part);
}

}  // namespace

glm::dvec3 BodyShift::at(double time_s) const
{
    if (time_s >= to_s) return to;
    return time_s <= from_s ? from : from + (time_s - from_s) / (to_s - from_s) * (to - from);
}

glm::dquat rotation_about(const glm::dvec3& axis, double angle)
{
    return glm::dquat(std::cos(angle / 2), std::sin(angle / 2) * axis);
}

Displacement displacement_at(const BodyMotion& motion, double time_s)
{
    Displacement displacement = of_keyframes(motion, time_s);
    displacement.move += motion.shift.at(time_s);
    return displacement;
}

Pose pose_at(const BodyMotion& motion, const Pose& rest, double time_s)
{
    if (!motion.moves()) return rest;
    const Displacement d = displacement_at(motion, time_s);
    const glm::dmat3 turn = glm::mat3_cast(d.rotation);
    const glm::dvec3 pivot = motion.pivot.value_or(rest.position);
    return {pivot + d.move + turn * (rest.position - pivot), turn * rest.rotation};
}

}  // namespace nuno
