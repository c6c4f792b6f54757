// The window with plots of the last simulated seconds.
#pragma once

#include <span>

#include "app/value_history.h"
#include "app/viewer_log.h"
#include "model/diagnostics.h"
#include "sim/frame_stats.h"

namespace nuno {

// What is plotted. Energies and strain are of the frames that are measured anyway, counts of every frame.
struct PlottedValues
{
    ValueHistory kinetic_j, elastic_j, gravity_j, strain_percent, contacts, impacts;

    void add(double time_s, const Diagnostics& measured);
    void add(double time_s, const CollisionCounts& count);
};

// Draws the plots into the current window. `time_s`: at their right edge.
void draw_plots(const PlottedValues& values, double time_s, ViewerLog& log, float scale);

}  // namespace nuno
