// Springs of a mesh in stars, a vertex and the neighbours around it: loaded once, such a few vertices do for many
// springs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace nuno {

struct Star
{
    static constexpr std::size_t kNoSpring = ~std::size_t(0);

    std::vector<std::uint32_t> vertices;  // the centre, then the ring around it
    // Three times as many as the ring has vertices: from the centre to vertex k of the ring, from k to k + 1, and from
    // k to k + 2, round it. kNoSpring: that one is in no star, or another, or does not exist.
    std::vector<std::size_t> springs;

    int ring() const { return static_cast<int>(vertices.size()) - 1; }
};

struct Stars
{
    static constexpr int kLeastRing = 4, kMostRing = 7;

    std::vector<Star> stars;
    std::vector<std::size_t> left_over;  // springs that are in no star, in their order
};

// Puts springs into stars, each into one at most. `ends`: two vertices of every spring, one after another. A ring is a
// walk over the faces around its centre, cut off at kMostRing. Stars that hold the most springs a vertex are taken
// first; those that hold fewer springs than the ring has vertices are not worth it.
Stars find_stars(std::span<const std::uint32_t> ends, std::span<const glm::uvec3> faces, std::uint32_t vertex_count);

// A colour of each star: the first that no star before it has at one of its vertices.
std::vector<std::size_t> colour_stars(std::span<const Star> stars, std::uint32_t vertex_count);

}  // namespace nuno
