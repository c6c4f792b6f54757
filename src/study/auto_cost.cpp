// Costs of whole scenes.
#include "study/auto_cost.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "core/error.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

double median(std::vector<double> ms)
{
    const auto middle = ms.begin() + std::ptrdiff_t(ms.size() / 2);
    std::nth_element(ms.begin(), middle, ms.end());
    return *middle;
}

}  // namespace

SceneCost scene_cost(const Scene& scene, const SimParams& params, int frames, double limit_ms, const FrameWatch& watch)
{
    assert(frames > 0);
    SceneCost cost;
    Simulation simulation(scene, params);
    std::vector<double> frame_ms;
    std::vector<double> over;
    try {
        for (int frame = 0; frame < frames && !cost.is_dearer; ++frame) {
            frame_ms.push_back(simulation_ms(simulation.advance_frame().stage_ms));
            cost.largest_strain = std::max(cost.largest_strain, double(simulation.diagnostics().max_strain));
            if (frame_ms.back() > limit_ms) over.push_back(frame_ms.back());
            cost.is_dearer = int(over.size()) >= frames - frames / 2;
            if (watch) watch();
        }
    } catch (const Error& error) {
        if (error.code() != ExitCode::went_bad) throw;
        cost.failure = error.what();
    }
    if (!cost.failure.empty()) return cost;
    cost.ms_per_frame = cost.is_dearer ? median(std::move(over)) : median(std::move(frame_ms));
    return cost;
}

}  // namespace nuno
