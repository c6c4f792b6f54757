// A vertex that is closer to a face than the cloth is thick.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace nuno {

struct Contact
{
    std::uint32_t vertex, face;
    glm::vec3 weights;  // of the face's corners in the foot of the perpendicular, sum 1
    glm::vec3 normal;   // unit, perpendicular to the face, towards the side where the vertex is
    float distance;     // [m] from the foot to the vertex, not negative

    bool operator==(const Contact&) const = default;
};

// What counts as a contact (seed paper, section 2.5.1.2).
struct ContactRange
{
    float thickness = 0;       // epsilon [m]: the largest distance
    float edge_tolerance = 0;  // delta: the weights are within -delta .. 1 + delta
};

// The order in which contacts are answered: a property of the contacts, not of how they were found.
inline bool comes_before(const Contact& a, const Contact& b)
{
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.face < b.face;
}

}  // namespace nuno
