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
#include "collision/kept_pairs.h"
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
    // threads. Where the cloth has hardly moved since a query that asked for the same, that one's pairs are gone
    // through once more: the order of pairs, and which of those that need not be found are, depends on earlier queries.
    int begin(const Poses& poses, const TreeSettings& settings, ThreadPool& pool);
    // Calls body(const ElementPair&) for the pairs of one task, in a fixed order; each pair is in one task, once.
    // Different tasks may run on different threads.
    template <class Body>
    void run(int task, const Body& body) const;

    // Pairs of elements of faces that share a vertex which the query leaves out, for they are proven apart.
    std::uint64_t near_pairs_culled() const;
    // Queries so far that went through the pairs of an earlier one.
    std::uint64_t queries_skipped() const { return queries_skipped_; }

    // Writes what later queries take from earlier ones, or reads it.
    void carry(Archive& archive);

  private:
    static constexpr std::uint32_t kNearFaces = 512;  // of a task
    static constexpr std::size_t kKeptPairs = 4096;   // likewise
    static constexpr std::size_t kFacePairs = 64;     // looked at together
    KeptPairs& kept_for(const TreeSettings& settings);
    void keep_pairs(KeptPairs& kept, ThreadPool& pool);
    int kept_tasks() const
    {
        return static_cast<int>((all_kept_[kept_last_].pairs.size() + kKeptPairs - 1) / kKeptPairs);
    }
    std::size_t near_tasks() const
    {
        return tree_.is_proven_apart() ? 0 : (elements_.faces().size() + kNearFaces - 1) / kNearFaces;
    }
    template <class Body>
    void run_kept(std::size_t first_pair, const Body& body) const;
    template <class Body>
    void run_vertex_faces(std::span<const FacePair> faces, const Body& body) const;
    // All vertices of the one that may meet the other, of at most kFacePairs; returns their number.
    std::size_t find_vertex_faces(std::span<const FacePair> faces, std::span<ElementPair> found) const;
    template <class Body>
    void run_near(std::uint32_t first_face, const Body& body) const;
    template <class Body>
    void run_vertices(std::uint32_t from, std::uint32_t to, const Body& body) const;
    template <class Body>
    void run_faces(FacePair faces, const Body& body) const;

    ElementKinds kinds_;
    FaceElements elements_;
    NearPairs near_;  // of faces that share a vertex
    FaceTree tree_;
    SweptElements swept_;

    std::array<KeptPairs, 2> all_kept_;  // callers take turns in asking for two things
    std::size_t kept_last_ = 0;          // of them, of this query
    bool from_kept_ = false;             // whether it goes through those pairs, not through the tree's
    std::vector<std::vector<ElementPair>> kept_of_task_;
    float most_margin_;  // [m]
    std::uint64_t queries_skipped_ = 0;
};

}  // namespace nuno

#include "collision/element_query_run.h"
