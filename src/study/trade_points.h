// The points of `nuno trade`: settings of a scene, each with what it costs and how wrong it is (docs/trade.md).
#pragma once

#include <vector>

#include "study/scene_study.h"
#include "study/sweep.h"

namespace nuno {

struct TradeOptions
{
    int repeats = 5;          // of the time of a point; the least counts
    double repeats_ms = 500;  // that all repeats of a point may take; one at least
    double most_ms = 8000;    // a simulated second; slower settings are given up
    int ensemble = 8;         // runs of each, where motion is chaotic
    bool with_gpu = false;    // an OpenGL context is current
};

// Independent points, "scene/kind/...": kinds `scene`, `time` (the error in time: methods, substeps, iterations,
// tethers), `space` (resolution), `model` (springs or continuum), `level` (of collision), `threads`, `backend` and
// `long` (how the scene goes on and ends, by method). `study` must outlive them.
std::vector<SweepPoint> trade_points(SceneStudy& study, const TradeOptions& options);

}  // namespace nuno
