// All pairs of a vertex and a face, and of two edges, that may come near each other on a way; as tasks for several
// threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/face_elements.h"
#include "collision/swept_elements.h"
#include "collision/tree/face_tree.h"
#include "core/thread_pool.h"

namespace nuno {

class ElementQuery
{
  public:
    // Rest positions [m] and faces of all sheets together; without sheets, all faces are one mesh.
    ElementQuery(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                 std::span<const Sheet> sheets = {}, ElementKinds kinds = ElementKinds::all);

    std::span<const glm::uvec3> faces() const { return elements_.faces(); }

    // Begins a query of what comes as near as the settings ask on the way of the poses, which must stay as they are
    // until the last task is done; returns the number of tasks. What the tasks are does not depend on the number of
    // threads.
    int begin(const Poses& poses, const TreeSettings& settings, ThreadPool& pool);
    // Calls body(const ElementPair&) for the pairs of one task, in a fixed order; each pair is in one task, once.
    // Different tasks may run on different threads.
    template <class Body>
    void run(int task, const Body& body) const;

    // Pairs of elements of faces that share a vertex which the query leaves out, for they are proven apart.
    std::uint64_t near_pairs_culled() const;

  private:
    static constexpr std::uint32_t kNearFaces = 512;  // of a task
    std::size_t near_tasks() const
    {
        return tree_.is_proven_apart() ? 0 : (elements_.faces().size() + kNearFaces - 1) / kNearFaces;
    }
    template <class Body>
    void run_near(std::uint32_t first_face, const Body& body) const;
    template <class Body>
    void run_vertices(std::uint32_t from, std::uint32_t to, const Body& body) const;
    template <class Body>
    void run_faces(FacePair faces, const Body& body) const;

    FaceElements elements_;
    NearPairs near_;  // of faces that share a vertex
    FaceTree tree_;
    SweptElements swept_;
};

template <class Body>
void ElementQuery::run(int task, const Body& body) const
{
    const auto number = static_cast<std::size_t>(task);
    if (number < near_tasks()) return run_near(static_cast<std::uint32_t>(number) * kNearFaces, body);
    for (const FacePair faces : tree_.pairs()[number - near_tasks()])
        if (swept_.may_meet(swept_.face(faces.a), swept_.face(faces.b))) run_faces(faces, body);
}

template <class Body>
void ElementQuery::run_near(std::uint32_t first_face, const Body& body) const
{
    const std::uint32_t end = std::min(first_face + kNearFaces, static_cast<std::uint32_t>(elements_.faces().size()));
    for (std::uint32_t face = first_face; face < end; ++face) {
        if (tree_.is_apart_from_neighbours(face)) continue;
        for (const ElementPair& pair : near_.of(face)) {
            const glm::uvec4& v = pair.vertices;
            const bool may_meet = pair.kind == PairKind::vertex_face
                                      ? swept_.may_meet(swept_.vertex(v.x), swept_.face(pair.face))
                                      : swept_.may_meet(swept_.edge({v.x, v.y}), swept_.edge({v.z, v.w}));
            if (may_meet) body(pair);
        }
    }
}

template <class Body>
void ElementQuery::run_vertices(std::uint32_t from, std::uint32_t to, const Body& body) const
{
    const glm::uvec3& face = elements_.faces()[to];
    for (const std::uint32_t v : elements_.owned(from).vertices)
        if (v != FaceElements::kNone && swept_.may_meet(swept_.vertex(v), swept_.face(to)))
            body(ElementPair{PairKind::vertex_face, {v, face.x, face.y, face.z}, to});
}

// Edges that may meet the other face, with each other.
template <class Body>
void ElementQuery::run_faces(FacePair faces, const Body& body) const
{
    run_vertices(faces.a, faces.b, body);
    run_vertices(faces.b, faces.a, body);
    struct Edge
    {
        glm::uvec2 ends;
        SweptElement sweep;
    };
    std::array<Edge, 3> second;
    int count = 0;
    for (const glm::uvec2& ends : elements_.owned(faces.b).edges) {
        if (ends.x == FaceElements::kNone) continue;
        second[std::size_t(count)] = {ends, swept_.edge(ends)};
        count += swept_.may_meet(second[std::size_t(count)].sweep, swept_.face(faces.a));
    }
    if (count == 0) return;
    for (const glm::uvec2& ends : elements_.owned(faces.a).edges) {
        if (ends.x == FaceElements::kNone) continue;
        const SweptElement sweep = swept_.edge(ends);
        if (!swept_.may_meet(sweep, swept_.face(faces.b))) continue;
        for (int i = 0; i < count; ++i) {
            const Edge& other = second[std::size_t(i)];
            if (swept_.may_meet(sweep, other.sweep))
                body(ElementPair{PairKind::edge_edge, {ends.x, ends.y, other.ends.x, other.ends.y}, 0});
        }
    }
}

}  // namespace nuno
