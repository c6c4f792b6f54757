// Vertices in colours: no two of a colour share a spring, so all of one colour can move at once.
#pragma once

#include <cstdint>
#include <vector>

#include "model/cloth_model.h"

namespace nuno {

// Vertices in an order of places in which those of a colour follow one another. Places that only fill a colour up hold
// kNoVertex.
struct VertexColours
{
    static constexpr std::uint32_t kNoVertex = ~0u;

    std::vector<std::uint32_t> first_place;  // of each colour, and one past the last; multiples of the grain
    std::vector<std::uint32_t> vertices;     // by place
    std::vector<std::uint32_t> places;       // by vertex

    int colour_count() const { return static_cast<int>(first_place.size()) - 1; }
    std::uint32_t place_count() const { return static_cast<std::uint32_t>(vertices.size()); }
};

// Of a grid sheet (i + 2 j) mod 5, which differs between any two of the seed's neighbourhood; of any other sheet the
// first colour that no neighbour has. A grid's vertices lie so that those of neighbouring places have neighbours in
// neighbouring places.
VertexColours colour_vertices(const ClothModel& model, std::uint32_t grain);

// The model with its vertices by place, and slots of springs as before; `sheets` and `seams` are empty. Places that only fill
// up are vertices without springs, faces or area.
ClothModel placed_model(const ClothModel& model, const VertexColours& colours);

}  // namespace nuno
