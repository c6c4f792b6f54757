// Two pieces of cloth that may come closer than the cloth is thick within the substeps to come: what collision hands to
// solvers.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// Sides A and B as in shaders/shared/layer_contact.h.
struct LayerContact
{
    glm::uvec4 vertices;
    glm::vec3 normal;  // unit, from B to A
    float kind;        // CONTACT_VERTEX_FACE, CONTACT_EDGE_EDGE
    float thickness;   // [m] that the sides keep from each other

    bool operator==(const LayerContact&) const = default;
};

}  // namespace nuno
