// The coloured constraints of xpbd in compute shaders, of all sheets together: one dispatch a colour.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gl/program.h"
#include "solver/xpbd/gpu_springs.h"
#include "solver/xpbd/mesh_constraints.h"

namespace nuno {

class GpuConstraints
{
  public:
    // `model` must outlive it.
    explicit GpuConstraints(const ClothModel& model);

    // Numbers that the constraints are made of, as MeshConstraints has them.
    struct Numbers
    {
        float step;  // [s]
        int projections;
        float limit;  // 0: none
    };
    // Makes the constraints anew for weights, one a spring of the model, and inverse masses, one a vertex. Error where
    // they do not fit into what this device reads.
    void choose(std::span<const SpringWeight> weights, const Numbers& numbers, std::span<const float> inverse_masses);
    // The same constraints with other numbers; `limit` may change, but not from or to none.
    void set_numbers(const Numbers& numbers, std::span<const float> inverse_masses);

    // `pairs` times: every colour once, and once more in the exact reverse, in the positions bound as read and as
    // written.
    void sweep(int pairs) const;

    // Whether they are to be swept by one work group, which takes them from springs(), instead: a small cloth without
    // plates.
    bool fit_one_group() const;
    const GpuSprings& springs() const { return springs_; }

  private:
    void make_numbers(const Numbers& numbers, std::span<const float> inverse_masses);
    ColouredSprings coloured_springs() const;
    void upload_spring_numbers();
    void upload_plates(bool with_ends);
    void project_plates(std::size_t colour) const;
    void sweep_plates() const;

    const ClothModel& model_;
    std::vector<std::unique_ptr<MeshConstraints>> sheets_;
    std::vector<std::vector<std::int32_t>> vertices_;  // of each sheet, by place, -1 past the last
    bool limited_ = false;
    GpuSprings springs_;
    std::vector<std::int32_t> first_plate_;  // of each colour, and one past the last
    GpuTable plate_ends_, plate_coefficients_, plate_shares_;
    Program plates_;
};

}  // namespace nuno
