// The panel: scene, buttons, messages, parameters.
#include "app/panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panel_controls.h"
#include "app/panel_legend.h"
#include "core/error.h"

namespace nuno {
namespace {

constexpr float kMargin = 10, kSideWidth = 400, kCostWidth = 280;
constexpr float kRoomForCost = 1.8f;  // widths of the picture at which it is open at first
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

ParamRows::Kind kind_of_sim_row(const ParamInfo& info)
{
    if (needs_restart(info.name)) return ParamRows::Kind::restarts;
    // Each number of threads is another pool of them.
    return info.name == "threads" ? ParamRows::Kind::on_release : ParamRows::Kind::live;
}

// The size of the picture is that of the window.
ParamRows::Kind kind_of_view_row(const ParamInfo& info)
{
    const bool of_window = info.name == "width" || info.name == "height";
    return of_window ? ParamRows::Kind::hidden : ParamRows::Kind::live;
}

}  // namespace

void Panel::lay_out(glm::vec2 size, float scale)
{
    place_again_ = size != size_ || scale != scale_;
    if (scale != scale_) width_ = kSideWidth * scale;
    width_ = std::min(width_, 0.5f * size.x);
    size_ = size;
    scale_ = scale;
}

PanelRequests Panel::draw(ViewerSession& session, ViewerMeters& meters)
{
    PanelRequests requests;
    places_.clear();
    if (visible) {
        requests = draw_side(session);
        draw_cost(session, meters);
        draw_plot_window(session, meters.plots);
    }
    const float free_height = draw_messages(session);
    draw_legend(session.legend(), {{covered_width(), 0}, {size_.x, free_height}, scale_}, log_);
    if (help) {
        begin_help(help);
        note_place();
        ImGui::End();
    }
    return requests;
}

// Its right edge can be dragged.
PanelRequests Panel::draw_side(ViewerSession& session)
{
    PanelRequests requests;
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                   ImGuiWindowFlags_NoBackground;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSizeConstraints({std::min(200 * scale_, 0.5f * size_.x), size_.y}, {0.5f * size_.x, size_.y});
    ImGui::SetNextWindowSize({width_, size_.y}, place_again_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin("side", nullptr, flags);
    ImGui::PopStyleVar();
    note_place();
    width_ = ImGui::GetWindowWidth();
    draw_scene_list(session);
    requests = draw_buttons(session);
    requests.save = draw_transport(session, log_);
    const Simulation& simulation = session.simulation();
    const std::string state =
        fmt::format("{:.2f} s, frame {}, {}", simulation.time_s(), simulation.frame(), simulation.solver_name());
    ImGui::TextUnformatted(state.c_str());
    ImGui::Spacing();
    ImGui::BeginChild("parameters");
    draw_trade_slider(session, log_);
    draw_parameters(session);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) session.end_drag();
    ImGui::EndChild();
    ImGui::End();
    return requests;
}

// As high as its contents, and where the user moved it until the window changes.
void Panel::draw_cost(const ViewerSession& session, ViewerMeters& meters)
{
    const float margin = kMargin * scale_;
    const float width = std::min(kCostWidth * scale_, size_.x - width_ - 2 * margin);
    ImGui::SetNextWindowPos({size_.x - margin - width, margin},
                            place_again_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({width, 0});
    // In a small window it would hide the cloth.
    ImGui::SetNextWindowCollapsed(size_.x - width_ < kRoomForCost * width,
                                  place_again_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("Cost", nullptr, flags)) draw_cost_panel(session, meters, log_, scale_);
    note_place();
    ImGui::End();
}

// Its title alone at first, beside the costs or, in a small window, under them.
void Panel::draw_plot_window(const ViewerSession& session, const PlottedValues& values)
{
    const float margin = kMargin * scale_, free_width = size_.x - width_;
    const float width = std::min(kCostWidth * scale_, free_width - 2 * margin);
    const bool is_beside = free_width >= 2 * width + 3 * margin;
    const ImVec2 corner = is_beside ? ImVec2(size_.x - 2 * (margin + width), margin)
                                    : ImVec2(size_.x - margin - width, 1.5f * margin + ImGui::GetFrameHeight());
    ImGui::SetNextWindowPos(corner, place_again_ ? ImGuiCond_Always : ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({width, 0});
    ImGui::SetNextWindowCollapsed(true, ImGuiCond_FirstUseEver);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("Plots", nullptr, flags)) draw_plots(values, session.simulation().time_s(), log_, scale_);
    // The arrow of its title.
    const ImVec2 place = ImGui::GetWindowPos();
    const float side = ImGui::GetFrameHeight();
    log_.control("plots", glm::ivec4(place.x, place.y, side, side));
    note_place();
    ImGui::End();
}

void Panel::draw_scene_list(ViewerSession& session)
{
    const std::string present = session.simulation().scene().name;
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##scene", present.c_str(), ImGuiComboFlags_HeightLarge);
    if (open) {
        if (ImGui::IsWindowAppearing()) {
            scenes_ = saved_scene_names();
            const std::vector<std::string> others = scene_names();
            scenes_.insert(scenes_.end(), others.begin(), others.end());
        }
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
float Panel::draw_messages(ViewerSession& session)
{
    if (session.error().empty() && !session.stability_warning() && notice.empty()) return size_.y;
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                             ImGuiWindowFlags_NoNav;
    const float left = covered_width(), margin = kMargin * scale_;
    ImGui::SetNextWindowPos({(left + size_.x) / 2, size_.y - margin}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSize({std::clamp(size_.x - left - 2 * margin, 200 * scale_, 600 * scale_), 0});
    // News alone has no buttons, and lets the mouse through.
    const bool has_buttons = !session.error().empty() || session.stability_warning();
    if (!has_buttons) flags |= ImGuiWindowFlags_NoMouseInputs;
    ImGui::Begin("messages", nullptr, flags);
    if (has_buttons) note_place();
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
    const float top = ImGui::GetWindowPos().y;
    ImGui::End();
    return top;
}

void Panel::note_place()
{
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const float edge = 4;  // around a window, by which ImGui lets it be resized
    places_.emplace_back(corner.x - edge, corner.y - edge, corner.x + size.x + edge, corner.y + size.y + edge);
}

bool Panel::covers(glm::vec2 place) const
{
    return std::any_of(places_.begin(), places_.end(), [&](const glm::vec4& p) {
        return place.x >= p.x && place.y >= p.y && place.x < p.z && place.y < p.w;
    });
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
    const SimParams params = session.simulation().asked_params(), scene_params = session.file_params();
    const ParamRows rows{sim_param_table(), &params, &scene_params, kind_of_sim_row};
    for (const std::string_view group : ordered_groups(sim_param_table()))
        if (const auto edit = params_.draw_group(rows, group, opens_at_first(group)))
            session.set_sim_param(*edit->info, edit->value);
    draw_presets(session, log_);
    draw_record(session, log_);

    const ViewParams view = session.view();
    const ParamRows view_rows{view_param_table(), &view, &session.file_view(), kind_of_view_row};
    for (const std::string_view group : ordered_groups(view_param_table()))
        if (const auto edit = params_.draw_group(view_rows, group, false))
            session.set_view_param(*edit->info, edit->value);
}

}  // namespace nuno
