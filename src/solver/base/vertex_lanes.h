// Numbers of every vertex as structure of arrays, padded so that whole vectors can be read at both ends.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "core/archive.h"
#include "model/wide.h"

namespace nuno {

// One number of every vertex, with room for kLanes more before the first and after the last.
class VertexLane
{
  public:
    explicit VertexLane(std::uint32_t count) : values_(kPad + (count + kLanes - 1) / kLanes * kLanes + kPad, 0.0f) {}
    float* first() { return values_.data() + kPad; }
    const float* first() const { return values_.data() + kPad; }
    void carry(Archive& archive) { archive.values(std::span(values_)); }

  private:
    static constexpr int kPad = kLanes;
    std::vector<float> values_;
};

// The three lanes of a vector, as kernels take them.
struct Lanes3
{
    float *x, *y, *z;
};

// The state of every vertex, as kernels take it.
struct StateLanes
{
    Lanes3 x, v;                       // [m], [m/s]
    const float *inverse_mass, *area;  // [1/kg], [m2]
};

class VertexLanes3
{
  public:
    explicit VertexLanes3(std::uint32_t count) : x_(count), y_(count), z_(count) {}
    Lanes3 lanes() { return {x_.first(), y_.first(), z_.first()}; }
    glm::vec4 at(std::uint32_t i, float w) const { return {x_.first()[i], y_.first()[i], z_.first()[i], w}; }
    void put(std::uint32_t i, const glm::vec4& a)
    {
        x_.first()[i] = a.x;
        y_.first()[i] = a.y;
        z_.first()[i] = a.z;
    }

    void carry(Archive& archive)
    {
        for (VertexLane* lane : {&x_, &y_, &z_}) lane->carry(archive);
    }

  private:
    VertexLane x_, y_, z_;
};

NUNO_WIDE_INLINE WideVec3 load(const Lanes3& lanes, std::int32_t first)
{
    return {WideFloat(lanes.x + first), WideFloat(lanes.y + first), WideFloat(lanes.z + first)};
}

NUNO_WIDE_INLINE void store(const Lanes3& lanes, std::int32_t first, const WideVec3& a)
{
    a.x.store(lanes.x + first);
    a.y.store(lanes.y + first);
    a.z.store(lanes.z + first);
}

NUNO_WIDE_INLINE WideVec3 gather(const Lanes3& lanes, const std::uint32_t* vertices)
{
    WideVec3 a;
    for (int lane = 0; lane < kLanes; ++lane) {
        a.x.lanes[lane] = lanes.x[vertices[lane]];
        a.y.lanes[lane] = lanes.y[vertices[lane]];
        a.z.lanes[lane] = lanes.z[vertices[lane]];
    }
    return a;
}

NUNO_WIDE_INLINE WideVec3 wide(glm::vec3 a) { return {WideFloat(a.x), WideFloat(a.y), WideFloat(a.z)}; }

}  // namespace nuno
