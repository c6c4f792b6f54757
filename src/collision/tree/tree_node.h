// What the tree of faces is made of: poses, cells of two faces, nodes of four children, pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/sim_params.h"

namespace nuno {

// The cloth on its way in a straight line from t0 to t1, xyz [m], one a vertex. The same span twice is one pose.
struct Poses
{
    std::span<const glm::vec4> t0, t1;

    bool is_swept() const { return t0.data() != t1.data(); }
};

struct TreeSettings
{
    // [m] Faces that come as near as this are found: the box of a face, over its way from t0 to t1, grows by half of it
    // on every side, and by what rounding could take away.
    float distance = 0;
    Culling culling = Culling::none;
    // Culling::sound: of one sheet, faces that stay further apart than this share of their distance at rest need not be
    // found either.
    float rest_share = std::numeric_limits<float>::infinity();
    // [m] All this with so much room to spare: what is not found is further apart by the margin than it has to be.
    float margin = 0;
};

// Two faces whose boxes overlap, a < b, without a common vertex.
struct FacePair
{
    std::uint32_t a, b;

    bool operator==(const FacePair&) const = default;
    bool operator<(const FacePair& other) const { return a != other.a ? a < other.a : b < other.b; }
};

// Two faces with a common edge, or one face alone: face 0 has the corners vertex[0], [1], [2], face 1 has [0], [1],
// [3]. Of the four pairs of faces of two cells, (first's 0, second's 0), (0, 1), (1, 0), (1, 1), those exist whose bit
// is set in `as_first` of the one and in `as_second` of the other. Without a face it is absent.
struct Cell
{
    std::array<std::uint32_t, 4> vertex{};
    std::array<std::uint32_t, 2> face{};
    std::uint32_t as_first = 0, as_second = 0;

    static Cell of_one(std::array<std::uint32_t, 3> v, std::uint32_t face)
    {
        return {{v[0], v[1], v[2], v[2]}, {face, face}, 0x3, 0x5};
    }
    static Cell of_two(std::array<std::uint32_t, 4> v, std::uint32_t face0, std::uint32_t face1)
    {
        return {v, {face0, face1}, 0xf, 0xf};
    }
    bool is_absent() const { return as_first == 0; }
    bool has_two() const { return as_first == 0xf; }
};

constexpr std::int16_t kNothingLo = 32767, kNothingHi = -32768;

// The boxes of four children side by side, in whole steps of the space that the cloth fills. The children of node n are
// the nodes 4 n .. 4 n + 3 of the level below, at level 0 the cells of these numbers. The box of an absent child is
// empty.
struct alignas(64) TreeNode
{
    std::int16_t box[6][4];  // lo x, y, z, hi x, y, z
    std::uint16_t x, y;      // place in its grid, in nodes of its level
    std::uint32_t grid;      // which grid it is a square of; of no other node where it is none: kNoGrid + a number
    // 0 where its children's pairs with those of neighbours in its grid are found with the boxes, else 3.
    std::uint32_t meets_neighbours;
    std::uint32_t unused;
};

constexpr std::uint32_t kNoGrid = 0x80000000u;

constexpr TreeNode kEmptyNode{{{kNothingLo, kNothingLo, kNothingLo, kNothingLo},
                               {kNothingLo, kNothingLo, kNothingLo, kNothingLo},
                               {kNothingLo, kNothingLo, kNothingLo, kNothingLo},
                               {kNothingHi, kNothingHi, kNothingHi, kNothingHi},
                               {kNothingHi, kNothingHi, kNothingHi, kNothingHi},
                               {kNothingHi, kNothingHi, kNothingHi, kNothingHi}},
                              0,
                              0,
                              kNoGrid,
                              3,
                              0};

// Pairs in the order in which they are found. Storage only grows.
class PairList
{
  public:
    void clear() { count_ = 0; }
    std::span<const FacePair> pairs() const { return std::span(storage_).first(count_); }

    // Where the next pairs go: up to `most` may be written, then `add` says how many of them count.
    FacePair* room(std::size_t most)
    {
        if (storage_.size() < count_ + most) storage_.resize(2 * (count_ + most));
        return storage_.data() + count_;
    }
    void add(std::size_t count) { count_ += count; }

  private:
    std::vector<FacePair> storage_;
    std::size_t count_ = 0;
};

// Pairs of nodes of one level. Storage only grows.
class NodePairs
{
  public:
    void clear() { count_ = 0; }
    std::size_t count() const { return count_; }
    const std::uint32_t* first() const { return first_.data(); }
    const std::uint32_t* second() const { return second_.data(); }
    void add(std::uint32_t a, std::uint32_t b)
    {
        if (first_.size() == count_) {
            first_.resize(2 * count_ + 64);
            second_.resize(2 * count_ + 64);
        }
        first_[count_] = a;
        second_[count_++] = b;
    }

  private:
    std::vector<std::uint32_t> first_, second_;
    std::size_t count_ = 0;
};

}  // namespace nuno
