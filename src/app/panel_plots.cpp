// Plots: a title with the present values, and lines over time.
#include "app/panel_plots.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

#include "app/panel_controls.h"

namespace nuno {
namespace {

constexpr float kPlotHeight = 64;
constexpr ImU32 kBlue = IM_COL32(76, 155, 232, 255), kOrange = IM_COL32(240, 130, 80, 255),
                kGreen = IM_COL32(92, 184, 128, 255);

struct PlotLine
{
    const char* name;
    ImU32 colour;
    const ValueHistory& values;
    double zero = 0;  // what is drawn at the lower edge
};

// Names and present values in the colours of the lines.
void draw_title(std::span<const PlotLine> lines, const char* unit)
{
    for (const PlotLine& line : lines) {
        if (&line != &lines.front()) ImGui::SameLine();
        const double now = line.values.samples().empty() ? 0 : line.values.samples().back().value - line.zero;
        ImGui::PushStyleColor(ImGuiCol_Text, line.colour);
        const bool is_last = &line == &lines.back();
        ImGui::TextUnformatted(fmt::format("{} {:.2g}{}", line.name, now, is_last ? unit : "").c_str());
        ImGui::PopStyleColor();
    }
}

void draw_line(const PlotLine& line, double time_s, double axis, ImVec2 corner, ImVec2 size)
{
    std::vector<ImVec2> points;
    for (const ValueHistory::Sample& sample : line.values.samples()) {
        const double share = 1 - (time_s - sample.time_s) / ValueHistory::kSeconds;
        const double height = std::clamp((sample.value - line.zero) / axis, 0.0, 1.0);
        if (share >= 0 && share <= 1)
            points.emplace_back(corner.x + float(share) * size.x, corner.y + float(1 - height) * size.y);
    }
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), line.colour, 0, 1.5f);
}

void draw_plot(std::span<const PlotLine> lines, const char* unit, double time_s, float scale)
{
    draw_title(lines, unit);
    double highest = 0;
    for (const PlotLine& line : lines) highest = std::max(highest, line.values.highest() - line.zero);
    const double axis = round_axis(highest);
    const ImVec2 corner = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, kPlotHeight * scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, IM_COL32(18, 20, 24, 255));
    list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
    for (const PlotLine& line : lines) draw_line(line, time_s, axis, corner, size);
    list.PopClipRect();
    const std::string top = fmt::format("{:.3g}{}", axis, unit);
    list.AddText({corner.x + 4 * scale, corner.y + 2 * scale}, IM_COL32(255, 255, 255, 170), top.c_str());
    ImGui::Dummy(size);
}

}  // namespace

void PlottedValues::add(double time_s, const Diagnostics& measured)
{
    kinetic_j.add(time_s, measured.kinetic_j);
    elastic_j.add(time_s, measured.elastic_j);
    gravity_j.add(time_s, measured.gravity_j);
    strain_percent.add(time_s, 100 * measured.max_strain);
}

void PlottedValues::add(double time_s, const CollisionCounts& count)
{
    contacts.add(time_s, double(count.contacts));
    impacts.add(time_s, double(count.impacts));
}

void draw_plots(const PlottedValues& values, double time_s, ViewerLog& log, float scale)
{
    const PlotLine energies[] = {{"kinetic", kBlue, values.kinetic_j},
                                 {"elastic", kOrange, values.elastic_j},
                                 {"gravity", kGreen, values.gravity_j, values.gravity_j.lowest()}};
    draw_plot(energies, " J", time_s, scale);
    note_control(log, "plot energies");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Energies; that of gravity is over its lowest value here");
    const PlotLine strain[] = {{"largest strain", kBlue, values.strain_percent}};
    draw_plot(strain, " %", time_s, scale);
    note_control(log, "plot strain");
    const PlotLine counts[] = {{"contacts", kBlue, values.contacts}, {"impacts", kOrange, values.impacts}};
    draw_plot(counts, "", time_s, scale);
    note_control(log, "plot counts");
    ImGui::TextDisabled("the last %.0f simulated seconds", ValueHistory::kSeconds);
}

}  // namespace nuno
