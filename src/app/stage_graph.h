// What the last frames cost, stage by stage: as smoothed numbers, and as columns stacked over time.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "sim/frame_stats.h"

namespace nuno {

// The stages of a frame's statistics; the viewer encodes nothing, so the last one is the time of its panel.
inline constexpr std::size_t kGraphStages = kStages.size();
using StageColumn = std::array<float, kGraphStages>;  // [ms]

constexpr std::string_view graph_stage_name(std::size_t stage)
{
    return kStages[stage].ms == &StageTimes::encode ? "panel" : kStages[stage].name;
}
StageColumn stage_column(const StageTimes& simulated, double render_ms, double panel_ms);

class StageHistory
{
  public:
    static constexpr std::size_t kFrames = 240;

    // One frame of the window, in which `simulated_frames` frames were simulated; with none, only render and panel
    // count, and the graph does not move.
    void add(const StageColumn& column, int simulated_frames);

    std::size_t size() const { return columns_.size(); }
    // 0 is the oldest.
    const StageColumn& column(std::size_t i) const { return columns_[(first_ + i) % columns_.size()]; }
    // Of a stage of the simulation: per simulated frame. Of render and panel: per frame of the window.
    float smoothed_ms(std::size_t stage) const { return smoothed_[stage]; }
    float smoothed_sum_ms() const
    {
        return smoothed_sum_;
    }                          // of a frame of the window and all that was simulated for it
    float highest_ms() const;  // of a column's sum

  private:
    std::vector<StageColumn> columns_;  // a ring once it is full
    std::size_t first_ = 0;
    StageColumn smoothed_{};
    float smoothed_sum_ = 0;
    std::array<bool, kGraphStages> started_{};
};

// The least round axis that `highest_ms` fits under.
float graph_axis_ms(float highest_ms);

// ImGui's packed colour of a stage.
unsigned graph_stage_colour(std::size_t stage);

// Draws the columns into the current window of the panel.
void draw_stage_graph(const StageHistory& history, float width, float height);

}  // namespace nuno
