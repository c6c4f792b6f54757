// Which points the differences of a pair are of, and which of them are the sides of their hull.
#pragma once

#include "collision/ccd/four_points.h"

namespace nuno {

// Vertex and face: w0, w1, w2 = the vertex less each of the face, w3 = w2; hull: a triangle.
// Edges a and b: w0 = a0 - b0, w1 = a1 - b0, w2 = a0 - b1, w3 = a1 - b1; hull: a parallelogram.
// Tables are by kind.
constexpr int kMinuend[2][4] = {{0, 0, 0, 0}, {0, 1, 0, 1}}, kSubtrahend[2][4] = {{1, 2, 3, 3}, {2, 2, 3, 3}};

// The sides are from one difference to another; the fourth of a triangle repeats the third.
constexpr int kSideFrom[2][4] = {{0, 1, 2, 2}, {0, 2, 0, 1}}, kSideTo[2][4] = {{1, 2, 0, 0}, {1, 3, 2, 3}};

constexpr int row_of(PairKind kind) { return kind == PairKind::vertex_face ? 0 : 1; }
constexpr int side_count(PairKind kind) { return kind == PairKind::vertex_face ? 3 : 4; }

}  // namespace nuno
