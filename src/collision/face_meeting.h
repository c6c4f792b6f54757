// Whether two faces of one pose have points in common, exactly.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace nuno {

enum class Meeting : std::uint8_t
{
    none,
    touching,  // points in common, but no edge goes through: they lie on or end on each other
    crossing,  // an edge of one goes through the inside of the other, its ends strictly on both sides
};

// An edge that goes through the inside of a face.
struct Crossing
{
    bool edge_of_first;  // and the face is the second; else the other way round
    int edge;            // from this corner to the next
};

struct FaceMeeting
{
    Meeting kind = Meeting::none;
    int crossing_count = 0;  // 2 at most
    std::array<Crossing, 2> crossings{};
};

// The corners of a face: places [m] and the numbers of their vertices.
struct FaceCorners
{
    std::array<glm::vec3, 3> x;
    std::array<std::uint32_t, 3> vertices;
};

// Faces are closed, and may have no area: then they are what is left of them. Faces with a vertex in common meet where
// one of them meets the edge of the other that is opposite to it. Faces with an edge in common touch where they lie
// folded onto each other, in one plane and both with an area; faces with the same three vertices always do.
FaceMeeting meet(const FaceCorners& f, const FaceCorners& g);

}  // namespace nuno
