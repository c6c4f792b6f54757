// Vertices and edges of a mesh, each owned by one of its faces, so that what is done for pairs of faces is done once
// for every pair of a vertex and a face and of two edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/ccd/four_points.h"

namespace nuno {

// A vertex and a face, or two edges, that share no vertex; vertices in the order of collision/ccd/impact.h.
struct ElementPair
{
    PairKind kind;
    glm::uvec4 vertices;
    std::uint32_t face;  // of a vertex and a face; of two edges 0

    bool operator==(const ElementPair&) const = default;
};

// Which pairs of elements are asked for.
enum class ElementKinds
{
    all,
    vertex_face
};

// Pairs by face: those of face f with faces of higher numbers are [starts[f], starts[f + 1]) of `pairs`.
struct NearPairs
{
    std::vector<std::uint32_t> starts;
    std::vector<ElementPair> pairs;

    std::span<const ElementPair> of(std::uint32_t face) const
    {
        return std::span(pairs).subspan(starts[face], starts[face + 1] - starts[face]);
    }
};

class FaceElements
{
  public:
    // `faces` of vertices below `vertex_count`.
    FaceElements(std::span<const glm::uvec3> faces, std::uint32_t vertex_count, ElementKinds kinds = ElementKinds::all);

    std::span<const glm::uvec3> faces() const { return faces_; }
    std::span<const glm::uvec2> edges() const { return edges_; }

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    // Corner i of a face, and the edge from it to the next; kNone where another face owns it, or where no edges are
    // asked for.
    struct Owned
    {
        std::array<std::uint32_t, 3> vertices{kNone, kNone, kNone};
        std::array<glm::uvec2, 3> edges{glm::uvec2(kNone), glm::uvec2(kNone), glm::uvec2(kNone)};
    };
    const Owned& owned(std::uint32_t face) const { return owned_[face]; }

    // Calls body(const ElementPair&) for what face a owns against b and the other way, in a fixed order.
    template <class Body>
    void for_pairs_of(std::uint32_t a, std::uint32_t b, const Body& body) const;

    // Those of all faces that share a vertex, which never change: no tree is needed to find them.
    NearPairs near_pairs() const;

  private:
    template <class Body>
    void for_vertices_of(std::uint32_t a, std::uint32_t b, const Body& body) const;

    std::vector<glm::uvec3> faces_;
    std::vector<glm::uvec2> edges_;
    std::vector<Owned> owned_;
};

template <class Body>
void FaceElements::for_vertices_of(std::uint32_t a, std::uint32_t b, const Body& body) const
{
    const glm::uvec3& face = faces_[b];
    for (const std::uint32_t v : owned_[a].vertices)
        if (v != kNone && v != face.x && v != face.y && v != face.z)
            body(ElementPair{PairKind::vertex_face, {v, face.x, face.y, face.z}, b});
}

template <class Body>
void FaceElements::for_pairs_of(std::uint32_t a, std::uint32_t b, const Body& body) const
{
    for_vertices_of(a, b, body);
    for_vertices_of(b, a, body);
    for (const glm::uvec2& p : owned_[a].edges)
        for (const glm::uvec2& q : owned_[b].edges) {
            if (p.x == kNone || q.x == kNone || p.x == q.x || p.x == q.y || p.y == q.x || p.y == q.y) continue;
            body(ElementPair{PairKind::edge_edge, {p.x, p.y, q.x, q.y}, 0});
        }
}

}  // namespace nuno
