// A part of a mesh that a plane takes in: what it takes to prove it free of contacts (docs/tree.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace nuno {

// A side of the rim below the convex hull: `along` is the direction of the hull's side above it, and `slope` the
// tangent of the largest angle to it of any side there.
struct ChartRim
{
    std::array<std::uint16_t, 2> ends;  // in the part
    glm::vec2 along;
    float slope;
};

// Some faces and rims of a window over vertices of its own.
struct ChartPart
{
    static constexpr std::size_t kMostFaces = 2048, kMostVertices = 2048;

    std::vector<std::uint32_t> vertices;  // of the cloth
    std::vector<glm::vec2> places;        // of these in the plane [m]
    std::vector<std::uint16_t> corners;   // three a face; the last face again and again up to a multiple of kGroup
    std::vector<ChartRim> rims;

    static constexpr std::size_t kGroup = 16;  // of faces that are tested together
};

// A face by itself.
struct ChartFace
{
    std::array<std::uint32_t, 3> vertices;
    std::array<glm::vec2, 3> places;
};

// Vertices whose positions x give the mean gradient over the window, the sum of x weight^T.
struct ChartSample
{
    std::uint32_t vertex;
    glm::vec2 weight;  // [1/m]
};

struct ChartWindow
{
    static constexpr std::size_t kSamples = 16;

    std::vector<ChartPart> parts;
    std::array<ChartSample, kSamples> samples;
    std::uint32_t centre;   // a vertex near the middle
    float reach;            // [m] how far from it, along each axis, all others have to be at most
    double least_distance;  // [m] in the plane, of elements without a common vertex
    double stretch;         // how many times as far apart as in the plane points are at rest, at most
    double rounding;        // what rounding can take off lambda
    float rim_rounding;     // [m] likewise off what is asked of a rim

    // A face for which the last proof failed. It fails there again as a rule, so that is where the next one begins; what
    // comes out does not depend on it.
    ChartFace failed;
};

// What is asked of a window's parts, the same at both ends of a way: the columns of L below two zeros, and the factors
// 1, 1, -need, -need that go with a vertex's place.
struct ChartTest
{
    std::array<std::array<float, 4>, 3> column;
    std::array<float, 4> factor;
    std::uint32_t centre;
    float reach, rim_rounding;
};

// What came out for a part: whether it holds, and if it does not, a face for which it does not where there is one.
struct ChartAnswer
{
    bool holds;
    std::optional<ChartFace> failed;
};

// In place of a window's number, where there is none.
constexpr std::uint32_t kNoWindow = 0xffffffffu;

}  // namespace nuno
