// The window with the legend of the overlays.
#pragma once

#include <glm/vec2.hpp>

#include "app/overlay_legend.h"
#include "app/viewer_log.h"

namespace nuno {

// Where it may lie: [window coordinates], and those for each unit of the layout.
struct LegendPlace
{
    glm::vec2 low, high;
    float scale;
};

// Draws it in the lower left corner of the place, where the legend is not empty: over other windows when it appears, and
// it lets the mouse through.
void draw_legend(const OverlayLegend& legend, const LegendPlace& place, ViewerLog& log);

}  // namespace nuno
