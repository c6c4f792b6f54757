// Forces on faces on CPU threads: kLanes faces at once, and how the corners' forces come together in the vertices.
#pragma once

#include <vector>

#include "core/thread_pool.h"
#include "model/face_table.h"
#include "model/wind_field.h"
#include "solver/base/vertex_lanes.h"

namespace nuno {

// What a pass over faces reads.
struct FaceInputs
{
    FaceForces wanted{};
    formulas::MembraneConstants membrane{};
    formulas::Air air{};
    AirField field{};
    Lanes3 x{}, v{};
};

class CpuFaces
{
  public:
    explicit CpuFaces(const ClothModel& model);

    // Computes the forces on the corners of a part of the faces: that part of them all which `blocks` is of the blocks
    // of kLanes vertices.
    void run(const FaceInputs& in, Range blocks) const;

    // Sum over the corners that meet in each vertex of a block.
    NUNO_WIDE_INLINE WideVec3 force_on_block(int block) const
    {
        WideVec3 sum(0.0f);
        const std::uint32_t* corners = &corners_[static_cast<std::size_t>(block * slot_count_ * kLanes)];
        for (int slot = 0; slot < slot_count_; ++slot) sum = sum + gather(forces_.lanes(), corners + slot * kLanes);
        return sum;
    }

    int block_count() const { return vertex_block_count_; }

  private:
    int vertex_block_count_, face_block_count_, slot_count_;
    std::vector<std::uint32_t> vertices_;  // (block * 3 + corner) * kLanes + lane
    std::vector<float> rest_;              // (block * 6 + number of FaceRest) * kLanes + lane
    std::vector<std::uint32_t> corners_;   // (block * slot_count + slot) * kLanes + lane, into forces_
    mutable VertexLanes3 forces_;          // corner * faces (padded) + face; the last is 0
};

}  // namespace nuno
