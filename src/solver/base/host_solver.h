// What all solvers on CPU threads have in common.
#pragma once

#include <vector>

#include "solver/base/cpu_contacts.h"

namespace nuno {

class HostSolver : public ClothSolver
{
  public:
    explicit HostSolver(ThreadPool& pool) : pool_(pool) {}

    void finish() override {}
    std::uint32_t position_buffer() const override { return 0; }
    void set_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count, ContactOrder order) override;
    void keep_contacts(const SimParams& params) override;

  protected:
    virtual void move_vertices(std::span<const VertexMove> moves) = 0;

    ThreadPool& pool_;

  private:
    CpuContacts contacts_;
    std::vector<glm::vec4> contact_positions_;  // of every vertex, for a while
};

}  // namespace nuno
