// The tree finds the pairs without a common vertex; the others are a list of the mesh.
#include "collision/tangle.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "collision/face_neighbours.h"
#include "core/task_share.h"

namespace nuno {
namespace {

constexpr std::size_t kPairsOfTask = 4096;

FaceCorners corners_of(const glm::uvec3& face, std::span<const glm::vec4> positions)
{
    return {{glm::vec3(positions[face.x]), glm::vec3(positions[face.y]), glm::vec3(positions[face.z])},
            {face.x, face.y, face.z}};
}

glm::vec3 crossing_place(const FaceCorners& edges, int edge, const FaceCorners& face)
{
    const glm::dvec3 p(edges.x[std::size_t(edge)]), q(edges.x[std::size_t(edge == 2 ? 0 : edge + 1)]), a(face.x[0]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(face.x[1]) - a, glm::dvec3(face.x[2]) - a);
    const double from = glm::dot(normal, p - a), to = glm::dot(normal, q - a), share = from / (from - to);
    return glm::vec3(p + (share >= 0 && share <= 1 ? share : 0.5) * (q - p));
}

// The middle of what is in the boxes of both.
glm::vec3 middle_of(const FaceCorners& f, const FaceCorners& g)
{
    const auto least = [](const FaceCorners& c) { return glm::min(glm::min(c.x[0], c.x[1]), c.x[2]); };
    const auto greatest = [](const FaceCorners& c) { return glm::max(glm::max(c.x[0], c.x[1]), c.x[2]); };
    return 0.5f * (glm::max(least(f), least(g)) + glm::min(greatest(f), greatest(g)));
}

void add_if_met(FacePair pair, std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions,
                std::vector<Tangle>& found)
{
    if (pair.b < pair.a) std::swap(pair.a, pair.b);
    const FaceCorners f = corners_of(faces[pair.a], positions), g = corners_of(faces[pair.b], positions);
    const FaceMeeting meeting = meet(f, g);
    if (meeting.kind == Meeting::none) return;
    const Crossing& crossing = meeting.crossings[0];
    const glm::vec3 place = meeting.crossing_count == 0 ? middle_of(f, g)
                            : crossing.edge_of_first    ? crossing_place(f, crossing.edge, g)
                                                        : crossing_place(g, crossing.edge, f);
    found.push_back({pair, meeting, place});
}

}  // namespace

TangleSearch::TangleSearch(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                           std::span<const Sheet> sheets)
    : tree_(rest_positions, faces, sheets),
      neighbours_(neighbouring_faces(faces, static_cast<std::uint32_t>(rest_positions.size())))
{
}

TangleSearch::TangleSearch(const ClothModel& model) : TangleSearch(model.rest_positions, model.faces, model.sheets) {}

std::vector<Tangle> TangleSearch::find(std::span<const glm::vec4> positions, ThreadPool& pool)
{
    tree_.refit({positions, positions}, {0, Culling::none}, pool);
    tree_.query(pool);
    std::vector<std::span<const FacePair>> tasks;
    const auto add = [&](std::span<const FacePair> pairs) {
        for (std::size_t i = 0; i < pairs.size(); i += kPairsOfTask)
            tasks.push_back(pairs.subspan(i, std::min(kPairsOfTask, pairs.size() - i)));
    };
    add(neighbours_);
    for (const std::span<const FacePair>& part : tree_.pairs()) add(part);

    std::vector<std::vector<Tangle>> found(tasks.size());
    share_tasks(pool, static_cast<int>(tasks.size()), [&](int task, int) {
        for (const FacePair pair : tasks[std::size_t(task)])
            add_if_met(pair, faces(), positions, found[std::size_t(task)]);
    });
    std::vector<Tangle> all;
    for (const std::vector<Tangle>& part : found) all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end(), [](const Tangle& a, const Tangle& b) { return a.faces < b.faces; });
    return all;
}

TangleCounts count_of(std::span<const Tangle> tangles)
{
    TangleCounts counts;
    for (const Tangle& tangle : tangles)
        ++(tangle.meeting.kind == Meeting::crossing ? counts.crossing : counts.touching);
    return counts;
}

std::uint32_t edge_vertex(const Tangle& tangle, const Crossing& crossing, int end, std::span<const glm::uvec3> faces)
{
    const glm::uvec3& face = faces[crossing.edge_of_first ? tangle.faces.a : tangle.faces.b];
    return face[(crossing.edge + end) % 3];
}

}  // namespace nuno
