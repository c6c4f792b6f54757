#version 430 core
// All sweeps of a substep over the springs of a small cloth in one work group.
// Defined by the caller: what sim/xpbd_one_group.glsl needs.
#include "shared/bindings.h"
#include "shared/dialect.glsl"
#include "shared/vector.h"
#include "shared/euler.h"
#include "shared/xpbd.h"
#include "sim/xpbd_one_group.glsl"

void main()
{
    sweep_springs(0);
}
