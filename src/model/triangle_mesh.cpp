// Checks of a mesh.
#include "model/triangle_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/error.h"

namespace nuno {
namespace {

void check_no_face_twice(const TriangleMesh& mesh, std::string_view where)
{
    std::vector<std::array<std::uint32_t, 4>> faces;  // vertices in order, and the number
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        faces.push_back({mesh.faces[f].x, mesh.faces[f].y, mesh.faces[f].z, f});
        std::sort(faces.back().begin(), faces.back().begin() + 3);
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 1; i < faces.size(); ++i)
        if (std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin()))
            throw Error(
                fmt::format("{}: face {} has the same vertices as face {} ({} {} {}, counted from 0); remove one",
                            where, faces[i][3], faces[i - 1][3], faces[i][0], faces[i][1], faces[i][2]));
}

}  // namespace

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
    check_no_face_twice(mesh, where);
}

}  // namespace nuno
