// The overlays that a picture of a run is asked for with, from the run as it is: what is off costs nothing.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "app/overlay_legend.h"
#include "collision/tree_picture.h"
#include "render/overlay.h"
#include "render/view_params.h"
#include "sim/simulation.h"

namespace nuno {

// Of one cloth: another one needs another object.
class Overlays
{
  public:
    // The overlay of the present state, which may be copied from the device for it; null where none is asked for. It
    // lasts until the next call.
    const Overlay* gather(const ViewParams& view, Simulation& simulation);

    // Of the last call.
    const OverlayLegend& legend() const { return legend_; }

  private:
    void gather_marks(const ViewParams& view, Simulation& simulation);

    Overlay overlay_;
    OverlayLegend legend_;
    std::vector<glm::uvec2> edges_;      // made where they are first shown
    std::unique_ptr<TreePicture> tree_;  // likewise
};

}  // namespace nuno
