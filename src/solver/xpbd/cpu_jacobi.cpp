// XPBD on CPU threads with all springs at once.
#include "solver/xpbd/cpu_jacobi.h"

#include <cassert>

namespace nuno {

// What the lanes of the new state hold before is the state one substep ago (src/solver/xpbd/mesh_motion.cpp does the
// same with positions in another order).
struct CpuJacobi::Substep
{
    ForceTerms forces;  // at the start, where x and v are read
    BodyContacts bodies;
    SubstepTimes times;
    glm::vec3 common;  // [m/s2]
    const SpringBlocks &springs, &limits;
    bool limited;
    Lanes3 x, v, predicted, passed;
    TetherLanes tethers;
};

namespace {

using Formulas = formulas_wide;

NUNO_WIDE_INLINE WideVec3 acceleration(const CpuJacobi::Substep& s, int block)
{
    const WideVec3 common = wide(s.common);
    if (!s.forces.faces) return common;
    return common + WideFloat(s.forces.inverse_mass + block * kLanes) * s.forces.faces->force_on_block(block);
}

NUNO_SIMD_CLONES void predict_blocks(const CpuJacobi::Substep& s, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(s.forces.x, i), v = load(s.forces.v, i);
        const WideFloat inverse_mass(s.forces.inverse_mass + i);
        Formulas::Motion m =
            Formulas::predicted_motion(Formulas::motion(x, v), Formulas::motion(load(s.x, i), load(s.v, i)),
                                       acceleration(s, block), WideFloat(s.times.keep), WideFloat(s.times.step));
        m = push_out_of_bodies<kLanes>(s.bodies, x, m).motion;
        m = Formulas::select_motion(inverse_mass, m, Formulas::motion(x, v));
        store(s.v, i, m.velocity);
        store(s.predicted, i, m.position);
        const WideVec3 to = within_tethers(s.tethers, s.forces.x, i, m.position);
        store(s.x, i, select_positive(inverse_mass, to, x));
    }
}

NUNO_SIMD_CLONES void pass_over_blocks(const CpuJacobi::Substep& s, const Lanes3& from, const Lanes3& to, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(from, i);
        WideVec3 sum(0.0f);
        const auto b = static_cast<std::size_t>(block);
        for (std::uint32_t slot = s.springs.first_slot[b]; slot < s.springs.first_slot[b + 1]; ++slot) {
            const WideVec3 d = load_neighbours(s.springs, slot, from) - x;
            WideFloat pull = Formulas::spring_pull(d, WideFloat(&s.springs.stiffness[slot * kLanes]),
                                                   WideFloat(&s.springs.tension[slot * kLanes]));
            if (s.limited)
                pull = max_real(pull, Formulas::spring_pull(d, WideFloat(&s.limits.stiffness[slot * kLanes]),
                                                            WideFloat(&s.limits.tension[slot * kLanes])));
            sum = sum + pull * d;
        }
        store(to, i, x + WideFloat(s.forces.inverse_mass + i) * sum);
    }
}

NUNO_SIMD_CLONES void finish_blocks(const CpuJacobi::Substep& s, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideFloat inverse_mass(s.forces.inverse_mass + i);
        const WideVec3 x = load(s.x, i), v = load(s.v, i);
        const WideVec3 end = Formulas::corrected_velocity(v, load(s.predicted, i), x, WideFloat(s.times.per_step));
        Formulas::Motion m = Formulas::motion(x, end);
        if (!s.bodies.bodies.empty()) {
            Formulas::Motion last = Formulas::motion(load(s.forces.x, i), load(s.forces.v, i));
            m = push_out_of_bodies<kLanes>(s.bodies, last.position, m).motion;
            last = Formulas::last_after_contact(last, m, end, acceleration(s, block), WideFloat(s.times.h));
            store(s.forces.x, i, last.position);
            store(s.forces.v, i, last.velocity);
            store(s.x, i, select_positive(inverse_mass, m.position, x));
        }
        store(s.v, i, select_positive(inverse_mass, m.velocity, v));
    }
}

SpringBlocks blocks_of(const JacobiSprings& springs, const std::vector<float>& share, const std::vector<float>& length)
{
    return make_spring_blocks({springs.vertex_count, springs.slot_count, springs.neighbours, share, length,
                               std::vector<float>(share.size())});
}

}  // namespace

