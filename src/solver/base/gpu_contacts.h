// Contacts between layers of cloth, answered by a kernel at the end of every substep.
#pragma once

#include <span>

#include "gl/program.h"
#include "model/sim_params.h"
#include "solver/base/contact_colours.h"
#include "solver/base/gpu_table.h"

namespace nuno {

class GpuContacts
{
  public:
    explicit GpuContacts(std::uint32_t vertex_count);

    // Replaces all contacts, to be kept from these positions on.
    void set(std::span<const LayerContact> contacts, const Buffer& positions, ContactOrder order);
    bool empty() const { return colour_count_ == 0; }
    // Moves `positions`, at the end of a substep of `params`; `new_velocities` are `velocities` with what that gains,
    // and may be the same buffer.
    void answer(const Buffer& positions, const Buffer& velocities, const Buffer& new_velocities,
                const SimParams& params);

  private:
    Program program_;
    const std::uint32_t vertex_count_;
    int colour_count_ = 0;
    Buffer contacts_, start_, end_;
    GpuTable colour_starts_;
};

}  // namespace nuno
