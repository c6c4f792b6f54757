// Mouse movements on the picture.
#include "app/viewer_pointer.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include "app/vertex_picker.h"

namespace nuno {
namespace {

constexpr float kReach = 20;  // how far from the cloth it is still taken

PickView pick_view(const ViewParams& view, glm::vec2 size) { return {make_camera(view, size.x / size.y), size}; }

}  // namespace

void ViewerPointer::handle(const std::vector<PointerEvent>& events, const PointerArea& area, ViewerSession& session)
{
    if (drag_ && session.start_count() != drag_start_count_) {
        drag_.reset();
        motion_ = Motion::none;
    }
    for (PointerEvent event : events) {
        const bool on_panel = area.is_on_panel(event.place);
        event.place -= area.corner;
        switch (event.kind) {
        case PointerEvent::Kind::press:
            if (!on_panel) press(event, area, session);
            break;
        case PointerEvent::Kind::release: release(event, session); break;
        case PointerEvent::Kind::move: move(event.place, area, session); break;
        case PointerEvent::Kind::scroll:
            if (on_panel) break;
            zoom(session.view(), event.steps);
            log_camera(session.view());
            break;
        }
    }
}

void ViewerPointer::press(const PointerEvent& event, const PointerArea& area, ViewerSession& session)
{
    if (busy()) return;
    button_ = event.button;
    last_place_ = event.place;
    if (button_ != GLFW_MOUSE_BUTTON_LEFT)
        motion_ = Motion::pan;
    else if (event.shift)
        toggle_pin(area, session);
    else
        motion_ = take_vertex(event.place, area, session) ? Motion::drag : Motion::orbit;
}

std::optional<std::uint32_t> ViewerPointer::vertex_under(glm::vec2 place, const PointerArea& area,
                                                         ViewerSession& session)
{
    if (session.went_bad()) return std::nullopt;
    Simulation& simulation = session.simulation();
    return pick_vertex(simulation.state().positions, simulation.model().faces, pick_view(session.view(), area.size),
                       place, kReach * area.scale);
}

void ViewerPointer::toggle_pin(const PointerArea& area, ViewerSession& session)
{
    if (const auto vertex = vertex_under(last_place_, area, session)) session.toggle_pin(*vertex);
}

bool ViewerPointer::take_vertex(glm::vec2 place, const PointerArea& area, ViewerSession& session)
{
    const auto vertex = vertex_under(place, area, session);
    if (!vertex) return false;
    Simulation& simulation = session.simulation();
    const PickView view = pick_view(session.view(), area.size);
    const glm::vec3 position(simulation.state().positions[*vertex]);
    drag_.emplace(*vertex, position, view.camera.forward, ray_through(view.camera, place, area.size));
    drag_start_count_ = session.start_count();
    simulation.hold_vertex(*vertex, drag_->target());
    log_.action("holding vertex {} at {:.4f} {:.4f} {:.4f}", *vertex, position.x, position.y, position.z);
    return true;
}

void ViewerPointer::move(glm::vec2 place, const PointerArea& area, ViewerSession& session)
{
    const glm::vec2 way = place - last_place_;
    last_place_ = place;
    switch (motion_) {
    case Motion::none: break;
    case Motion::drag:
        drag_->follow(ray_through(pick_view(session.view(), area.size).camera, place, area.size));
        session.simulation().hold_vertex(drag_->vertex(), drag_->target());
        break;
    case Motion::orbit: orbit(session.view(), way, area.size.y); break;
    case Motion::pan: pan(session.view(), way, area.size.y); break;
    }
}

void ViewerPointer::release(const PointerEvent& event, ViewerSession& session)
{
    if (!busy() || event.button != button_) return;
    if (drag_) {
        Simulation& simulation = session.simulation();
        const glm::vec3 position(simulation.state().positions[drag_->vertex()]);
        simulation.release_vertex();
        log_.action("released vertex {} at {:.4f} {:.4f} {:.4f}", drag_->vertex(), position.x, position.y, position.z);
        drag_.reset();
    } else {
        log_camera(session.view());
    }
    motion_ = Motion::none;
}

void ViewerPointer::log_camera(const ViewParams& view)
{
    log_.action("camera azimuth {:.2f} elevation {:.2f} distance {:.4f} target {:.4f} {:.4f} {:.4f}",
                view.camera_azimuth, view.camera_elevation, view.camera_distance, view.camera_target_x,
                view.camera_target_y, view.camera_target_z);
}

void ViewerPointer::draw_mark(const PointerArea& area, ViewerSession& session) const
{
    if (!drag_) return;
    // A restart may have left fewer vertices.
    const std::span<const glm::vec4> positions = session.simulation().state().positions;
    if (drag_->vertex() >= positions.size()) return;
    const PickView view = pick_view(session.view(), area.size);
    const auto place = project(view, glm::vec3(positions[drag_->vertex()])), target = project(view, drag_->target());
    if (!place || !target) return;
    const ImVec2 centre(area.corner.x + place->x, area.corner.y + place->y);
    const ImVec2 hand(area.corner.x + target->x, area.corner.y + target->y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine(centre, hand, IM_COL32(255, 210, 90, 150), 1.5f * area.scale);
    list.AddCircle(centre, 7 * area.scale, IM_COL32(20, 20, 20, 200), 0, 3.5f * area.scale);
    list.AddCircle(centre, 7 * area.scale, IM_COL32(255, 210, 90, 255), 0, 1.8f * area.scale);
}

}  // namespace nuno
