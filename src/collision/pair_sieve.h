// Which pairs of elements may come near each other in a pass, eight pairs at a time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/face_elements.h"

namespace nuno {

// The cloth on a straight way.
struct StraightStep
{
    std::span<const glm::vec4> start;  // positions [m]
    std::span<const glm::vec4> ways;   // what each vertex moves by [m]: end less start, rounded
};

// How near a pair comes. `gap` [m] is the least distance between planes across `normal` (unit, from side B to side A of
// shaders/shared/closest_points.h) on the way, less what a turning normal may take; infinite where the pair is left
// out.
struct ForeseenPair
{
    glm::vec3 normal;
    float gap;
    float approach;  // [m] the largest way of a vertex of one side relative to one of the other
};

// One answer a pair; all are of `kind`. Left out is what touches, what is further apart than `reach` [m] and can not be
// nearer, what is at both ends of the way and on the same side, and what has its closest points where another pair has
// nearer ones: outside of a face or beyond the end of an edge by more than may be slid over on the way. A heuristic: it
// is for contacts that may be missed. Eight lanes on every machine: the same bits everywhere.
void foresee_pairs(PairKind kind, std::span<const ElementPair> pairs, const StraightStep& step, float reach,
                   std::span<ForeseenPair> answers);

// A bound of the distance between the two sides at all times of the way [m], for each pair; negative where there is
// none. Planes that keep the sides apart at its start and its end do so all the way; what rounding may have added is
// taken off.
void bound_distances(PairKind kind, std::span<const ElementPair> pairs, const StraightStep& step,
                     std::span<float> bounds);

// Pairs that are handed on at once, at most.
constexpr std::size_t kMostPairsAtOnce = 64;

// Hands pairs on by kind, many at a time: body(kind, pairs).
template <class Body>
class PairBatches
{
  public:
    explicit PairBatches(Body body) : body_(std::move(body)) {}

    void add(const ElementPair& pair)
    {
        Batch& batch = batches_[pair.kind == PairKind::vertex_face ? 0 : 1];
        batch.pairs[batch.count++] = pair;
        if (batch.count == kMostPairsAtOnce) hand_on(batch);
    }
    // After the last pair.
    void finish()
    {
        for (Batch& batch : batches_)
            if (batch.count > 0) hand_on(batch);
    }

  private:
    struct Batch
    {
        std::array<ElementPair, kMostPairsAtOnce> pairs;
        std::size_t count = 0;
    };
    void hand_on(Batch& batch)
    {
        body_(batch.pairs[0].kind, std::span<const ElementPair>(batch.pairs).first(batch.count));
        batch.count = 0;
    }

    Body body_;
    std::array<Batch, 2> batches_;
};

}  // namespace nuno
