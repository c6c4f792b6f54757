// Constraints of any mesh in colours: those of one colour share no vertex, so they can be projected side by side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/thread_pool.h"

namespace nuno {

// Constraints in a batch: as many as the widest vectors have lanes.
inline constexpr int kColourBatch = 16;
// Places past the last vertex that positions must have room for: what fills up a batch joins these.
inline constexpr std::uint32_t kSparePlaces = 8 * kColourBatch;

// Constraints of some vertices, the same number of floats each, by colour and in batches. Batch b has the places of
// end k of its constraints at ends(b) + k kColourBatch, and number n of each at numbers(b) + n kColourBatch. What fills
// up the last batch of a colour has numbers 0.
class ConstraintColours
{
  public:
    // `vertices`: `ends` of every constraint, one after another. Each constraint gets the first colour that none before
    // it has at one of its vertices, from its own of `least_colours` on (empty: from 0 on). A place among floats is
    // 4 x the vertex.
    ConstraintColours(std::span<const std::uint32_t> vertices, int ends, int number_count, std::uint32_t vertex_count,
                      std::span<const std::size_t> least_colours = {});

    int colour_count() const { return static_cast<int>(first_batch_.size()) - 1; }
    Range batches(int colour) const
    {
        return {first_batch_[std::size_t(colour)], first_batch_[std::size_t(colour) + 1]};
    }
    std::size_t colour(std::size_t constraint) const;
    float& number(std::size_t constraint, int n)
    {
        const std::size_t slot = slots_[constraint];
        return numbers_[(slot / kColourBatch * std::size_t(number_count_) + std::size_t(n)) * kColourBatch +
                        slot % kColourBatch];
    }

    const std::uint32_t* ends(int batch) const { return &places_[std::size_t(batch * end_count_ * kColourBatch)]; }
    const float* numbers(int batch) const { return &numbers_[std::size_t(batch * number_count_ * kColourBatch)]; }

  private:
    int end_count_, number_count_;
    std::vector<int> first_batch_;    // of each colour, and one past the last
    std::vector<std::size_t> slots_;  // of each constraint: batch * kColourBatch + lane
    std::vector<std::uint32_t> places_;
    std::vector<float> numbers_;
};

// Numbers of a spring (two ends) and of a plate (four ends, C = sum of coefficient x); shares are
// solver/xpbd/spring_share.h's, limit_length and hardness shaders/shared/xpbd.h's.
enum SpringNumber : int
{
    kRestLength,
    kSpringShare,
    kSpringNumberCount,
    kLimitLength = kSpringNumberCount,  // the others only where springs have a limit
    kHardness,
    kLimitedSpringNumberCount
};
enum PlateNumber : int
{
    kPlateShare = 4,  // after the four coefficients
    kPlateNumberCount
};

// All constraints of these batches, of one colour: positions are x, y, z and inverse mass. `lanes` 16, 8 or 4, which
// changes nothing but speed; `limited`: springs have a limit.
void project_springs(const ConstraintColours& springs, Range batches, bool limited, float* positions, int lanes);
void project_plates(const ConstraintColours& plates, Range batches, float* positions, int lanes);

}  // namespace nuno
