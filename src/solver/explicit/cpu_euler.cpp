// Explicit and symplectic Euler on CPU threads.
#include "solver/explicit/cpu_euler.h"

namespace nuno {
namespace {

struct Substep
{
    ForceTerms forces;
    BodyContacts bodies;
    Lanes3 new_x, new_v;
    float h;
    Method method;
};

// One substep of the vertices of blocks.begin .. blocks.end; what scenes without bodies or dampers leave out is not there.
template <bool kBodies, bool kDamped>
NUNO_WIDE_INLINE void substep_with(const Substep& s, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(s.forces.x, i), v = load(s.forces.v, i);
        const WideVec3 a = acceleration_of_block<kDamped>(s.forces, block, x, v);
        const formulas_wide::Motion free = s.method == Method::explicit_euler
                                               ? formulas_wide::explicit_euler(x, v, a, WideFloat(s.h))
                                               : formulas_wide::symplectic_euler(x, v, a, WideFloat(s.h));
        formulas_wide::Motion held = free;
        if constexpr (kBodies) held = push_out_of_bodies<kLanes>(s.bodies, x, free).motion;
        const WideFloat inverse_mass(s.forces.inverse_mass + i);
        store(s.new_x, i, select_positive(inverse_mass, held.position, free.position));
        store(s.new_v, i, select_positive(inverse_mass, held.velocity, free.velocity));
    }
}

NUNO_SIMD_CLONES void substep_blocks(const Substep& s, Range blocks)
{
    const bool damped = s.forces.stiffness_damping > 0;
    if (s.bodies.bodies.empty())
        damped ? substep_with<false, true>(s, blocks) : substep_with<false, false>(s, blocks);
    else
        damped ? substep_with<true, true>(s, blocks) : substep_with<true, false>(s, blocks);
}

}  // namespace

CpuEuler::CpuEuler(const ClothModel& model, const Bodies& bodies, const SimParams& params, ThreadPool& pool)
    : CpuSolver(model, pool), method_(params.method), forces_(model), bodies_(bodies, model)
{
}

std::string_view CpuEuler::name() const
{
    return method_ == Method::explicit_euler ? "explicit_euler on cpu" : "symplectic_euler on cpu";
}

void CpuEuler::step(const StepInput& input)
{
    forces_.refresh(input.params);
    bodies_.plan(input);
    run_substeps(input.substep_count, [&](int k, const Team& team) { run_substep(input, k, team); });
}

void CpuEuler::run_substep(const StepInput& input, int k, const Team& team)
{
    const SimParams& p = input.params;
    const Range blocks = team.part(block_count());
    const int from = (current_ + k) % 2;
    const StateLanes next = state(1 - from);
    const float h = substep_s(p);
    const Substep s{.forces = forces_.terms(p, input.start_time_s + k * double(h), state(from)),
                    .bodies = bodies_.contacts(k, p),
                    .new_x = next.x,
                    .new_v = next.v,
                    .h = h,
                    .method = method_};
    run_face_pass(s.forces, blocks, team);
    substep_blocks(s, blocks);
    bodies_.place_pins(k, blocks, next.x, next.v);
    team.wait();
}

}  // namespace nuno
