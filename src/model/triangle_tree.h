// Finds the point of a mesh that is nearest to a point in space.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/triangle_mesh.h"

namespace nuno {

struct NearestPoint
{
    std::uint32_t face = 0;
    glm::dvec3 weights{0};  // of the face's corners; one is 0 on an edge, two at a corner
    glm::dvec3 position{0};
    double distance_sq = 0;
};

// The point of a triangle nearest to p: Ericson, Real-Time Collision Detection, 5.1.5.
NearestPoint nearest_on_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Bounding boxes over the faces, halved at the median. The mesh must outlive it.
class TriangleTree
{
  public:
    explicit TriangleTree(const TriangleMesh& mesh);
    NearestPoint nearest(const glm::dvec3& p) const;

  private:
    struct Node
    {
        glm::dvec3 low, high;
        std::uint32_t first, count;  // faces of a leaf; count 0: children are the next node and `first`
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t count);
    void search(std::uint32_t node, const glm::dvec3& p, NearestPoint& best) const;
    glm::dvec3 corner(std::uint32_t face, int k) const;

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> faces_;
    std::vector<Node> nodes_;
};

}  // namespace nuno
