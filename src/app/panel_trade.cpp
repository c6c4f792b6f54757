// The section with the slider from fast to accurate.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panel.h"
#include "app/panel_controls.h"

namespace nuno {
namespace {

void wrapped(const std::string& text, ImVec4 colour)
{
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void dim(const std::string& text) { wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)); }

void draw_row(const char* name, const std::string& value)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", value.c_str());
}

void draw_progress(ViewerSession& session, ViewerLog& log)
{
    const Calibration::Progress progress = session.trade().progress();
    const bool has_begun = progress.count > 0;
    const float share = has_begun ? float(progress.tried) / float(progress.count) : 0;
    const std::string text = has_begun ? fmt::format("tried {} of at most {} settings", progress.tried, progress.count)
                                       : "computing what to hold settings against";
    ImGui::ProgressBar(share, {-1, 0}, text.c_str());
    dim("The cloth rests meanwhile: its frames would disturb the times.");
    if (button(log, "Stop measuring", "What was measured stays remembered, and the next time goes on from there"))
        session.give_up_measuring();
}

void draw_offer(ViewerSession& session, ViewerLog& log)
{
    if (!session.trade().error().empty()) wrapped(session.trade().error(), {1.0f, 0.45f, 0.42f, 1});
    if (button(log, "Measure", "Tries methods, substeps and iterations on this scene (docs/auto.md)"))
        session.measure_ladder();
    ImGui::SameLine();
    dim("from fast to accurate, here: seconds to minutes, in which the cloth rests");
}

// "method=xpbd tethers=none substeps=4" as "xpbd, 4 substeps, tethers none".
std::string rung_text(const Rung& rung)
{
    std::string method, others;
    for (const auto& [name, value] : rung.set) {
        if (name == "method") method = value;
        if (name == "iterations") others += fmt::format(", {} iterations", value);
        if (name == "tethers" || name == "strain_limit") others += fmt::format(", {} {}", name, value);
    }
    std::replace(others.begin(), others.end(), '_', ' ');
    return fmt::format("{}, {} {}{}", method, rung.substeps, rung.substeps == 1 ? "substep" : "substeps", others);
}

std::string error_text(const ViewerSession& session, const Rung& rung)
{
    std::string text = fmt::format("{:.2g} % of the size predicted", 100 * rung.error_share);
    const PromiseKeeper* promise = session.promise();
    const bool is_error = promise != nullptr && session.trade().ladder()->goal.error_share.has_value();
    if (const auto latest = is_error ? promise->latest() : std::nullopt)
        text += fmt::format(", {:.2g} % estimated now", 100 * *latest);
    return text;
}

std::string cost_text(const ViewerSession& session, const Rung& rung)
{
    std::string text = fmt::format("{:.3g} ms predicted", rung.ms_per_frame);
    if (const auto now = session.trade().frame_ms()) text += fmt::format(", {:.3g} ms now", *now);
    return text;
}

// Fast on its left, accurate on its right.
void draw_slider(ViewerSession& session, ViewerLog& log, std::optional<std::size_t> on)
{
    const std::size_t count = session.trade().ladder()->rungs.size();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("fast");
    ImGui::SameLine();
    const float right = ImGui::CalcTextSize("accurate").x + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - right);
    int chosen = on ? static_cast<int>(*on) : 0;
    const std::string text = on ? fmt::format("{} of {}", chosen + 1, count) : "set by hand";
    if (ImGui::SliderInt("##rung", &chosen, 0, static_cast<int>(count) - 1, text.c_str(),
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
        session.use_rung(static_cast<std::size_t>(chosen));
    note_control(log, "rung");
    ImGui::SameLine();
    ImGui::TextUnformatted("accurate");
}

void draw_promise(const ViewerSession& session)
{
    if (session.promise() == nullptr) return;
    const AutoGoal& goal = session.trade().ladder()->goal;
    const std::string promised = goal.error_share ? fmt::format("an error of {:g} %", 100 * *goal.error_share)
                                                  : fmt::format("a budget of {:g} ms", *goal.budget_ms);
    if (session.promise()->is_kept())
        dim(fmt::format("Keeps {}; the slider ends that.", promised));
    else
        wrapped(fmt::format("Does not keep {}.", promised), {0.95f, 0.77f, 0.36f, 1});
}

void draw_ladder(ViewerSession& session, ViewerLog& log)
{
    draw_slider(session, log, session.rung());
    const std::optional<std::size_t> on = session.rung();
    if (on && ImGui::BeginTable("rung", 2, ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableSetupColumn("name");
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
        const Rung& rung = session.trade().ladder()->rungs[*on];
        draw_row("setting", rung_text(rung));
        draw_row("error", error_text(session, rung));
        draw_row("frame", cost_text(session, rung));
        ImGui::EndTable();
    }
    draw_promise(session);
    const std::string changed = session.trade().changed_param(session.simulation().asked_params());
    if (!session.simulation().is_as_placed())
        wrapped("Measured with pins and bodies where the scene has them.", {0.95f, 0.77f, 0.36f, 1});
    if (changed.empty()) return;
    wrapped(fmt::format("Measured with another {}.", changed), {0.95f, 0.77f, 0.36f, 1});
    if (button(log, "Measure again", "With the parameters as they are now")) session.measure_ladder();
}

}  // namespace

void draw_trade_slider(ViewerSession& session, ViewerLog& log)
{
    const bool open = ImGui::CollapsingHeader("speed and accuracy", ImGuiTreeNodeFlags_DefaultOpen);
    note_control(log, "group speed and accuracy");
    if (!open) return;
    if (session.trade().is_measuring())
        draw_progress(session, log);
    else if (session.trade().ladder())
        draw_ladder(session, log);
    else
        draw_offer(session, log);
}

}  // namespace nuno
