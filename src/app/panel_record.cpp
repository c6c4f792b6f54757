// The section for recording.
#include <fmt/format.h>
#include <imgui.h>

#include "app/panel.h"
#include "app/panel_controls.h"

namespace nuno {

void draw_record(ViewerSession& session, ViewerLog& log)
{
    const bool open = ImGui::CollapsingHeader("record");
    note_control(log, "group record");
    if (!open) return;
    RecordingPlan& plan = session.recording_plan();
    const bool is_on = session.recording().is_on();
    ImGui::BeginDisabled(is_on);
    if (ImGui::RadioButton("pictures", plan.kind == RecordingKind::pictures)) plan.kind = RecordingKind::pictures;
    note_control(log, "record pictures");
    ImGui::SameLine();
    if (ImGui::RadioButton("video", plan.kind == RecordingKind::video)) plan.kind = RecordingKind::video;
    note_control(log, "record video");
    ImGui::SameLine();
    ImGui::Checkbox("OBJ + PC2", &plan.point_cache);
    note_control(log, "record meshes");
    ImGui::EndDisabled();
    if (button(log, is_on ? "Stop" : "Record", "One picture for each simulated frame, without the panels (V)"))
        session.toggle_recording();
    if (!session.recording().is_on()) return;
    ImGui::SameLine();
    ImGui::TextColored(
        {0.95f, 0.45f, 0.42f, 1}, "%s",
        fmt::format("{} frames in {}", session.recording().frame_count(), session.recording().directory().string())
            .c_str());
}

}  // namespace nuno
