// Coloured springs by fours of vertices, so that a device takes several colours in one dispatch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// Springs in the order of their colours. Those of one colour share no vertex.
struct ColouredSprings
{
    std::vector<std::int32_t> first;  // of each colour, and one past the last
    std::vector<glm::ivec2> ends;     // two vertices; -1 where a spring only fills up
};

// A spring of colour c of a group joins, from its first end to its second, two corners of its quad that stand in
// kQuadSides[c], so that the springs of one colour share no corner and six springs join all four corners.
inline constexpr std::array<std::array<std::array<int, 2>, 2>, 3> kQuadSides{
    {{{{0, 1}, {2, 3}}}, {{{0, 2}, {1, 3}}}, {{{0, 3}, {1, 2}}}}};
inline constexpr int kMostQuadColours = static_cast<int>(kQuadSides.size());

// Colours that follow each other and hang together in fours at most. No two quads of a group share a vertex.
struct QuadGroup
{
    int colour_count;           // 1 to kMostQuadColours
    std::int32_t first, count;  // quads
    std::int32_t first_sides;   // those of colour c of quad q are first_sides + c count + q
};

// To project the groups in turn, in each quad colour after colour, is to project colour after colour: the same bits.
struct SpringQuads
{
    std::vector<QuadGroup> groups;    // in the order of their colours
    std::vector<glm::ivec4> corners;  // the vertices of each quad; -1: none
    std::vector<glm::ivec2> sides;    // the springs on both sides of a colour of a quad; -1: none
};

SpringQuads make_spring_quads(const ColouredSprings& springs, std::uint32_t vertex_count);

}  // namespace nuno
