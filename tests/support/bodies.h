// Bodies that several tests start from.
#pragma once

#include "model/body.h"
#include "model/cloth_model.h"

namespace nuno {

// A plane, a sphere, a capsule, a box and a mesh below y = 0, all turning and moving for the first 0.3 s.
Bodies one_of_each_shape();

// A square sheet of 1 m above them.
SheetSource sheet_over_the_shapes(int count);

}  // namespace nuno
