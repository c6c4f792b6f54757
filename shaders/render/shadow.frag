#version 430 core
// The key light does not reach this point of the floor; also how near the floor what keeps it away is, for targets that
// hold it.
#include "shared/render_bindings.h"

in float height;  // [m]
out vec2 shadow;

void main()
{
    shadow = vec2(1.0, clamp(1.0 - height / SHADOW_HEIGHT, 0.0, 1.0));
}
