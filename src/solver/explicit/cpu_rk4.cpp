// The classic Runge-Kutta method on CPU threads.
#include "solver/explicit/cpu_rk4.h"

namespace nuno {

constexpr int kStages = 4;

// Stage `number`, 0 .. 3, of a substep: reads the slopes at `forces.x`, `forces.v`, adds them to the sums, and leaves
// the state of the next stage, or the end of the substep, in `next_x`, `next_v`.
struct Rk4Stage
{
    ForceTerms forces;
    BodyContacts bodies;
    Lanes3 start_x, start_v, sum_v, sum_a, next_x, next_v;
    int number;
    float h;

    float weight() const { return number == 0 || number == 3 ? 1.0f : 2.0f; }
    float next_step() const { return number < 2 ? 0.5f * h : h; }
};

namespace {

using F = formulas_wide;

template <bool kBodies>
NUNO_WIDE_INLINE F::Motion end_of_substep(const Rk4Stage& s, const F::Motion& start, const F::Motion& sum,
                                          std::int32_t i)
{
    const F::Motion free = F::rk4_end(start, sum, WideFloat(s.h));
    F::Motion held = free;
    if constexpr (kBodies) held = push_out_of_bodies<kLanes>(s.bodies, start.position, free).motion;
    return F::select_motion(WideFloat(s.forces.inverse_mass + i), held, free);
}

template <bool kBodies, bool kDamped>
NUNO_WIDE_INLINE void stage_with(const Rk4Stage& s, Range blocks)
{
    const WideFloat weight(s.weight()), next_step(s.next_step());
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 v = load(s.forces.v, i);
        const WideVec3 a = acceleration_of_block<kDamped>(s.forces, block, load(s.forces.x, i), v);
        const F::Motion start = F::motion(load(s.start_x, i), load(s.start_v, i));
        const F::Motion before =
            s.number == 0 ? F::motion(WideVec3(0.0f), WideVec3(0.0f)) : F::motion(load(s.sum_v, i), load(s.sum_a, i));
        const F::Motion sum = F::rk4_add(before, v, a, weight);
        store(s.sum_v, i, sum.position);
        store(s.sum_a, i, sum.velocity);
        const F::Motion next =
            s.number + 1 < kStages ? F::rk4_stage(start, v, a, next_step) : end_of_substep<kBodies>(s, start, sum, i);
        store(s.next_x, i, next.position);
        store(s.next_v, i, next.velocity);
    }
}

NUNO_SIMD_CLONES void stage_blocks(const Rk4Stage& s, Range blocks)
{
    const bool damped = s.forces.stiffness_damping > 0;
    if (s.bodies.bodies.empty())
        damped ? stage_with<false, true>(s, blocks) : stage_with<false, false>(s, blocks);
    else
        damped ? stage_with<true, true>(s, blocks) : stage_with<true, false>(s, blocks);
}

}  // namespace

CpuRk4::CpuRk4(const ClothModel& model, const Bodies& bodies, const SimParams&, ThreadPool& pool)
    : CpuSolver(model, pool),
      forces_(model),
      bodies_(bodies, model),
      stage_positions_{VertexLanes3(vertex_count_), VertexLanes3(vertex_count_)},
      stage_velocities_{VertexLanes3(vertex_count_), VertexLanes3(vertex_count_)},
      velocity_sums_(vertex_count_),
      acceleration_sums_(vertex_count_)
{
}

void CpuRk4::step(const StepInput& input)
{
    forces_.refresh(input.params);
    bodies_.plan(input);
    run_substeps(input.substep_count, [&](int k, const Team& team) { run_substep(input, k, team); });
}

Rk4Stage CpuRk4::stage_at(const StepInput& input, int substep, int number)
{
    const int from = (current_ + substep) % 2;
    const auto read = static_cast<std::size_t>(number % 2), write = 1 - read;
    const bool first = number == 0, last = number + 1 == kStages;
    const float h = substep_s(input.params);
    const int halves = (number + 1) / 2;  // of the substep: 0, 1, 1, 2
    const double time_s = input.start_time_s + (substep + 0.5 * halves) * double(h);
    const StateLanes start = state(from), end = state(1 - from);
    StateLanes at = start;
    if (!first) {
        at.x = stage_positions_[read].lanes();
        at.v = stage_velocities_[read].lanes();
    }
    return {.forces = forces_.terms(input.params, time_s, at),
            .bodies = bodies_.contacts(substep, input.params),
            .start_x = start.x,
            .start_v = start.v,
            .sum_v = velocity_sums_.lanes(),
            .sum_a = acceleration_sums_.lanes(),
            .next_x = last ? end.x : stage_positions_[write].lanes(),
            .next_v = last ? end.v : stage_velocities_[write].lanes(),
            .number = number,
            .h = h};
}

void CpuRk4::run_substep(const StepInput& input, int k, const Team& team)
{
    const Range blocks = team.part(block_count());
    for (int number = 0; number < kStages; ++number) {
        const Rk4Stage s = stage_at(input, k, number);
        run_face_pass(s.forces, blocks, team);
        stage_blocks(s, blocks);
        if (number + 1 == kStages) bodies_.place_pins(k, blocks, s.next_x, s.next_v);
        team.wait();
    }
}

}  // namespace nuno
