// The acceleration of a block of vertices on the CPU: what every method that gathers forces begins with.
#pragma once

#include <optional>

#include "model/formulas.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/cpu_faces.h"
#include "solver/base/spring_blocks.h"
#include "solver/base/vertex_lanes.h"

namespace nuno {

// All that a kernel reads to find accelerations, as plain pointers and numbers.
struct ForceTerms
{
    const SpringBlocks& springs;
    Lanes3 x, v;  // the whole state at which forces are taken
    const float *inverse_mass, *area;
    glm::vec3 gravity;
    float damping, areal_density;
    float stiffness_damping;          // beta [s]
    float wind;                       // [N/m2]
    const CpuFaces* faces = nullptr;  // none: no forces on faces
    FaceInputs face_inputs{};         // x and v left to run_face_pass

    // Takes wind and air at a time.
    void set_time(const SimParams& params, double time_s);
};

// The springs and faces of a model for the parameters of the moment.
class CpuForces
{
  public:
    explicit CpuForces(const ClothModel& model, SpringRule rule = kTrueSprings) : model_(model), rule_(rule) {}

    // Makes the springs anew where the parameters of springs have changed.
    void refresh(const SimParams& params);
    // Terms with the pointers and the wind left to set, without forces on faces.
    ForceTerms terms(const SimParams& params) const;
    // Terms at a time, with the pointers of x, v, inverse_mass and area left to set.
    ForceTerms terms(const SimParams& params, double time_s) const;

  private:
    const ClothModel& model_;
    const SpringRule rule_;
    std::optional<SimParams> made_for_;
    SpringBlocks springs_;
    std::optional<CpuFaces> faces_;
};

// Where there are forces on faces, computes them for this thread's part and waits for the others; to call by every
// thread before acceleration_of_block.
void run_face_pass(const ForceTerms& f, Range blocks, SpinBarrier* barrier);

NUNO_WIDE_INLINE WideVec3 spring_forces(const ForceTerms& f, int block, const WideVec3& x, const WideVec3& v)
{
    WideVec3 sum(0.0f);
    const SpringBlocks& springs = f.springs;
    const auto b = static_cast<std::size_t>(block);
    for (std::uint32_t slot = springs.first_slot[b]; slot < springs.first_slot[b + 1]; ++slot) {
        const Run run = springs.runs[slot];
        const std::uint32_t* neighbours = &springs.neighbours[slot * kLanes];
        const bool gathers = run == SpringBlocks::kGather;
        const WideVec3 d = (gathers ? gather(f.x, neighbours) : load(f.x, run)) - x;
        sum = sum + formulas_wide::spring_force(d, WideFloat(&springs.stiffness[slot * kLanes]),
                                                WideFloat(&springs.tension[slot * kLanes]));
        if (f.stiffness_damping > 0) {
            const WideVec3 u = (gathers ? gather(f.v, neighbours) : load(f.v, run)) - v;
            const WideFloat c = WideFloat(f.stiffness_damping) * WideFloat(&springs.axial[slot * kLanes]);
            sum = sum + formulas_wide::spring_damping_force(d, u, c);
        }
    }
    return sum;
}

// Acceleration [m/s2] of the vertices of a block at position x and velocity v, neighbours as in `f`; 0 where pinned.
NUNO_WIDE_INLINE WideVec3 acceleration_of_block(const ForceTerms& f, int block, const WideVec3& x, const WideVec3& v)
{
    const std::int32_t i = block * kLanes;
    const WideFloat area(f.area + i);
    WideVec3 springs = spring_forces(f, block, x, v);
    if (f.faces) springs = springs + f.faces->force_on_block(block);
    return formulas_wide::acceleration(WideFloat(f.inverse_mass + i), area * WideFloat(f.areal_density),
                                       wide(f.gravity), area * WideFloat(f.damping), v, springs,
                                       area * WideFloat(f.wind));
}

}  // namespace nuno
