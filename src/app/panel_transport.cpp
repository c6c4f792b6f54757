// The rows of the panel for time, for taking changes back, and for presets.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/panel.h"
#include "app/panel_controls.h"

namespace nuno {
namespace {

std::string speed_text(int slowness) { return slowness == 1 ? "1 x" : fmt::format("1/{} x", slowness); }

void draw_speed(ViewerSession& session, ViewerLog& log)
{
    const int slowness = session.time().slowness();
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##speed", speed_text(slowness).c_str());
    if (open) {
        for (int choice = 1; choice <= SessionTime::kMostSlowness; choice *= 2)
            if (ImGui::Selectable(speed_text(choice).c_str(), choice == slowness)) session.set_slowness(choice);
        ImGui::EndCombo();
    }
    note_control(log, "speed");
    if (ImGui::IsItemHovered() && !open) ImGui::SetTooltip("Slow motion (comma slower, period faster)");
}

void draw_scrub(ViewerSession& session, ViewerLog& log)
{
    bool keeps = session.time().keeps_frames();
    if (ImGui::Checkbox("##keep", &keeps)) session.keep_frames(keeps);
    note_control(log, "keep_frames");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Keeps the last 10 s, at most 256 MiB, to look back at.\n"
            "On the gpu backend this copies the cloth from the device every frame.");
    ImGui::SameLine();
    const Rewind& frames = session.time().frames();
    const bool can_scrub = frames.frame_count() > 1;
    int frame = session.simulation().frame();
    ImGui::SetNextItemWidth(-1);
    ImGui::BeginDisabled(!can_scrub);
    const int first = can_scrub ? frames.first_frame() : 0, last = can_scrub ? frames.last_frame() : 1;
    if (ImGui::SliderInt("##frame", &frame, first, last, can_scrub ? "frame %d" : "no frames kept",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
        session.show_frame(frame);
    ImGui::EndDisabled();
    note_control(log, "frame");
}

}  // namespace

bool draw_transport(ViewerSession& session, ViewerLog& log)
{
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 4 * gap) / 5;
    const ParamHistory& history = session.history();
    if (button(log, "Back", "Shows the frame before (Left)", width))
        session.show_frame(session.simulation().frame() - 1);
    ImGui::SameLine();
    ImGui::BeginDisabled(!history.can_undo());
    const std::string undo = history.can_undo() ? "Takes back " + history.undo_name() + " (Ctrl+Z)" : "";
    if (button(log, "Undo", undo.c_str(), width)) session.undo();
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!history.can_redo());
    const std::string redo = history.can_redo() ? "Sets " + history.redo_name() + " again (Ctrl+Y)" : "";
    if (button(log, "Redo", redo.c_str(), width)) session.redo();
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool save = button(log, "Save", "Writes the cloth as it is as a scene (Ctrl+S)", width);
    ImGui::SameLine();
    draw_speed(session, log);
    draw_scrub(session, log);
    return save;
}

void draw_presets(ViewerSession& session, ViewerLog& log)
{
    const bool open = ImGui::CollapsingHeader("presets");
    note_control(log, "group presets");
    if (!open) return;
    const PresetKind* row = nullptr;
    for (const Preset& preset : preset_table()) {
        if (row && *row == preset.kind) ImGui::SameLine();
        row = &preset.kind;
        const std::string name(preset.name), help(preset.help);
        if (button(log, name.c_str(), help.c_str())) session.use_preset(preset);
    }
}

std::vector<std::string> saved_scene_names()
{
    std::vector<std::string> names;
    std::error_code status;
    for (const auto& entry : std::filesystem::directory_iterator(".", status)) {
        std::filesystem::path path = entry.path().filename();
        if (path.extension() != ".toml") continue;
        const std::string name = path.string();
        if (exists(path.replace_extension(".state"), status)) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace nuno
