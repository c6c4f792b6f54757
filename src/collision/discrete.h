// Level `discrete`: the contacts of vertices with faces where the cloth is now (seed paper, section 2.5.1.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/contact.h"
#include "collision/element_query.h"
#include "core/thread_pool.h"

namespace nuno {

// Of all faces [m], at these positions (xyz [m]).
float longest_edge(std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions);

// How near [m] a vertex is, at most, to a face that it is in contact with at these positions.
float contact_reach(const ContactRange& range, std::span<const glm::uvec3> faces, std::span<const glm::vec4> positions);

// Keeps its storage from one search to the next.
class ContactSearch
{
  public:
    // All contacts at `positions` (xyz [m]), in order of vertex and face; they last until the next search. `query`, of
    // vertices and faces alone, has begun on `task_count` tasks at the same positions, with contact_reach as its
    // distance. A corner of a face is never in contact with it. Nothing is dropped: storage grows.
    std::span<const Contact> find(const ElementQuery& query, int task_count, std::span<const glm::vec4> positions,
                                  const ContactRange& range, ThreadPool& pool);

    // Pairs of a vertex and a face whose boxes overlapped in the last search.
    std::uint64_t pairs_tested() const { return pairs_tested_; }

  private:
    struct Task
    {
        std::vector<Contact> contacts;
        std::uint64_t pairs_tested;
    };
    std::vector<Task> tasks_;
    std::vector<Contact> contacts_;
    std::uint64_t pairs_tested_ = 0;
};

}  // namespace nuno
