// Sliders made from the rows of a parameter table: group by group, each with its range, unit, help and way back.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/viewer_log.h"
#include "core/params.h"
#include "core/stopwatch.h"

namespace nuno {

// A change that the user made to a row.
struct ParamEdit
{
    const ParamInfo* info;
    double value;
};

// What a group of rows shows.
struct ParamRows
{
    ParamTable table;
    const void* block;        // the values now
    const void* scene_block;  // those of the scene's file, to which a row goes back
    // How a row behaves.
    enum class Kind
    {
        live,
        on_release,  // its change is too heavy to follow the mouse: it acts when the mouse lets go
        restarts,    // the same, and the cloth starts again
        hidden
    };
    std::function<Kind(const ParamInfo&)> kind;
};

class ParamPanel
{
  public:
    explicit ParamPanel(ViewerLog& log) : log_(log) {}

    // A header for `group`, and its rows where it is open. The change of this frame, if any; not yet applied to the
    // block.
    std::optional<ParamEdit> draw_group(const ParamRows& rows, std::string_view group, bool open_at_first);

  private:
    std::optional<ParamEdit> draw_row(const ParamRows& rows, const ParamInfo& info, ParamRows::Kind kind);
    std::optional<double> draw_reset(const ParamInfo& info, double value, double scene_value);
    void draw_tooltip(const ParamInfo& info, double scene_value, bool restarts);

    ViewerLog& log_;
    std::optional<ParamEdit> held_back_;  // of a row that is being typed, or that acts on release
    const ParamInfo* hovered_ = nullptr;  // the row under the mouse, and since when
    Stopwatch since_hovered_;
};

// The groups of a table, each once, in its order.
std::vector<std::string_view> param_groups(ParamTable table);

// True where the slider of a row is logarithmic: the range spans three decades or more, or dwarfs the default.
bool is_logarithmic(const ParamInfo& info);

// `value` at three significant digits, within the range: what a slider gives, so that values are ones that a person
// would type.
double rounded_by_slider(const ParamInfo& info, double value);

}  // namespace nuno
