// Taking, moving and letting go.
#include "app/viewer_grip.h"

#include <fmt/format.h>

#include "app/body_picker.h"
#include "app/vertex_picker.h"

namespace nuno {
namespace {

glm::dvec3 way_of_hand(Simulation& simulation, std::size_t body)
{
    return placed_bodies(simulation.bodies()).at(body).motion->shift.to;
}

}  // namespace

UnderPointer look_under(Simulation& simulation, const PickView& view, glm::vec2 place, float reach)
{
    UnderPointer under;
    if (const auto hit = pick_body(simulation.bodies(), simulation.time_s(), view, place)) {
        under.body = hit->body;
        under.body_depth = hit->depth;
    }
    under.vertex =
        pick_vertex(simulation.state().positions, simulation.model().faces, view, place, reach, under.body_depth);
    return under;
}

ViewerGrip::ViewerGrip(Simulation& simulation, bool is_body, std::size_t number, const PointDrag& drag)
    : is_body_(is_body), number_(number), drag_(drag)
{
    if (is_body) start_way_ = way_of_hand(simulation, number);
}

std::optional<ViewerGrip> ViewerGrip::take(Simulation& simulation, const PickView& view, glm::vec2 place,
                                           const UnderPointer& under, bool body_first)
{
    const bool is_body = under.body && (body_first || !under.vertex);
    if (!is_body && !under.vertex) return std::nullopt;
    const glm::vec3 point = is_body ? unproject(view, glm::vec3(place, under.body_depth))
                                    : glm::vec3(simulation.state().positions[*under.vertex]);
    const PointDrag drag(point, view.camera.forward, ray_through(view.camera, place, view.size));
    const ViewerGrip grip(simulation, is_body, is_body ? *under.body : *under.vertex, drag);
    if (!grip.hold(simulation)) return std::nullopt;
    return grip;
}

void ViewerGrip::follow(Simulation& simulation, const PickView& view, glm::vec2 place)
{
    drag_.follow(ray_through(view.camera, place, view.size));
    hold(simulation);
}

bool ViewerGrip::hold(Simulation& simulation) const
{
    if (!is_body_) return simulation.hold_vertex(static_cast<std::uint32_t>(number_), drag_.target());
    simulation.hold_body(number_, start_way_ + glm::dvec3(drag_.target() - drag_.start()));
    return true;
}

void ViewerGrip::release(Simulation& simulation) const
{
    if (is_body_)
        simulation.release_body();
    else
        simulation.release_vertex();
}

std::string ViewerGrip::name() const { return fmt::format("{} {}", is_body_ ? "body" : "vertex", number_); }

std::optional<glm::vec3> ViewerGrip::place(Simulation& simulation) const
{
    if (is_body_) return drag_.start() + glm::vec3(way_of_hand(simulation, number_) - start_way_);
    const std::span<const glm::vec4> positions = simulation.state().positions;
    if (number_ >= positions.size()) return std::nullopt;
    return glm::vec3(positions[number_]);
}

}  // namespace nuno
