// The legend of the overlays.
#include "app/panel_legend.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panel_controls.h"
#include "render/colour_map.h"

namespace nuno {
namespace {

constexpr float kWidth = 270, kMargin = 10;
constexpr int kBarSteps = 48;

ImU32 colour_of(glm::vec3 colour) { return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1}); }

// The colours from 0 to the top with numbers below, and a notch at the largest number in the picture.
void draw_bar(const LegendScale& scale)
{
    const std::string title = fmt::format("{} [{}], now up to {:.3g}", scale.title, scale.unit, scale.largest);
    ImGui::TextUnformatted(title.c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFontSize() * 0.8f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < kBarSteps; ++i) {
        const float left = width * float(i) / kBarSteps, right = width * float(i + 1) / kBarSteps;
        list.AddRectFilled({corner.x + left, corner.y}, {corner.x + right, corner.y + height},
                           colour_of(viridis((float(i) + 0.5f) / kBarSteps)));
    }
    const float notch = corner.x + width * static_cast<float>(std::clamp(scale.largest / scale.top, 0.0, 1.0));
    list.AddLine({notch, corner.y - 2}, {notch, corner.y + height + 2}, IM_COL32_WHITE, 2);
    ImGui::Dummy({width, height});
    const float start = ImGui::GetCursorPosX();
    for (const double part : {0.0, 0.5, 1.0}) {
        const bool over = part == 1 && scale.largest > scale.top;
        const std::string number = fmt::format("{:.3g}{}", part * scale.top, over ? " +" : "");
        const float room = width - ImGui::CalcTextSize(number.c_str()).x;
        if (part > 0) ImGui::SameLine();
        ImGui::SetCursorPosX(start + static_cast<float>(part) * room);
        ImGui::TextDisabled("%s", number.c_str());
    }
}

void draw_row(const LegendRow& row)
{
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize() * 0.7f, top = corner.y + ImGui::GetFontSize() * 0.2f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({corner.x, top}, {corner.x + side, top + side}, colour_of(row.colour), 2);
    list.AddRect({corner.x, top}, {corner.x + side, top + side}, IM_COL32(150, 155, 165, 255), 2);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side * 1.5f);
    ImGui::TextWrapped("%s", row.text.c_str());
}

}  // namespace

void draw_legend(const OverlayLegend& legend, const LegendPlace& place, ViewerLog& log)
{
    if (legend.empty()) return;
    const float margin = kMargin * place.scale;
    const float width = std::min(kWidth * place.scale, place.high.x - place.low.x - 2 * margin);
    ImGui::SetNextWindowPos({place.low.x + margin, place.high.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::SetNextWindowBgAlpha(0.94f);
    const ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin("legend", nullptr, flags);
    ImGui::BeginGroup();
    if (legend.scale) draw_bar(*legend.scale);
    for (const LegendRow& row : legend.rows) draw_row(row);
    for (const std::string& remark : legend.remarks) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextWrapped("%s", remark.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::EndGroup();
    note_control(log, "legend");
    ImGui::End();
}

}  // namespace nuno
