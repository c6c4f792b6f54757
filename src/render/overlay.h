// What is drawn over a picture so that a run can be read in it: marks, and colours of the cloth. What they mean is not
// known here.
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// A straight stroke with round ends; a dot where both ends are one place, a tip where the width there is 0. Widths are
// in pixels of a picture 720 high.
struct Mark
{
    glm::vec3 from;  // [m]
    float from_width;
    glm::vec3 to;  // [m]
    float to_width;
    glm::vec4 colour;  // sRGB and opacity, each 0 .. 1
};

// Numbers 0 .. 1 that colour the cloth in place of its texture (shaders/shared/viridis.h), one a vertex or one a face.
struct ClothHeat
{
    std::vector<float> values;  // empty: the cloth keeps its look
    bool is_of_faces = false;
};

struct Overlay
{
    std::vector<Mark> on_cloth;  // hidden by what lies before them
    std::vector<Mark> through;   // seen faintly through it
    ClothHeat heat;
};

}  // namespace nuno
