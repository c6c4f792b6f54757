// Nearest points by a tree of boxes.
#include "model/triangle_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr std::uint32_t kFacesALeaf = 4;

NearestPoint at_weights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                        const glm::dvec3& weights)
{
    const glm::dvec3 q = weights.x * a + weights.y * b + weights.z * c;
    return {0, weights, q, glm::dot(p - q, p - q)};
}

double distance_sq_to_box(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high)
{
    const glm::dvec3 d = glm::max(glm::max(low - p, p - high), glm::dvec3(0));
    return glm::dot(d, d);
}

}  // namespace

NearestPoint nearest_on_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return at_weights(p, a, b, c, {1, 0, 0});
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return at_weights(p, a, b, c, {0, 1, 0});
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return at_weights(p, a, b, c, {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0});
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return at_weights(p, a, b, c, {0, 0, 1});
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return at_weights(p, a, b, c, {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)});
    const double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
    if (va <= 0 && along >= 0 && back >= 0) {
        const double w = along / (along + back);
        return at_weights(p, a, b, c, {0, 1 - w, w});
    }
    const double sum = va + vb + vc;
    return at_weights(p, a, b, c, {1 - vb / sum - vc / sum, vb / sum, vc / sum});
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh), faces_(mesh.faces.size())
{
    std::iota(faces_.begin(), faces_.end(), 0u);
    build(0, static_cast<std::uint32_t>(faces_.size()));
}

glm::dvec3 TriangleTree::corner(std::uint32_t face, int k) const { return mesh_.positions[mesh_.faces[face][k]]; }

std::uint32_t TriangleTree::build(std::uint32_t first, std::uint32_t count)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node node{glm::dvec3(std::numeric_limits<double>::max()), glm::dvec3(std::numeric_limits<double>::lowest()), first,
              count};
    for (std::uint32_t i = first; i < first + count; ++i)
        for (int k = 0; k < 3; ++k) {
            node.low = glm::min(node.low, corner(faces_[i], k));
            node.high = glm::max(node.high, corner(faces_[i], k));
        }
    nodes_.push_back(node);
    if (count <= kFacesALeaf) return number;
    const glm::dvec3 side = node.high - node.low;
    const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
    const auto middle = [&](std::uint32_t face) {
        return corner(face, 0)[axis] + corner(face, 1)[axis] + corner(face, 2)[axis];
    };
    const auto begin = faces_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(middle(a), a) < std::pair(middle(b), b);
    });
    build(first, count / 2);
    const std::uint32_t second = build(first + count / 2, count - count / 2);
    nodes_[number].first = second;
    nodes_[number].count = 0;
    return number;
}

NearestPoint TriangleTree::nearest(const glm::dvec3& p) const
{
    NearestPoint best;
    best.distance_sq = std::numeric_limits<double>::infinity();
    search(0, p, best);
    return best;
}

void TriangleTree::search(std::uint32_t number, const glm::dvec3& p, NearestPoint& best) const
{
    const Node& node = nodes_[number];
    if (distance_sq_to_box(p, node.low, node.high) >= best.distance_sq) return;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        NearestPoint here = nearest_on_triangle(p, corner(faces_[i], 0), corner(faces_[i], 1), corner(faces_[i], 2));
        here.face = faces_[i];
        if (here.distance_sq < best.distance_sq) best = here;
    }
    if (node.count > 0) return;
    std::uint32_t near = number + 1, far = node.first;
    if (distance_sq_to_box(p, nodes_[far].low, nodes_[far].high) <
        distance_sq_to_box(p, nodes_[near].low, nodes_[near].high))
        std::swap(near, far);
    search(near, p, best);
    search(far, p, best);
}

}  // namespace nuno
