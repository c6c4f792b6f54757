// Poses of a step, and pins on the move.
#include "solver/base/cpu_bodies.h"

#include <algorithm>

namespace nuno {

CpuBodies::CpuBodies(const Bodies& bodies, const ClothModel& model) : steps_(bodies, model), ends_{}
{
    const std::size_t counts[] = {bodies.planes.size(), bodies.spheres.size(), bodies.capsules.size(),
                                  bodies.boxes.size()};
    std::size_t end = 0;
    for (std::size_t shape = 0; shape < ends_.size(); ++shape) ends_[shape] = end += counts[shape];
}

void CpuBodies::plan(const StepInput& input)
{
    plan(input.start_time_s, double(substep_s(input.params)), input.substep_count);
}

void CpuBodies::plan(double start_time_s, double h, int substep_count)
{
    steps_.plan(start_time_s, h, substep_count);
    h_ = static_cast<float>(h);
}

BodyContacts CpuBodies::contacts(int substep, const SimParams& params) const
{
    return {.steps = steps_,
            .bodies = steps_.bodies(substep),
            .ends = ends_,
            .distance = params.thickness,
            .kinetic = params.friction,
            .resting = std::max(params.friction, params.static_friction),
            .h = h_};
}

void CpuBodies::place_pins(int substep, Range blocks, const Lanes3& x, const Lanes3& v) const
{
    const std::span<const HandlePin> pins = steps_.pins();
    if (pins.empty()) return;
    const std::span<const PinStep> places = steps_.pin_steps(substep);
    const auto before = [](const HandlePin& pin, std::uint32_t vertex) { return pin.vertex < vertex; };
    const auto end_vertex = static_cast<std::uint32_t>(blocks.end * kLanes);
    auto pin = std::lower_bound(pins.begin(), pins.end(), static_cast<std::uint32_t>(blocks.begin * kLanes), before);
    for (; pin != pins.end() && pin->vertex < end_vertex; ++pin) {
        const PinStep& place = places[static_cast<std::size_t>(pin - pins.begin())];
        const std::uint32_t i = pin->vertex;
        x.x[i] = place.position.x, x.y[i] = place.position.y, x.z[i] = place.position.z;
        v.x[i] = place.velocity.x, v.y[i] = place.velocity.y, v.z[i] = place.velocity.z;
    }
}

}  // namespace nuno
