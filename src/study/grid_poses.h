// Poses of one cloth on meshes of different spacing.
#pragma once

#include <span>

#include "model/cloth_model.h"
#include "study/trajectory.h"

namespace nuno {

// The root mean square distance [m] of the vertices of the coarse grids from the same places of the fine ones, where
// these are bilinear between their vertices, over the frames 1 .. `frames`. The sheets are those of one scene, of which
// at least one is a grid; other meshes do not count.
double rms_of_grids(std::span<const SheetSource> coarse_sheets, const Trajectory& coarse,
                    std::span<const SheetSource> fine_sheets, const Trajectory& fine, int frames);

}  // namespace nuno
