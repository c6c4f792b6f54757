// FNV-1a, 64 bit: the state hash that two runs are compared by.
#pragma once

#include <cstddef>
#include <cstdint>

namespace nuno {

class Fnv1a
{
  public:
    void add(const void* bytes, std::size_t count)
    {
        const auto* p = static_cast<const unsigned char*>(bytes);
        for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ p[i]) * 0x100000001b3u;
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace nuno
