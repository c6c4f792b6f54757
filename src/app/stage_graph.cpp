// The history of stage times and its graph.
#include "app/stage_graph.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nuno {
namespace {

constexpr float kSmoothing = 0.06f;  // share of the newest frame
constexpr float kAxisStepsMs[] = {2, 4, 8, 16, 24, 40, 80, 160, 320, 640, 1280};
constexpr unsigned kColours[] = {IM_COL32(76, 155, 232, 255), IM_COL32(150, 170, 190, 255),
                                 IM_COL32(92, 184, 128, 255), IM_COL32(242, 193, 78, 255),
                                 IM_COL32(240, 130, 80, 255), IM_COL32(155, 138, 232, 255),
                                 IM_COL32(230, 95, 145, 255), IM_COL32(105, 120, 135, 255)};
constexpr float kDisplayFrameMs = 1000.0f / 60;

constexpr bool of_window(std::size_t stage)
{
    return kStages[stage].ms == &StageTimes::render || kStages[stage].ms == &StageTimes::encode;
}

float sum(const StageColumn& column) { return std::accumulate(column.begin(), column.end(), 0.0f); }

}  // namespace

StageColumn stage_column(const StageTimes& simulated, double render_ms, double panel_ms)
{
    StageTimes times = simulated;
    times.render = render_ms;
    times.encode = panel_ms;
    StageColumn column;
    for (std::size_t i = 0; i < kGraphStages; ++i) column[i] = static_cast<float>(times.*kStages[i].ms);
    return column;
}

void StageHistory::add(const StageColumn& column, int simulated_frames)
{
    for (std::size_t i = 0; i < kGraphStages; ++i) {
        if (!of_window(i) && simulated_frames == 0) continue;
        const float ms = of_window(i) ? column[i] : column[i] / static_cast<float>(simulated_frames);
        smoothed_[i] += (started_[i] ? kSmoothing : 1.0f) * (ms - smoothed_[i]);
        started_[i] = true;
    }
    if (simulated_frames == 0) return;
    smoothed_sum_ += (columns_.empty() ? 1.0f : kSmoothing) * (sum(column) - smoothed_sum_);
    if (columns_.size() < kFrames) {
        columns_.push_back(column);
    } else {
        columns_[first_] = column;
        first_ = (first_ + 1) % kFrames;
    }
}

float StageHistory::highest_ms() const
{
    float highest = 0;
    for (const StageColumn& column : columns_) highest = std::max(highest, sum(column));
    return highest;
}

float graph_axis_ms(float highest_ms)
{
    for (const float step : kAxisStepsMs)
        if (highest_ms <= step) return step;
    return std::ceil(highest_ms / 1000) * 1000;
}

unsigned graph_stage_colour(std::size_t stage) { return kColours[stage % std::size(kColours)]; }

void draw_stage_graph(const StageHistory& history, float width, float height)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float bottom = corner.y + height, right = corner.x + width;
    list.AddRectFilled(corner, {right, bottom}, IM_COL32(18, 20, 24, 255));

    const float axis = graph_axis_ms(history.highest_ms());
    const float column_width = width / static_cast<float>(StageHistory::kFrames);
    // The newest column is at the right edge.
    float x = right - column_width * static_cast<float>(history.size());
    for (std::size_t i = 0; i < history.size(); ++i, x += column_width) {
        float y = bottom;
        for (std::size_t stage = 0; stage < kGraphStages; ++stage) {
            const float part = history.column(i)[stage] / axis * height;
            if (part < 0.05f) continue;
            list.AddRectFilled({x, y - part}, {x + column_width, y}, graph_stage_colour(stage));
            y -= part;
        }
    }
    if (axis > kDisplayFrameMs) {
        const float y = bottom - kDisplayFrameMs / axis * height;
        list.AddLine({corner.x, y}, {right, y}, IM_COL32(255, 255, 255, 110));
        list.AddText({corner.x + 4, y - ImGui::GetFontSize() - 1}, IM_COL32(255, 255, 255, 170), "16.7 ms");
    }
    const std::string label = fmt::format("{} ms", axis);
    list.AddText({corner.x + 4, corner.y + 2}, IM_COL32(255, 255, 255, 170), label.c_str());
    ImGui::Dummy({width, height});
}

}  // namespace nuno
