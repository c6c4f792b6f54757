// Velocity Verlet on CPU threads.
#include "solver/explicit/cpu_verlet.h"

#include <algorithm>

namespace nuno {

// The end of one substep and the beginning of the next in one pass over the vertices: accelerations are taken and kick
// the velocities; then the vertices drift on to the other side of the state.
struct VerletPass
{
    ForceTerms forces;
    BodyContacts bodies;
    Lanes3 v, a, new_x, new_v, new_predicted;
    float h, kick_s;  // kick_s: h/2, or 0 where only accelerations are to be found
    bool kicks, drifts;
};

namespace {

template <bool kBodies, bool kDamped>
NUNO_WIDE_INLINE void pass_with(const VerletPass& p, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(p.forces.x, i);
        WideVec3 v = load(p.v, i), a = load(p.a, i);
        if (p.kicks) {
            a = acceleration_of_block<kDamped>(p.forces, block, x, load(p.forces.v, i));
            v = formulas_wide::verlet_kick(v, a, WideFloat(p.kick_s));
            store(p.a, i, a);
        }
        if (!p.drifts) {
            store(p.v, i, v);
            continue;
        }
        const formulas_wide::Motion free = formulas_wide::verlet_drift(x, v, a, WideFloat(p.h));
        formulas_wide::Motion held = free;
        if constexpr (kBodies) held = push_out_of_bodies<kLanes>(p.bodies, x, free).motion;
        const WideFloat inverse_mass(p.forces.inverse_mass + i);
        const WideVec3 v_half = select_positive(inverse_mass, held.velocity, free.velocity);
        store(p.new_x, i, select_positive(inverse_mass, held.position, free.position));
        store(p.new_v, i, v_half);
        store(p.new_predicted, i, formulas_wide::verlet_kick(v_half, a, WideFloat(0.5f * p.h)));
    }
}

NUNO_SIMD_CLONES void pass_over_blocks(const VerletPass& p, Range blocks)
{
    const bool damped = p.forces.stiffness_damping > 0;
    if (p.bodies.bodies.empty())
        damped ? pass_with<false, true>(p, blocks) : pass_with<false, false>(p, blocks);
    else
        damped ? pass_with<true, true>(p, blocks) : pass_with<true, false>(p, blocks);
}

}  // namespace

CpuVerlet::CpuVerlet(const ClothModel& model, const Bodies& bodies, const SimParams&, ThreadPool& pool)
    : CpuSolver(model, pool),
      forces_(model),
      bodies_(bodies, model),
      predicted_{VertexLanes3(vertex_count_), VertexLanes3(vertex_count_)},
      accelerations_(vertex_count_)
{
}

void CpuVerlet::upload(const ClothState& state)
{
    CpuSolver::upload(state);
    accelerations_for_.reset();
}

void CpuVerlet::upload_velocities(std::span<const glm::vec4> velocities)
{
    CpuSolver::upload_velocities(velocities);
    accelerations_for_.reset();
}

// Whether anything moved or not, as on the GPU.
void CpuVerlet::move_vertices(std::span<const VertexMove> moves)
{
    CpuSolver::move_vertices(moves);
    accelerations_for_.reset();
}

void CpuVerlet::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    CpuSolver::set_vertex(vertex, position);
    accelerations_for_.reset();
}

void CpuVerlet::carry(Archive& archive, const SimParams& params)
{
    bool known = accelerations_for_ && same_params(*accelerations_for_, params);
    archive.value(known);
    accelerations_for_ = known ? std::optional(params) : std::nullopt;
    if (known) accelerations_.carry(archive);
}

void CpuVerlet::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    forces_.refresh(input.params);
    bodies_.plan(input);
    if (accelerations_for_ && !same_params(*accelerations_for_, input.params)) accelerations_for_.reset();
    if (!accelerations_for_) predicted_[current_] = velocities_[current_];
    run_team([&](const Team& team) { step_part(input, team); });
    current_ = (current_ + input.substep_count) % 2;
    accelerations_for_ = input.params;
}

// The state before substep `substep` of the step.
VerletPass CpuVerlet::pass_at(const StepInput& input, int substep)
{
    const int from = (current_ + substep) % 2, to = 1 - from;
    const float h = substep_s(input.params);
    const StateLanes now = state(from), next = state(to);
    StateLanes at = now;
    at.v = predicted_[from].lanes();
    return {.forces = forces_.terms(input.params, input.start_time_s + substep * double(h), at),
            .bodies = bodies_.contacts(std::min(substep, input.substep_count - 1), input.params),
            .v = now.v,
            .a = accelerations_.lanes(),
            .new_x = next.x,
            .new_v = next.v,
            .new_predicted = predicted_[to].lanes(),
            .h = h,
            .kick_s = 0.5f * h,
            .kicks = substep > 0,
            .drifts = substep < input.substep_count};
}

void CpuVerlet::step_part(const StepInput& input, const Team& team)
{
    const Range blocks = team.part(block_count());
    if (!accelerations_for_) {
        VerletPass p = pass_at(input, 0);
        p.kicks = true;
        p.drifts = false;
        p.kick_s = 0;
        run_face_pass(p.forces, blocks, team);
        pass_over_blocks(p, blocks);
        team.wait();
    }
    for (int k = 0; k <= input.substep_count; ++k) {
        const VerletPass p = pass_at(input, k);
        if (p.kicks) run_face_pass(p.forces, blocks, team);
        pass_over_blocks(p, blocks);
        if (p.drifts) {
            bodies_.place_pins(k, blocks, p.new_x, p.new_v);
            bodies_.place_pins(k, blocks, p.new_x, p.new_predicted);
        }
        team.wait();
    }
}

}  // namespace nuno
