// The programs that a look draws with.
#pragma once

#include "gl/program.h"
#include "render/view_params.h"

namespace nuno {

struct LookPrograms
{
    Program cloth, body, floor, background;
};

// Compiles them. Those of `cloth` read the uniform block Fabric and the maps of render/fabric_light.h too.
LookPrograms make_look_programs(Look look);

}  // namespace nuno
