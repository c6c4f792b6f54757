// The rows of parameter tables as ImGui widgets.
#include "app/panel_params.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "app/panel_controls.h"

namespace nuno {
namespace {

constexpr float kNameWidth = 0.42f;  // share of a row
constexpr double kTooltipAfterMs = 500;

std::string spaced(std::string_view name)
{
    std::string text(name);
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

// A slider takes digits for its own scale from a format; a text without one leaves the value unrounded and starts a
// logarithmic scale that includes 0 at 0.001.
std::string slider_format(const ParamInfo& info, float value)
{
    const std::string unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
    const bool tiny = info.default_value != 0 && std::abs(info.default_value) < 1e-3;
    return tiny ? "%.7g" + unit : param_text(info, value) + unit;
}

std::optional<double> draw_real(const ParamInfo& info, double value)
{
    float edited = static_cast<float>(value);
    const float least = static_cast<float>(info.min), most = static_cast<float>(info.max);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (is_logarithmic(info)) flags |= ImGuiSliderFlags_Logarithmic;
    if (!ImGui::SliderFloat("##value", &edited, least, most, slider_format(info, edited).c_str(), flags))
        return std::nullopt;
    // What was typed is meant to the last digit.
    return ImGui::IsMouseDown(ImGuiMouseButton_Left) ? rounded_by_slider(info, edited) : double(edited);
}

// In 64 bits: ImGui's sliders refuse a range wider than half of what their type holds.
std::optional<double> draw_integer(const ParamInfo& info, double value)
{
    auto edited = static_cast<std::int64_t>(value);
    const auto least = static_cast<std::int64_t>(info.min), most = static_cast<std::int64_t>(info.max);
    const std::string format = info.unit.empty() ? "%lld" : fmt::format("%lld {}", info.unit);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (is_logarithmic(info)) flags |= ImGuiSliderFlags_Logarithmic;
    if (!ImGui::SliderScalar("##value", ImGuiDataType_S64, &edited, &least, &most, format.c_str(), flags))
        return std::nullopt;
    return static_cast<double>(edited);
}

std::optional<double> draw_boolean(double value)
{
    bool edited = value != 0;
    if (!ImGui::Checkbox("##value", &edited)) return std::nullopt;
    return edited ? 1 : 0;
}

std::optional<double> draw_choice(const ParamInfo& info, double value, ViewerLog& log)
{
    std::optional<double> chosen;
    if (!ImGui::BeginCombo("##value", param_text(info, value).c_str())) return chosen;
    for (std::size_t i = 0; i < info.choices.size(); ++i) {
        const std::string name(info.choices[i]);
        if (ImGui::Selectable(name.c_str(), double(i) == value)) chosen = static_cast<double>(i);
        note_control(log, fmt::format("{}={}", info.name, name));
    }
    ImGui::EndCombo();
    return chosen;
}

std::optional<double> draw_value(const ParamInfo& info, double value, ViewerLog& log)
{
    switch (info.type) {
    case ParamType::real: return draw_real(info, value);
    case ParamType::integer: return draw_integer(info, value);
    case ParamType::boolean: return draw_boolean(value);
    case ParamType::choice: return draw_choice(info, value, log);
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::string_view> param_groups(ParamTable table)
{
    std::vector<std::string_view> groups;
    for (const ParamInfo& info : table)
        if (std::find(groups.begin(), groups.end(), info.group) == groups.end()) groups.push_back(info.group);
    return groups;
}

bool is_logarithmic(const ParamInfo& info)
{
    if (info.min > 0) return info.max / info.min >= 1000;
    const double most = std::max(-info.min, info.max);
    return most >= 1000 || (info.default_value != 0 && most / std::abs(info.default_value) >= 100);
}

double rounded_by_slider(const ParamInfo& info, double value)
{
    if (value == 0) return value;
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
    // As a float whose shortest text is the rounded number.
    return static_cast<float>(std::clamp(std::round(value / digit) * digit, info.min, info.max));
}

std::optional<ParamEdit> ParamPanel::draw_group(const ParamRows& rows, std::string_view group, bool open_at_first)
{
    const std::string title(group);
    const bool open = ImGui::CollapsingHeader(title.c_str(),
                                              open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    note_control(log_, "group " + title);
    std::optional<ParamEdit> edit;
    for (const ParamInfo& info : rows.table) {
        if (!open || info.group != group) continue;
        const ParamRows::Kind kind = rows.kind(info);
        if (kind == ParamRows::Kind::hidden) continue;
        if (const auto row = draw_row(rows, info, kind)) edit = row;
    }
    return edit;
}

std::optional<ParamEdit> ParamPanel::draw_row(const ParamRows& rows, const ParamInfo& info, ParamRows::Kind kind)
{
    const double value = param_value(info, rows.block), scene_value = param_value(info, rows.scene_block);
    const bool held = held_back_ && held_back_->info == &info;
    const std::string name(info.name);
    ImGui::PushID(name.c_str());
    const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(spaced(name).c_str());
    bool hovered = ImGui::IsItemHovered();

    ImGui::SameLine(left + kNameWidth * width);
    ImGui::SetNextItemWidth((1 - kNameWidth) * width - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemSpacing.x);
    std::optional<double> edited = draw_value(info, held ? held_back_->value : value, log_);
    note_control(log_, name);
    const bool active = ImGui::IsItemActive(), typed = active && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (edited && active && (kind != ParamRows::Kind::live || typed))
        held_back_ = ParamEdit{&info, *std::exchange(edited, std::nullopt)};
    else if (held && !active)
        edited = edited.value_or(std::exchange(held_back_, std::nullopt)->value);
    hovered = hovered || ImGui::IsItemHovered();
    if (!hovered && hovered_ == &info) hovered_ = nullptr;
    if (hovered && std::exchange(hovered_, &info) != &info) since_hovered_ = {};
    draw_tooltip(info, scene_value, kind == ParamRows::Kind::restarts);
    if (const std::optional<double> reset = draw_reset(info, value, scene_value)) edited = reset;
    ImGui::PopID();
    if (!edited || *edited == value) return std::nullopt;
    return ParamEdit{&info, *edited};
}

void ParamPanel::draw_tooltip(const ParamInfo& info, double scene_value, bool restarts)
{
    if (hovered_ != &info || ImGui::IsItemActive() || since_hovered_.elapsed_ms() < kTooltipAfterMs) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
    ImGui::TextUnformatted(std::string(info.name).c_str());
    ImGui::TextUnformatted(std::string(info.help).c_str());
    const std::string range = fmt::format("{}; this scene: {}", param_range_text(info), param_text(info, scene_value));
    ImGui::TextDisabled("%s", range.c_str());
    if (info.type == ParamType::real || info.type == ParamType::integer)
        ImGui::TextDisabled("Ctrl-click to type a value.");
    if (restarts) ImGui::TextDisabled("A change starts the cloth again.");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::optional<double> ParamPanel::draw_reset(const ParamInfo& info, double value, double scene_value)
{
    if (value == scene_value) return std::nullopt;
    ImGui::SameLine();
    const char* turned_arrow = "\u21BA";
    const bool has_arrow = ImGui::GetFont()->FindGlyphNoFallback(0x21BA) != nullptr;
    const bool pressed =
        ImGui::Button(has_arrow ? turned_arrow : "x", {ImGui::GetFrameHeight(), ImGui::GetFrameHeight()});
    note_control(log_, fmt::format("reset {}", info.name));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Back to the scene's %s", param_text(info, scene_value).c_str());
    return pressed ? std::optional(scene_value) : std::nullopt;
}

}  // namespace nuno
