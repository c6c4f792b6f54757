// The acceleration of a block of vertices on the CPU: what every method that gathers forces begins with.
#pragma once

#include <optional>

#include "model/formulas.h"
#include "solver/base/cloth_solver.h"
#include "solver/base/cpu_faces.h"
#include "solver/base/spring_blocks.h"
#include "solver/base/team.h"

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
    FaceInputs face_inputs{};
};

// The springs and faces of a model for the parameters of the moment. `rule` kNoSprings: forces on faces alone.
class CpuForces
{
  public:
    explicit CpuForces(const ClothModel& model, SpringRule rule = kTrueSprings) : model_(model), rule_(rule) {}

    // Makes the springs anew where the parameters of springs have changed.
    void refresh(const SimParams& params);
    // What a kernel reads to find the accelerations of a state at a time.
    ForceTerms terms(const SimParams& params, double time_s, const StateLanes& state) const;

  private:
    const ClothModel& model_;
    const SpringRule rule_;
    std::optional<SimParams> made_for_;
    SpringBlocks springs_;
    std::optional<CpuFaces> faces_;
};

// Where there are forces on faces, computes them for this thread's part and waits for the others; to call by every
// thread before acceleration_of_block.
void run_face_pass(const ForceTerms& f, Range blocks, const Team& team);

// kDamped: with stiffness_damping. Asked at every spring, those without it cost a seventh more.
template <bool kDamped>
NUNO_WIDE_INLINE WideVec3 spring_forces(const ForceTerms& f, int block, const WideVec3& x, const WideVec3& v)
{
    WideVec3 sum(0.0f);
    const SpringBlocks& springs = f.springs;
    const auto b = static_cast<std::size_t>(block);
    for (std::uint32_t slot = springs.first_slot[b]; slot < springs.first_slot[b + 1]; ++slot) {
        const WideVec3 d = load_neighbours(springs, slot, f.x) - x;
        sum = sum + formulas_wide::spring_force(d, WideFloat(&springs.stiffness[slot * kLanes]),
                                                WideFloat(&springs.tension[slot * kLanes]));
        if constexpr (kDamped) {
            const WideVec3 u = load_neighbours(springs, slot, f.v) - v;
            const WideFloat c = WideFloat(f.stiffness_damping) * WideFloat(&springs.axial[slot * kLanes]);
            sum = sum + formulas_wide::spring_damping_force(d, u, c);
        }
    }
    return sum;
}

// Acceleration [m/s2] of the vertices of a block at position x and velocity v, neighbours as in `f`; 0 where pinned.
template <bool kDamped>
NUNO_WIDE_INLINE WideVec3 acceleration_of_block(const ForceTerms& f, int block, const WideVec3& x, const WideVec3& v)
{
    const std::int32_t i = block * kLanes;
    const WideFloat area(f.area + i);
    WideVec3 springs = spring_forces<kDamped>(f, block, x, v);
    if (f.faces) springs = springs + f.faces->force_on_block(block);
    return formulas_wide::acceleration(WideFloat(f.inverse_mass + i), area * WideFloat(f.areal_density),
                                       wide(f.gravity), area * WideFloat(f.damping), v, springs,
                                       area * WideFloat(f.wind));
}

}  // namespace nuno
