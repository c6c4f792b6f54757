// Pieces that several panels draw.
#include "app/panel_controls.h"

#include <imgui.h>

#include <cmath>

namespace nuno {

void note_control(ViewerLog& log, const std::string& name)
{
    if (!log.enabled() || !ImGui::IsItemVisible()) return;
    const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    log.control(name, glm::ivec4(std::lround(low.x), std::lround(low.y), std::lround(size.x), std::lround(size.y)));
}

bool button(ViewerLog& log, const char* text, const char* tooltip, float width)
{
    const bool pressed = ImGui::Button(text, {width, 0});
    note_control(log, std::string("button ") + text);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip);
    return pressed;
}

}  // namespace nuno
