// Numbers of a run as colours of its cloth.
#pragma once

#include "app/overlay_legend.h"
#include "collision/tree_picture.h"
#include "render/overlay.h"
#include "render/view_params.h"
#include "sim/simulation.h"

namespace nuno {

// Of every vertex, the largest | length / rest length - 1 | of a thread at it: the strain of the reports.
std::vector<float> thread_strains(const ClothModel& model, std::span<const glm::vec4> positions);

// The next of 1, 2, 5, 10 .. times a power of ten that is not below `largest`, and not below `least`, one of them.
double round_top(double largest, double least);

// The colours that view.heat asks for; says in `legend` what they mean. `tree` is null where no level of collision needs
// one.
ClothHeat heat_of(const ViewParams& view, Simulation& simulation, TreePicture* tree, OverlayLegend& legend);

}  // namespace nuno
