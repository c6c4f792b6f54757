// How the tasks of a query are run; included by element_query.h.
#pragma once

#include "collision/element_query.h"

namespace nuno {

template <class Body>
void ElementQuery::run(int task, const Body& body) const
{
    const auto number = static_cast<std::size_t>(task);
    if (from_kept_) return run_kept(number * kKeptPairs, body);
    if (number < near_tasks()) return run_near(static_cast<std::uint32_t>(number) * kNearFaces, body);
    const std::span<const FacePair> pairs = tree_.pairs()[number - near_tasks()];
    if (kinds_ == ElementKinds::vertex_face) return run_vertex_faces(pairs, body);
    // At one pose the tree has compared these boxes already.
    for (const FacePair faces : pairs)
        if (!swept_.is_swept() || swept_.may_meet(swept_.face(faces.a), swept_.face(faces.b))) run_faces(faces, body);
}

template <class Body>
void ElementQuery::run_vertex_faces(std::span<const FacePair> faces, const Body& body) const
{
    std::array<ElementPair, 6 * kFacePairs> found;
    for (std::size_t first = 0; first < faces.size(); first += kFacePairs) {
        const auto some = faces.subspan(first, std::min(kFacePairs, faces.size() - first));
        const std::size_t count = find_vertex_faces(some, found);
        for (std::size_t k = 0; k < count; ++k) body(found[k]);
    }
}

template <class Body>
void ElementQuery::run_kept(std::size_t first_pair, const Body& body) const
{
    const std::vector<ElementPair>& pairs = all_kept_[kept_last_].pairs;
    const std::size_t end = std::min(first_pair + kKeptPairs, pairs.size());
    for (std::size_t k = first_pair; k < end; ++k) {
        const ElementPair& pair = pairs[k];
        const glm::uvec4& v = pair.vertices;
        const bool may_meet = pair.kind == PairKind::vertex_face
                                  ? swept_.may_meet(swept_.vertex(v.x), swept_.face(v.y, v.z, v.w))
                                  : swept_.may_meet(swept_.edge({v.x, v.y}), swept_.edge({v.z, v.w}));
        if (may_meet) body(pair);
    }
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
