// Vertices in sets that can be joined (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace nuno {

class VertexSets
{
  public:
    // Every vertex alone.
    explicit VertexSets(std::size_t count) : parent_(count), size_(count, 1)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    // The least of its set, which stands for it: it does not depend on the order in which sets were joined.
    std::uint32_t find(std::uint32_t a)
    {
        while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
        return a;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b) return;
        const std::uint32_t least = std::min(a, b), other = std::max(a, b);
        parent_[other] = least;
        size_[least] += size_[other];
    }
    // Of the set that this vertex stands for.
    std::uint32_t size(std::uint32_t least) const { return size_[least]; }

  private:
    std::vector<std::uint32_t> parent_, size_;
};

}  // namespace nuno
