// The list of keys.
#include <imgui.h>

#include <span>
#include <utility>

#include "app/panel.h"

namespace nuno {
namespace {

using Line = std::pair<const char*, const char*>;
constexpr Line kMouse[] = {{"Left drag on the cloth", "drags the nearest vertex"},
                           {"Left drag on a body", "moves it; Ctrl: also under cloth"},
                           {"Left drag elsewhere", "turns the camera"},
                           {"Right or middle drag", "moves the picture"},
                           {"Wheel", "nearer, farther"},
                           {"Ctrl-click on a slider", "types a value"},
                           {".toml dropped here", "shows that scene"}};
constexpr Line kKeys[] = {{"Space", "pause, play"},
                          {"N or Right", "one frame"},
                          {"Left", "one frame back"},
                          {"R", "restart"},
                          {"P or Shift+click", "pin or let go of a vertex"},
                          {", and .", "slower, faster"},
                          {"Ctrl+Z", "undo a change"},
                          {"Ctrl+Y, Ctrl+Shift+Z", "redo it"},
                          {"Ctrl+S", "save as a scene"},
                          {"F", "show all of the cloth"},
                          {"V", "record, and stop"},
                          {"S or F12", "photo: nuno_0001.png, ..."},
                          {"Tab", "hide or show the panels"},
                          {"1, 2", "wireframe, springs"},
                          {"3, 4", "colours: strain, speed"},
                          {"5, 6", "contacts, tree boxes"},
                          {"7, 8", "colours: culled, asleep"},
                          {"9, 0", "pins, wind"},
                          {"H or F1", "this list"},
                          {"Q or Esc", "close"}};

void draw_lines(const char* title, std::span<const Line> lines)
{
    if (!ImGui::BeginTable(title, 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const auto& [left, right] : lines) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(left);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", right);
    }
    ImGui::EndTable();
}

}  // namespace

void begin_help(bool& open)
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("Keys and mouse", &open, flags)) {
        draw_lines("keys", kKeys);
        ImGui::Separator();
        draw_lines("mouse", kMouse);
    }
}

}  // namespace nuno
