// Checks of a mesh.
#include "model/triangle_mesh.h"

#include <fmt/format.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/error.h"

namespace nuno {

float face_area(const TriangleMesh& mesh, const glm::uvec3& face)
{
    const glm::vec3 a = mesh.positions[face.x], b = mesh.positions[face.y], c = mesh.positions[face.z];
    return 0.5f * glm::length(glm::cross(b - a, c - a));
}

void check_mesh(const TriangleMesh& mesh, std::string_view where)
{
    if (mesh.positions.empty())
        throw Error(fmt::format("{}: the mesh has no vertices; give at least one triangle", where));
    if (mesh.faces.empty()) throw Error(fmt::format("{}: the mesh has no faces; give at least one triangle", where));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            throw Error(
                fmt::format("{}: vertex {} has a coordinate that is not finite; give numbers in metres", where, i));
    }
    std::vector<bool> used(mesh.positions.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const glm::uvec3 face = mesh.faces[f];
        for (const std::uint32_t v : {face.x, face.y, face.z}) {
            if (v >= mesh.positions.size())
                throw Error(fmt::format("{}: face {} names vertex {}, but there are {} (0 to {})", where, f, v,
                                        mesh.positions.size(), mesh.positions.size() - 1));
            used[v] = true;
        }
        if (!(face_area(mesh, face) > 0))
            throw Error(fmt::format(
                "{}: face {} (vertices {} {} {}, counted from 0) has no area; remove it or move its corners apart",
                where, f, face.x, face.y, face.z));
    }
    for (std::size_t v = 0; v < used.size(); ++v)
        if (!used[v]) throw Error(fmt::format("{}: vertex {} belongs to no face; remove it", where, v));
}

}  // namespace nuno
