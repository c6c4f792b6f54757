// The panel: scene, buttons, messages, parameters.
#include "app/panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panel_controls.h"
#include "core/error.h"

namespace nuno {
namespace {

constexpr float kMargin = 10, kParameterWidth = 410, kCostWidth = 310;
constexpr std::array<std::string_view, 2> kOpenGroups{"wind", "stiffness"};

bool opens_at_first(std::string_view group)
{
    return std::find(kOpenGroups.begin(), kOpenGroups.end(), group) != kOpenGroups.end();
}

void text_line(ImVec4 colour, const std::string& text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

// Those that are open at first, then the others.
std::vector<std::string_view> ordered_groups(ParamTable table)
{
    std::vector<std::string_view> groups = param_groups(table);
    std::stable_partition(groups.begin(), groups.end(), opens_at_first);
    return groups;
}

}  // namespace

PanelRequests Panel::draw(ViewerSession& session, ViewerMeters& meters, float scale)
{
    const glm::vec2 display(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
    place_again_ = placed_for_ != display || scale_ != scale;
    placed_for_ = display;
    scale_ = scale;
    PanelRequests requests;
    const float margin = kMargin * scale;
    float left = 0, right = display.x;  // of the picture between the panels
    if (visible) {
        left = std::min(kParameterWidth * scale, 0.5f * display.x) + margin;
        right -= std::min(kCostWidth * scale, 0.4f * display.x) + margin;
        place_window(margin, margin, left - margin, display.y - 2 * margin);
        requests = draw_scene_panel(session);
        place_window(right, margin, display.x - margin - right, 0);
        const ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
        if (ImGui::Begin("Cost", nullptr, flags)) draw_cost_panel(session, meters, log_, scale);
        ImGui::End();
    }
    ImGui::SetNextWindowPos({(left + right) / 2, display.y - margin}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSize({std::clamp(right - left - 2 * margin, 300 * scale, 560 * scale), 0});
    draw_messages(session);
    if (help) draw_help(help);
    return requests;
}

PanelRequests Panel::draw_scene_panel(ViewerSession& session)
{
    PanelRequests requests;
    if (ImGui::Begin("Scene", nullptr, ImGuiWindowFlags_NoSavedSettings)) {
        draw_scene_list(session);
        requests = draw_buttons(session);
        const Simulation& simulation = session.simulation();
        const std::string state =
            fmt::format("{:.2f} s, frame {}, {}", simulation.time_s(), simulation.frame(), simulation.solver_name());
        ImGui::TextUnformatted(state.c_str());
        ImGui::Spacing();
        ImGui::BeginChild("parameters");
        draw_parameters(session);
        ImGui::EndChild();
    }
    ImGui::End();
    return requests;
}

// Where the window's size or the scale has changed, else where the user left it. No height: as high as its contents.
void Panel::place_window(float x, float y, float width, float height) const
{
    const ImGuiCond when = place_again_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver;
    ImGui::SetNextWindowPos({x, y}, when);
    ImGui::SetNextWindowSize({width, height}, height > 0 ? when : ImGuiCond_Always);
}

void Panel::draw_scene_list(ViewerSession& session)
{
    const std::string present = session.simulation().scene().name;
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##scene", present.c_str(), ImGuiComboFlags_HeightLarge);
    if (open) {
        if (ImGui::IsWindowAppearing()) scenes_ = scene_names();
        for (const std::string& name : scenes_) {
            if (ImGui::Selectable(name.c_str(), name == present)) session.load(name);
            note_control(log_, "scene=" + name);
        }
        ImGui::EndCombo();
    }
    note_control(log_, "scene");
    if (ImGui::IsItemHovered() && !open)
        ImGui::SetTooltip("The scene. A .toml file dropped on the window is shown as well.");
    if (const std::string& title = session.simulation().scene().title; !title.empty())
        text_line(ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled), title);
}

PanelRequests Panel::draw_buttons(ViewerSession& session)
{
    PanelRequests requests;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 4 * gap) / 5;
    if (session.paused()) {
        if (button(log_, "Play", "Runs the cloth (Space)", width)) session.set_paused(false);
    } else {
        if (button(log_, "Pause", "Holds the cloth still (Space)", width)) session.set_paused(true);
    }
    ImGui::SameLine();
    if (button(log_, "Step", "Simulates one frame (N or Right)", width)) session.step();
    ImGui::SameLine();
    if (button(log_, "Restart", "Starts the scene again (R)", width)) session.restart();
    ImGui::SameLine();
    requests.screenshot =
        button(log_, "Photo", "Writes the window as a PNG file into the working directory (S)", width);
    ImGui::SameLine();
    if (button(log_, "Help", "Keys and mouse (H)", width)) help = !help;
    return requests;
}

// Over the picture, so that the rows of the panel stay under the mouse.
void Panel::draw_messages(ViewerSession& session)
{
    if (session.error().empty() && !session.stability_warning() && notice.empty()) return;
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                        ImGuiWindowFlags_NoNav;
    ImGui::Begin("messages", nullptr, kFlags);
    if (!session.error().empty()) {
        text_line({1.0f, 0.45f, 0.42f, 1}, session.error());
        if (session.went_bad() ? message_button("Restart") : message_button("Dismiss"))
            session.went_bad() ? session.restart() : session.dismiss_error();
    }
    if (session.stability_warning()) {
        // What went bad says the same already.
        if (!session.went_bad()) text_line({0.95f, 0.77f, 0.36f, 1}, *session.stability_warning());
        if (session.went_bad()) ImGui::SameLine();
        const int substeps = session.stable_substeps();
        if (substeps > 0 && message_button(fmt::format("Use {} substeps", substeps))) session.use_stable_substeps();
    }
    if (!notice.empty()) text_line({0.56f, 0.80f, 0.60f, 1}, notice);
    ImGui::End();
}

bool Panel::message_button(const std::string& text)
{
    const bool pressed = ImGui::Button(text.c_str());
    note_control(log_, "message " + text);
    return pressed;
}

void Panel::draw_parameters(ViewerSession& session)
{
    // A row acts after all are drawn: a change may build another cloth.
    const SimParams params = session.simulation().params(), scene_params = session.file_params();
    const auto rebuilds = [](const ParamInfo& info) { return needs_restart(info.name) || info.name == "threads"; };
    const ParamRows rows{sim_param_table(), &params, &scene_params, rebuilds};
    for (const std::string_view group : ordered_groups(sim_param_table()))
        if (const auto edit = params_.draw_group(rows, group, opens_at_first(group)))
            session.set_sim_param(*edit->info, edit->value);

    const ViewParams view = session.view();
    const ParamRows view_rows{view_param_table(), &view, &session.file_view(), [](const ParamInfo&) { return false; }};
    for (const std::string_view group : ordered_groups(view_param_table()))
        if (const auto edit = params_.draw_group(view_rows, group, false))
            session.set_view_param(*edit->info, edit->value);
}

}  // namespace nuno
