// Every vertex against every face.
#include "collision/brute_force.h"

#include <cmath>
#include <tuple>

#include "collision/pass_through.h"
#include "model/formulas.h"

namespace nuno {

std::vector<Contact> brute_force_contacts(std::span<const glm::vec4> positions, std::span<const glm::uvec3> faces,
                                          const ContactRange& range)
{
    const float least = -range.edge_tolerance, most = 1.0f + range.edge_tolerance;
    std::vector<Contact> contacts;
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            const auto [a, b, c] = std::tuple(faces[f].x, faces[f].y, faces[f].z);
            if (v == a || v == b || v == c) continue;
            const auto foot = formulas::face_foot(positions[v], positions[a], positions[b], positions[c]);
            const glm::vec3 w = foot.weights;
            if (w.x < least || w.y < least || w.z < least || w.x > most || w.y > most || w.z > most) continue;
            if (std::abs(foot.distance) > range.thickness) continue;
            const float side = foot.distance < 0 ? -1.0f : 1.0f;
            contacts.push_back({v, f, w, side * foot.normal, side * foot.distance});
        }
    }
    return contacts;
}

std::vector<VertexFace> brute_force_pass_through(std::span<const glm::vec4> positions_t0,
                                                 std::span<const glm::vec4> positions_t1,
                                                 std::span<const glm::uvec3> faces)
{
    std::vector<VertexFace> found;
    for (std::uint32_t v = 0; v < positions_t0.size(); ++v) {
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            const glm::uvec3 face = faces[f];
            if (v == face.x || v == face.y || v == face.z) continue;
            if (passes_through(path_of(v, positions_t0, positions_t1), path_of(face.x, positions_t0, positions_t1),
                               path_of(face.y, positions_t0, positions_t1),
                               path_of(face.z, positions_t0, positions_t1)))
                found.push_back({v, f});
        }
    }
    return found;
}

}  // namespace nuno
