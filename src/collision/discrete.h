// Level `discrete`: the contacts of vertices with faces where the cloth is now (seed paper, section 2.5.1.2).
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/box_tree.h"
#include "collision/contact.h"
#include "collision/pair_query.h"
#include "core/thread_pool.h"

namespace nuno {

// The margin with which the tree has to be refitted for contacts within `range`.
BoxMargin contact_margin(const ContactRange& range);

// Keeps its storage from one search to the next.
class ContactSearch
{
  public:
    // All contacts at `positions` (xyz [m]), in order of vertex and face; they last until the next search. `tree` has
    // been refitted to the same positions with contact_margin(range). A corner of a face is never in contact with it.
    // Nothing is dropped: storage grows.
    std::span<const Contact> find(const BoxTree& tree, std::span<const glm::vec4> positions, const ContactRange& range,
                                  Culling culling, ThreadPool& pool);

    PairCounts counts() const { return query_.counts(); }

  private:
    PairQuery query_;
    std::vector<std::vector<Contact>> found_;  // by task
    std::vector<Contact> contacts_;
};

}  // namespace nuno