CpuJacobi::CpuJacobi(const ClothModel& model, const Bodies& bodies, const SimParams&, ThreadPool& pool)
    : CpuSolver(model, pool),
      model_(model),
      forces_(model, kNoSprings),
      bodies_(bodies, model),
      tethers_(model, {}, vertex_count_),
      predicted_(vertex_count_),
      passed_(vertex_count_)
{
}

void CpuJacobi::upload(const ClothState& state)
{
    CpuSolver::upload(state);
    tethers_.pins().upload(state);
    masses_changed_ = true;
    last_is_known_ = false;
}

void CpuJacobi::forget_last(std::uint32_t vertex)
{
    const formulas::Motion last = assumed_past(*made_for_, glm::vec3(positions_[current_].at(vertex, 0)),
                                               glm::vec3(velocities_[current_].at(vertex, 0)));
    positions_[1 - current_].put(vertex, glm::vec4(last.position, 0));
    velocities_[1 - current_].put(vertex, glm::vec4(last.velocity, 0));
}

void CpuJacobi::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t v = 0; v < vertex_count_; ++v) {
        if (glm::vec3(velocities[v]) == glm::vec3(velocities_[current_].at(v, 0))) continue;
        velocities_[current_].put(v, velocities[v]);
        if (last_is_known_) forget_last(v);
    }
}

void CpuJacobi::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    masses_changed_ = masses_changed_ || inverse_mass_.first()[vertex] != position.w;
    CpuSolver::set_vertex(vertex, position);
    tethers_.pins().set_vertex(vertex, position);
    if (last_is_known_) forget_last(vertex);
}

void CpuJacobi::refresh_springs(const SimParams& params)
{
    const JacobiSprings made =
        make_jacobi_springs(model_, params, std::span(inverse_mass_.first(), std::size_t(vertex_count_)));
    const bool limited = params.strain_limit > 0;
    springs_ = blocks_of(made, made.share, made.share_length);
    if (limited) limits_ = blocks_of(made, made.limit, made.limit_length);
    assert(!limited || limits_.runs == springs_.runs);
    masses_changed_ = false;
}

void CpuJacobi::refresh(const SimParams& params)
{
    const XpbdChanges changes = xpbd_changes(made_for_, params);
    if (changes.shares || masses_changed_ || spring_weights_differ(*made_for_, params)) refresh_springs(params);
    if (changes.times) last_is_known_ = false;
    forces_.refresh(params);
    tethers_.refresh(params);
    made_for_ = params;
    if (!last_is_known_)
        for (std::uint32_t v = 0; v < vertex_count_; ++v) forget_last(v);
    last_is_known_ = true;
}

void CpuJacobi::carry(Archive& archive, const SimParams& params)
{
    bool known = last_is_known_ && !xpbd_changes(made_for_, params).times;
    archive.value(known);
    if (archive.reads()) refresh(params);
    last_is_known_ = known;
    if (!known) return;
    const auto last = static_cast<std::size_t>(1 - current_);
    positions_[last].carry(archive);
    velocities_[last].carry(archive);
}

void CpuJacobi::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    refresh(input.params);
    bodies_.plan(input);
    run_substeps(input.substep_count, [&](int k, const Team& team) { run_substep(substep_at(input, k), k, team); });
}

CpuJacobi::Substep CpuJacobi::substep_at(const StepInput& input, int k)
{
    const SimParams& p = input.params;
    const int from = (current_ + k) % 2;
    const double time_s = input.start_time_s + k * double(substep_s(p));
    const StateLanes next = state(1 - from);
    return {.forces = forces_.terms(p, time_s, state(from)),
            .bodies = bodies_.contacts(k, p),
            .times = SubstepTimes(p),
            .common = common_acceleration(p, time_s),
            .springs = springs_,
            .limits = limits_,
            .limited = p.strain_limit > 0,
            .x = next.x,
            .v = next.v,
            .predicted = predicted_.lanes(),
            .passed = passed_.lanes(),
            .tethers = tethers_.lanes()};
}

void CpuJacobi::run_substep(const Substep& s, int k, const Team& team)
{
    const Range blocks = team.part(block_count());
    run_face_pass(s.forces, blocks, team);
    bodies_.place_pins(k, blocks, s.forces.x, s.forces.v);
    team.wait();
    predict_blocks(s, blocks);
    team.wait();
    for (int pass = 0; pass < jacobi_passes(*made_for_); ++pass) {
        const bool there = pass % 2 == 0;
        pass_over_blocks(s, there ? s.x : s.passed, there ? s.passed : s.x, blocks);
        team.wait();
    }
    finish_blocks(s, blocks);
    team.wait();
}

}  // namespace nuno
