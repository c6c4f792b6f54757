// Contacts of a solver on CPU threads.
#include "solver/base/host_solver.h"

namespace nuno {

void HostSolver::set_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count, ContactOrder order)
{
    contact_positions_.resize(vertex_count);
    download_positions(contact_positions_);
    contacts_.set(contacts, contact_positions_, order);
}

void HostSolver::keep_contacts(const SimParams& params)
{
    if (contacts_.empty()) return;
    download_positions(contact_positions_);
    move_vertices(contacts_.answer(contact_positions_, params, pool_));
}

}  // namespace nuno
