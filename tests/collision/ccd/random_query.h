// Random pairs in motion, of families that are hard each in its own way.
#pragma once

#include <cstdint>
#include <string>

#include "collision/ccd/four_points.h"

namespace nuno {

struct Query
{
    PairKind kind;
    FourPoints t0, t1;
};

enum class QueryFamily
{
    any,          // coordinates anywhere in -1 .. 1
    grid,         // small whole numbers: much is degenerate
    planar,       // all motion in one oblique plane
    rigid,        // moved as one, or not at all
    offset,       // 1e8 away from the origin
    built,        // made to touch at a time
    nudged,       // made to touch, then moved by parts in 1e16
    scaled,       // each coordinate with a scale of its own, down to 2^-40
    sliver,       // faces and edges next to no area or length
    extreme,      // scales from 2^-1000 to 2^1000, whole pairs and single coordinates
    in_floats,    // coordinates of cloth, stored as floats
    turning,      // turns far about itself, so that there are several roots
    plumb,        // falls along an axis onto a side, seen along which nothing moves
    broad_phase,  // pairs of a rough sheet of cells of 1 cm whose swept boxes meet
    count,
};

std::string name_of(QueryFamily family);

// The same query for the same numbers everywhere.
Query random_query(QueryFamily family, std::uint64_t seed);

std::string text_of(const Query& query);  // as a line of the file that ccd_queries reads

}  // namespace nuno
