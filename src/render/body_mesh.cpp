// The vertices that bodies are drawn from.
#include "render/body_mesh.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace nuno {
namespace {

constexpr std::uint32_t kStepsAQuarter = 12;
constexpr std::uint32_t kPerQuarter = kStepsAQuarter + 1;  // both ends: neighbouring parts have their own
constexpr std::uint32_t kColumns = 4 * kPerQuarter, kRings = 2 * kPerQuarter;
constexpr float kSmoothCosine = 0.77f;

// Angle of a column or ring whose quarters have both their ends [rad].
float angle_of(std::uint32_t number)
{
    const std::uint32_t steps = number / kPerQuarter * kStepsAQuarter + number % kPerQuarter;
    return glm::half_pi<float>() * float(steps) / kStepsAQuarter;
}

}  // namespace

void append_rounded_box(BodyGeometry& geometry)
{
    const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const float polar = angle_of(ring), azimuth = angle_of(column);
            const std::uint32_t quarter = column / kPerQuarter;
            const glm::vec3 corner(quarter < 2 ? 1 : -1, ring < kPerQuarter ? 1 : -1, quarter % 3 == 0 ? 1 : -1);
            geometry.vertices.push_back(
                {corner, {std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth)}});
        }
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring)
        for (std::uint32_t i = 0; i < kColumns; ++i) {
            const std::uint32_t j = (i + 1) % kColumns;
            const std::uint32_t a = first + ring * kColumns + i, b = first + ring * kColumns + j;
            geometry.indices.insert(geometry.indices.end(), {a, a + kColumns, b, b, a + kColumns, b + kColumns});
        }
    const std::uint32_t top = first, bottom = first + (kRings - 1) * kColumns, q = kPerQuarter;
    geometry.indices.insert(geometry.indices.end(), {top, top + q, top + 2 * q, top, top + 2 * q, top + 3 * q});
    geometry.indices.insert(geometry.indices.end(),
                            {bottom, bottom + 2 * q, bottom + q, bottom, bottom + 3 * q, bottom + 2 * q});
}

void append_mesh(BodyGeometry& geometry, const TriangleMesh& mesh)
{
    std::vector<glm::vec3> areas;  // of each face, along its normal
    std::vector<std::vector<std::uint32_t>> around(mesh.positions.size());
    for (const glm::uvec3& face : mesh.faces) {
        const glm::vec3 a = mesh.positions[face.x], b = mesh.positions[face.y], c = mesh.positions[face.z];
        for (int k = 0; k < 3; ++k) around[face[k]].push_back(static_cast<std::uint32_t>(areas.size()));
        areas.push_back(glm::cross(b - a, c - a));
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = mesh.faces[f][k];
            glm::vec3 sum(0);
            for (const std::uint32_t other : around[vertex])
                if (glm::dot(glm::normalize(areas[other]), glm::normalize(areas[f])) > kSmoothCosine)
                    sum += areas[other];
            geometry.indices.push_back(static_cast<std::uint32_t>(geometry.vertices.size()));
            geometry.vertices.push_back({mesh.positions[vertex], glm::normalize(sum)});
        }
}

}  // namespace nuno
