// Faces at rest, and the corners that meet in each vertex.
#include "model/face_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "core/error.h"

namespace nuno {
namespace {

constexpr double kThinnest = 1e-5;  // height over longest edge

formulas::FaceRest face_rest(const ClothModel& model, std::size_t face)
{
    const glm::uvec3 corners = model.faces[face];
    const glm::dvec3 origin = model.rest_positions[corners[0]];
    const glm::dvec3 e1 = glm::dvec3(model.rest_positions[corners[1]]) - origin;
    const glm::dvec3 e2 = glm::dvec3(model.rest_positions[corners[2]]) - origin;
    const glm::dvec3 normal = glm::cross(e1, e2);
    const double twice_area = glm::length(normal);
    const double longest = std::max({glm::length(e1), glm::length(e2), glm::length(e2 - e1)});
    const auto area = static_cast<float>(twice_area / 2);
    formulas::FaceRest rest{0, 0, 0, 0, area, area};
    if (twice_area <= kThinnest * longest * longest) return rest;
    // Coordinates in the plane of the face, warp and weft; the warp of a grid may lean out of it by rounding.
    const glm::dvec3 n = normal / twice_area;
    const glm::dvec3 direction = model.face_warps[face];
    const glm::dvec3 warp = glm::normalize(direction - glm::dot(direction, n) * n);
    const glm::dvec3 weft = glm::cross(n, warp);
    const glm::dmat2 edges(glm::dot(e1, warp), glm::dot(e1, weft), glm::dot(e2, warp), glm::dot(e2, weft));
    const glm::dmat2 inverse = glm::inverse(edges);
    rest.warp_1 = static_cast<float>(inverse[0][0]);
    rest.warp_2 = static_cast<float>(inverse[0][1]);
    rest.weft_1 = static_cast<float>(inverse[1][0]);
    rest.weft_2 = static_cast<float>(inverse[1][1]);
    return rest;
}

// Each vertex shares its mass out by the faces' areas; the lightest corner is what a force on the face turns round first.
void share_masses(const ClothModel& model, std::vector<formulas::FaceRest>& rests)
{
    std::vector<double> around(model.vertex_count());
    for (std::size_t face = 0; face < rests.size(); ++face)
        for (int corner = 0; corner < 3; ++corner) around[model.faces[face][corner]] += double(rests[face].area) / 3;
    for (std::size_t face = 0; face < rests.size(); ++face) {
        double lighter = 1;
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = model.faces[face][corner];
            lighter = std::max(lighter, around[v] / double(model.areas[v]));
        }
        rests[face].mass_area = static_cast<float>(double(rests[face].area) / lighter);
    }
}

}  // namespace

FaceForces face_forces(const SimParams& p)
{
    const bool air =
        p.wind_model == WindModel::aero && p.air_density > 0 && (p.pressure_coefficient > 0 || p.skin_coefficient > 0);
    return {p.internal_model == InternalModel::continuum, air, air && p.gust_speed > 0};
}

std::vector<formulas::FaceRest> face_rests(const ClothModel& model)
{
    std::vector<formulas::FaceRest> rests;
    rests.reserve(model.faces.size());
    for (std::size_t face = 0; face < model.faces.size(); ++face) rests.push_back(face_rest(model, face));
    share_masses(model, rests);
    return rests;
}

CornerTable make_corner_table(const ClothModel& model)
{
    CornerTable table{model.vertex_count(), static_cast<std::uint32_t>(model.faces.size()), 0, {}};
    std::vector<int> counts(table.vertex_count);
    for (const glm::uvec3& face : model.faces)
        for (int corner = 0; corner < 3; ++corner) ++counts[face[corner]];
    const int most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
    table.slot_count = (most + 3) / 4 * 4;
    table.corners.assign(static_cast<std::size_t>(table.slot_count) * table.vertex_count, 3 * table.face_count);
    std::fill(counts.begin(), counts.end(), 0);
    for (std::uint32_t face = 0; face < table.face_count; ++face)
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = model.faces[face][static_cast<int>(corner)];
            const auto slot = static_cast<std::size_t>(counts[vertex]++);
            table.corners[slot * table.vertex_count + vertex] = corner * table.face_count + face;
        }
    return table;
}

formulas::MembraneConstants membrane_constants(const SimParams& p)
{
    const double most = double(p.warp_stiffness) * double(p.weft_stiffness);
    if (double(p.cross_stiffness) * double(p.cross_stiffness) > most * (1 + 1e-6))
        throw Error(
            fmt::format("cross_stiffness: {} N/m is more than the root of warp_stiffness times weft_stiffness, "
                        "{:.4g} N/m; a cloth like that would stretch by itself; choose no more than that",
                        p.cross_stiffness, std::sqrt(most)));
    return {p.warp_stiffness, p.weft_stiffness, p.cross_stiffness, p.shear_modulus, p.stiffness_damping};
}

formulas::Air air_of(const SimParams& p)
{
    return {p.air_density, p.pressure_coefficient, p.skin_coefficient, p.areal_density, substep_s(p)};
}

}  // namespace nuno
