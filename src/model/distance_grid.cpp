// Signed distances to a closed mesh.
#include "model/distance_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "model/triangle_tree.h"

namespace nuno {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr double kMostNodes = 1 << 24;  // an index of the grid is exact as a float
constexpr int kMargin = 2;              // cells past the mesh, at least
constexpr float kCellsALongestSide = 48;

Edge edge_of(const glm::uvec3& face, int k) { return {face[k], face[(k + 1) % 3]}; }

// How many faces run along an edge in this direction.
using EdgeCounts = std::map<Edge, int>;

EdgeCounts count_edges(const TriangleMesh& mesh)
{
    EdgeCounts counts;
    for (const glm::uvec3& face : mesh.faces)
        for (int k = 0; k < 3; ++k) ++counts[edge_of(face, k)];
    return counts;
}

std::string edge_fault(const EdgeCounts& counts, const Edge& edge)
{
    const auto back = counts.find({edge.second, edge.first});
    const int there = counts.at(edge), opposite = back == counts.end() ? 0 : back->second;
    if (there == 1 && opposite == 1) return {};
    if (there == 1 && opposite == 0) return "has a face on one side only; close the hole with faces";
    if (there + opposite == 2) return "has two faces that turn opposite ways; turn one of them round";
    return fmt::format("has {} faces; leave two", there + opposite);
}

double volume_of(const TriangleMesh& mesh)
{
    double volume = 0;
    for (const glm::uvec3& face : mesh.faces) {
        const glm::dvec3 a = mesh.positions[face.x], b = mesh.positions[face.y], c = mesh.positions[face.z];
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return volume;
}

// Normals whose sign against the way to the nearest point tells inside from outside.
class PseudoNormals
{
  public:
    explicit PseudoNormals(const TriangleMesh& mesh) : mesh_(mesh), at_vertex_(mesh.positions.size(), glm::dvec3(0))
    {
        for (const glm::uvec3& face : mesh.faces) {
            const glm::dvec3 n = face_normal(face);
            for (int k = 0; k < 3; ++k) {
                at_edge_[sorted(edge_of(face, k))] += n;
                const glm::dvec3 here = mesh.positions[face[k]];
                const glm::dvec3 a = glm::normalize(glm::dvec3(mesh.positions[face[(k + 1) % 3]]) - here);
                const glm::dvec3 b = glm::normalize(glm::dvec3(mesh.positions[face[(k + 2) % 3]]) - here);
                at_vertex_[face[k]] += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * n;
            }
        }
    }

    glm::dvec3 at(const NearestPoint& point) const
    {
        const glm::uvec3& face = mesh_.faces[point.face];
        for (int k = 0; k < 3; ++k)
            if (point.weights[(k + 1) % 3] == 0 && point.weights[(k + 2) % 3] == 0) return at_vertex_[face[k]];
        for (int k = 0; k < 3; ++k)
            if (point.weights[(k + 2) % 3] == 0) return at_edge_.at(sorted(edge_of(face, k)));
        return face_normal(face);
    }

  private:
    static Edge sorted(Edge edge) { return std::minmax(edge.first, edge.second); }
    glm::dvec3 face_normal(const glm::uvec3& face) const
    {
        const glm::dvec3 a = mesh_.positions[face.x], b = mesh_.positions[face.y], c = mesh_.positions[face.z];
        return glm::normalize(glm::cross(b - a, c - a));
    }

    const TriangleMesh& mesh_;
    std::vector<glm::dvec3> at_vertex_;
    std::map<Edge, glm::dvec3> at_edge_;
};

// Origin, cell and number of cells, without values.
DistanceGrid empty_grid(const TriangleMesh& mesh, float cell, std::string_view where)
{
    glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
    for (const glm::vec3 p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const glm::vec3 side = high - low;
    DistanceGrid grid;
    grid.cell = cell > 0 ? cell : std::max({side.x, side.y, side.z}) / kCellsALongestSide;
    double nodes = 1;
    for (int k = 0; k < 3; ++k) nodes *= std::ceil(double(side[k]) / double(grid.cell)) + 2 * kMargin + 1;
    if (!(nodes <= kMostNodes))
        throw Error(
            fmt::format("{}: cells of {:g} m make a grid of {:.3g} nodes, more than 16 million; give cell = "
                        "{:.2g} or more",
                        where, grid.cell, nodes, grid.cell * std::cbrt(nodes / kMostNodes) * 1.05));
    for (int k = 0; k < 3; ++k) {
        grid.cells[k] = static_cast<int>(std::ceil(double(side[k]) / double(grid.cell))) + 2 * kMargin;
        grid.origin[k] = 0.5f * (low[k] + high[k] - static_cast<float>(grid.cells[k]) * grid.cell);
    }
    return grid;
}

}  // namespace

void check_closed(const TriangleMesh& mesh, std::string_view where)
{
    const EdgeCounts counts = count_edges(mesh);
    for (const glm::uvec3& face : mesh.faces)
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edge_of(face, k);
            const std::string fault = edge_fault(counts, edge);
            if (!fault.empty())
                throw Error(fmt::format(
                    "{}: a body must be a closed mesh, but the edge from vertex {} to vertex {} (counted from 0) {}",
                    where, edge.first, edge.second, fault));
        }
    if (!(volume_of(mesh) > 0))
        throw Error(
            fmt::format("{}: the faces of a body must look outwards, but these look inwards; turn them all "
                        "round (counter-clockwise seen from outside)",
                        where));
}

DistanceGrid make_distance_grid(const TriangleMesh& mesh, float cell, std::string_view where)
{
    check_closed(mesh, where);
    DistanceGrid grid = empty_grid(mesh, cell, where);
    const TriangleTree tree(mesh);
    const PseudoNormals normals(mesh);
    for (int k = 0; k <= grid.cells.z; ++k)
        for (int j = 0; j <= grid.cells.y; ++j)
            for (int i = 0; i <= grid.cells.x; ++i) {
                const glm::dvec3 p = glm::dvec3(grid.origin) + double(grid.cell) * glm::dvec3(i, j, k);
                const NearestPoint nearest = tree.nearest(p);
                const double side = glm::dot(p - nearest.position, normals.at(nearest));
                grid.values.push_back(static_cast<float>(std::copysign(std::sqrt(nearest.distance_sq), side)));
            }
    return grid;
}

}  // namespace nuno
