// All springs at once (sweep = jacobi) in a compute shader: one dispatch a pass.
#pragma once

#include "gl/program.h"
#include "solver/base/gpu_table.h"
#include "solver/xpbd/jacobi_springs.h"

namespace nuno {

class GpuGather
{
  public:
    explicit GpuGather(std::uint32_t vertex_count);

    // Error where springs do not fit into what this device reads.
    void upload(const JacobiSprings& springs);
    // So many passes, an even number, over these positions; leaves other blocks and textures bound.
    void run(int passes, const VertexBuffer& positions) const;

  private:
    const std::uint32_t vertex_count_;
    VertexBuffer passed_;  // positions after every other pass
    GpuTable neighbours_, share_, share_length_, limit_, limit_length_;
    int quad_count_ = -1;
    bool limited_ = false;
    Program program_;
};

}  // namespace nuno
