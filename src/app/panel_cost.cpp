// What the frames cost, and what the cloth is doing.
#include <fmt/format.h>
#include <imgui.h>

#include "app/panel.h"
#include "app/panel_controls.h"

namespace nuno {
namespace {

constexpr float kGraphHeight = 90;
constexpr std::size_t kRows = (kGraphStages + 1) / 2;  // of the two columns of stages

void text_pair(const char* name, const std::string& value)
{
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
}

void draw_pace(const ViewerSession& session, const ViewerMeters& meters)
{
    std::string text = fmt::format("{:.0f} frames/s", meters.pace.frames_per_second());
    text += session.paused() ? ", paused" : fmt::format(", {:.2f} x real time", meters.pace.real_time_factor());
    ImGui::TextUnformatted(text.c_str());
    const std::string device = meters.gl.renderer + (meters.gl.software ? " (software: CPU times)" : "");
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", device.c_str());
    ImGui::PopStyleColor();
}

std::string ms_text(float ms)
{
    return ms < 10 ? fmt::format("{:.2f}", ms) : ms < 100 ? fmt::format("{:.1f}", ms) : fmt::format("{:.0f}", ms);
}

void draw_stage(const StageHistory& stages, std::size_t stage)
{
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize() * 0.7f, top = corner.y + ImGui::GetFontSize() * 0.2f;
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + side, top + side}, graph_stage_colour(stage),
                                              2);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side * 1.5f);
    ImGui::TextUnformatted(std::string(graph_stage_name(stage)).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(ms_text(stages.smoothed_ms(stage)).c_str());
}

// Two columns of stages, filled downwards.
void draw_stages(const StageHistory& stages)
{
    if (!ImGui::BeginTable("stages", 4, ImGuiTableFlags_SizingStretchProp)) return;
    for (std::size_t row = 0; row < kRows; ++row) {
        draw_stage(stages, row);
        if (row + kRows < kGraphStages) draw_stage(stages, row + kRows);
    }
    ImGui::EndTable();
    ImGui::TextDisabled("%s", fmt::format("{:.1f} ms a frame of the window", stages.smoothed_sum_ms()).c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Above: ms for each simulated frame; of render and panel, for each frame of the window.\n"
            "A window that is slower than the cloth shows several simulated frames at once.");
}

// The longest substep of each explicit method that is stable where the cloth is now.
void draw_stability(const SimParams& params, const PresentStability& stability)
{
    const bool any = stability.largest_stable_substep_s >= kAnySubstep;
    ImGui::TextDisabled("%s", any ? "stable substeps (any with this method)" : "stable substeps");
    if (!ImGui::BeginTable("stability", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (std::size_t i = 0; i < kExplicitMethods.size(); ++i) {
        const double limit_s = stability.stable_substep_s[i];
        const bool here = kExplicitMethods[i] == params.method;
        text_pair(
            choice_names(Method{})[std::size_t(kExplicitMethods[i])].data(),
            (limit_s > 0 ? fmt::format("up to {:.3g} ms", 1000 * limit_s) : std::string("none")) + (here ? "  <" : ""));
    }
    ImGui::EndTable();
}

// What the levels that look at whole ways did; nothing where nothing met.
void draw_impacts(const CollisionCounts& count)
{
    if (count.impacts == 0 && count.unresolved == 0) return;
    text_pair("impacts", fmt::format("{}", count.impacts));
    text_pair("went back", fmt::format("{} times, {} vertices at most", count.rollbacks, count.largest_zone));
    if (count.held_back > 0) text_pair("handles held back", fmt::format("{} vertices", count.held_back));
    text_pair("unresolved", fmt::format("{}", count.unresolved));
}

void draw_cloth_numbers(const SimParams& params, ViewerMeters& meters, ViewerLog& log)
{
    ImGui::Checkbox("energy and strain", &meters.measure);
    note_control(log, "measure");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Measured every few frames; on the gpu backend this copies the cloth from the device.");
    if (!ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingFixedFit)) return;
    text_pair("contacts", fmt::format("{}", meters.count.contacts));
    text_pair("pairs tested", fmt::format("{}", meters.count.pairs_tested));
    draw_impacts(meters.count);
    if (meters.diagnostics) {
        const Diagnostics& d = *meters.diagnostics;
        text_pair("kinetic energy", fmt::format("{:.4g} J", d.kinetic_j));
        text_pair("elastic energy", fmt::format("{:.4g} J", d.elastic_j));
        text_pair("gravity energy", fmt::format("{:.4g} J", d.gravity_j));
        text_pair("largest strain", fmt::format("{:.1f} %", 100 * d.max_strain));
        text_pair("highest speed", fmt::format("{:.2f} m/s", d.max_speed));
    }
    const bool stability = meters.diagnostics && meters.stability;
    if (stability) {
        text_pair("substeps", fmt::format("{} of {:.3g} ms", params.substeps, 1000 * double(substep_s(params))));
        text_pair("highest frequency", fmt::format("{:.4g} rad/s", meters.stability->omega_max));
    }
    ImGui::EndTable();
    if (stability) draw_stability(params, *meters.stability);
}

}  // namespace

void draw_cost_panel(const ViewerSession& session, ViewerMeters& meters, ViewerLog& log, float scale)
{
    draw_pace(session, meters);
    draw_stage_graph(meters.stages, ImGui::GetContentRegionAvail().x, kGraphHeight * scale);
    draw_stages(meters.stages);
    ImGui::Separator();
    draw_cloth_numbers(session.simulation().params(), meters, log);
}

}  // namespace nuno
