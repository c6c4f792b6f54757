// Contacts between layers of cloth, answered on the CPU at the end of every substep.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "core/thread_pool.h"
#include "model/sim_params.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/contact_colours.h"

namespace nuno {

class CpuContacts
{
  public:
    // Replaces all contacts, to be kept from these positions on: xyz [m], w inverse mass [1/kg], one a vertex.
    void set(std::span<const LayerContact> contacts, std::span<const glm::vec4> positions, ContactOrder order);
    bool empty() const { return colours_.contacts.empty(); }

    // The positions at the end of a substep of `params`: which vertices contacts move from there. They last until the
    // next call. Contacts are answered one after another, colour by colour.
    std::span<const VertexMove> answer(std::span<const glm::vec4> positions, const SimParams& params, ThreadPool& pool);

  private:
    void find_active(ThreadPool& pool);
    void answer_one(LayerContact& contact, const SimParams& params);

    ContactColours colours_;
    std::vector<glm::vec4> start_, now_;
    std::vector<std::uint8_t> active_;  // of every contact: may be closer than its thickness
    std::vector<std::uint8_t> moved_;   // of every vertex, in this substep
    std::vector<std::uint32_t> moved_vertices_;
    std::vector<VertexMove> moves_;
};

}  // namespace nuno
