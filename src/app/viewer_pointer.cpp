// Mouse movements on the picture.
#include "app/viewer_pointer.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "core/error.h"

namespace nuno {
namespace {

constexpr float kReach = 20;  // how far from the cloth it is still taken

PickView pick_view(const ViewParams& view, glm::vec2 size) { return {make_camera(view, size.x / size.y), size}; }

UnderPointer under_pointer(glm::vec2 place, const PointerArea& area, ViewerSession& session)
{
    return look_under(session.simulation(), pick_view(session.view(), area.size), place, kReach * area.scale);
}

}  // namespace

void ViewerPointer::handle(const std::vector<PointerEvent>& events, const PointerArea& area, ViewerSession& session)
{
    if (grip_ && session.start_count() != grip_start_count_) {
        grip_.reset();
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
        motion_ = take(event, area, session) ? Motion::drag : Motion::orbit;
}

void ViewerPointer::toggle_pin(const PointerArea& area, ViewerSession& session)
{
    if (session.went_bad()) return;
    const UnderPointer under = under_pointer(last_place_, area, session);
    if (under.vertex) session.toggle_pin(*under.vertex);
}

bool ViewerPointer::take(const PointerEvent& event, const PointerArea& area, ViewerSession& session)
{
    if (session.went_bad()) return false;
    const UnderPointer under = under_pointer(event.place, area, session);
    Simulation& simulation = session.simulation();
    try {
        grip_ = ViewerGrip::take(simulation, pick_view(session.view(), area.size), event.place, under, event.control);
    } catch (const Error& error) {
        session.note_error(error);
    }
    if (!grip_) return false;
    grip_start_count_ = session.start_count();
    const glm::vec3 point = grip_->target();
    log_.action("holding {} at {:.4f} {:.4f} {:.4f}", grip_->name(), point.x, point.y, point.z);
    return true;
}

void ViewerPointer::move(glm::vec2 place, const PointerArea& area, ViewerSession& session)
{
    const glm::vec2 way = place - last_place_;
    last_place_ = place;
    switch (motion_) {
    case Motion::none: break;
    case Motion::drag: drag(area, session); break;
    case Motion::orbit: orbit(session.view(), way, area.size.y); break;
    case Motion::pan: pan(session.view(), way, area.size.y); break;
    }
}

void ViewerPointer::drag(const PointerArea& area, ViewerSession& session)
{
    try {
        grip_->follow(session.simulation(), pick_view(session.view(), area.size), last_place_);
    } catch (const Error& error) {
        session.note_error(error);
    }
}

void ViewerPointer::release(const PointerEvent& event, ViewerSession& session)
{
    if (!busy() || event.button != button_) return;
    if (grip_) {
        Simulation& simulation = session.simulation();
        const glm::vec3 point = grip_->place(simulation).value_or(grip_->target());
        grip_->release(simulation);
        log_.action("released {} at {:.4f} {:.4f} {:.4f}", grip_->name(), point.x, point.y, point.z);
        grip_.reset();
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
    if (!grip_) return;
    const std::optional<glm::vec3> point = grip_->place(session.simulation());
    if (!point) return;
    const PickView view = pick_view(session.view(), area.size);
    const auto place = project(view, *point), target = project(view, grip_->target());
    if (!place || !target) return;
    const ImVec2 centre(area.corner.x + place->x, area.corner.y + place->y);
    const ImVec2 hand(area.corner.x + target->x, area.corner.y + target->y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine(centre, hand, IM_COL32(255, 210, 90, 150), 1.5f * area.scale);
    list.AddCircle(centre, 7 * area.scale, IM_COL32(20, 20, 20, 200), 0, 3.5f * area.scale);
    list.AddCircle(centre, 7 * area.scale, IM_COL32(255, 210, 90, 255), 0, 1.8f * area.scale);
}

}  // namespace nuno
