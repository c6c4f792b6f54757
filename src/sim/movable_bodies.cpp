// Bodies and the hand.
#include "sim/movable_bodies.h"

#include <fmt/format.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "sim/held_vertex.h"

namespace nuno {

MovableBodies::MovableBodies(Bodies bodies) : bodies_(std::move(bodies))
{
    const auto add = [&](auto& shapes) {
        for (auto& shape : shapes) motions_.push_back(&shape.motion);
    };
    add(bodies_.planes), add(bodies_.spheres), add(bodies_.capsules), add(bodies_.boxes), add(bodies_.meshes);
}

bool MovableBodies::can_move(std::size_t body) const { return body >= bodies_.planes.size() && body < motions_.size(); }

void MovableBodies::hold(std::size_t body, const glm::dvec3& way)
{
    if (can_move(body)) held_ = Held{body, way};
}

void MovableBodies::advance(double start_s, double duration_s)
{
    if (!held_) return;
    const BodyMotion& held = *motions_[held_->body];
    const BodyShift shift = held.shift;
    const glm::dvec3 rest = held_->way - shift.to;
    const double most = double(kHandSpeed) * duration_s, length = glm::length(rest);
    const glm::dvec3 to = length > most ? shift.to + most / length * rest : held_->way;
    for (BodyMotion* motion : motions_)
        if (motion == &held || (!held.group.empty() && motion->group == held.group))
            motion->shift = {.from_s = start_s, .to_s = start_s + duration_s, .from = shift.to, .to = to};
}

std::vector<BodyShift> MovableBodies::shifts() const
{
    std::vector<BodyShift> shifts;
    for (const BodyMotion* motion : motions_) shifts.push_back(motion->shift);
    const auto is_none = [](const BodyShift& shift) { return shift == BodyShift{}; };
    if (std::all_of(shifts.begin(), shifts.end(), is_none)) shifts.clear();
    return shifts;
}

void MovableBodies::set_shifts(std::span<const BodyShift> shifts)
{
    if (!shifts.empty() && shifts.size() != motions_.size())
        throw Error(fmt::format("the state is of a scene with {} bodies, not with {}; leave the bodies as they were",
                                shifts.size(), motions_.size()));
    release();
    for (std::size_t body = 0; body < motions_.size(); ++body)
        motions_[body]->shift = shifts.empty() ? BodyShift{} : shifts[body];
}

}  // namespace nuno
