// The colours of numbers, as shaders/shared/viridis.h has them: for legends.
#pragma once

#include <glm/vec3.hpp>

namespace nuno {

// sRGB, each about 0 .. 1, of a value 0 .. 1; one outside has the colour of the nearer end.
glm::vec3 viridis(float value);

}  // namespace nuno
