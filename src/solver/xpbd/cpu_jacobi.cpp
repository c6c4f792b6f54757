// XPBD on CPU threads with all springs at once.
#include "solver/xpbd/cpu_jacobi.h"

#include <cassert>
#include <utility>

namespace nuno {

// The state one substep ago is what the lanes of the new state hold before (src/solver/xpbd/mesh_motion.cpp says the same of
// positions in another order).
struct CpuJacobi::Substep
{
    ForceTerms forces;  // at the start, where x and v are read
    BodyContacts bodies;
    SubstepTimes times;
    glm::vec3 common;  // [m/s2]
    int passes;
    const SpringBlocks &springs, &limits;
    bool limited;
    Lanes3 x, v, predicted, passed;
    const std::uint32_t* anchors;  // null: no tethers
    const float* tether_lengths;
    std::int32_t vertex_count;
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
        WideVec3 to = select_positive(inverse_mass, m.position, x);
        store(s.v, i, select_positive(inverse_mass, m.velocity, v));
        store(s.predicted, i, to);
        if (s.anchors)
            for (int k = 0; k < kTethersPerVertex; ++k) {
                const std::int32_t entry = k * s.vertex_count + i;
                to = Formulas::tethered(to, gather(s.forces.x, s.anchors + entry), WideFloat(s.tether_lengths + entry));
            }
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
            const Run run = s.springs.runs[slot];
            const bool gathers = run == SpringBlocks::kGather;
            const WideVec3 d = (gathers ? gather(from, &s.springs.neighbours[slot * kLanes]) : load(from, run)) - x;
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
            const WideVec3 last_x = load(s.forces.x, i), last_v = load(s.forces.v, i);
            m = push_out_of_bodies<kLanes>(s.bodies, last_x, m).motion;
            const WideVec3 lost = m.velocity - end;
            const WideFloat touched = Formulas::dot_product(lost, lost);
            const Formulas::Motion last = Formulas::assumed_last(m, acceleration(s, block), WideFloat(s.times.h));
            store(s.forces.x, i, select_positive(touched, last.position, last_x));
            store(s.forces.v, i, select_positive(touched, last.velocity, last_v));
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
      forces_(model),
      bodies_(bodies, model),
      tethers_(model),
      predicted_(vertex_count_),
      passed_(vertex_count_)
{
}

void CpuJacobi::upload(const ClothState& state)
{
    CpuSolver::upload(state);
    for (std::uint32_t v = 0; v < vertex_count_; ++v) tethers_.set_held(v, state.positions[v].w == 0);
    masses_changed_ = true;
    last_is_known_ = false;
}

void CpuJacobi::forget_last(std::uint32_t vertex)
{
    const SimParams& p = *made_for_;
    const glm::vec3 x(positions_[current_].at(vertex, 0)), v(velocities_[current_].at(vertex, 0));
    const formulas::Motion last =
        formulas::assumed_last(formulas::motion(x, v), {p.gravity_x, p.gravity_y, p.gravity_z}, substep_s(p));
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
    tethers_.set_held(vertex, position.w == 0);
    if (last_is_known_) forget_last(vertex);
}

void CpuJacobi::place_tethers()
{
    const std::vector<Tether>& tethers = tethers_.tethers();
    anchors_.assign(tethers.size() + kLanes, 0);  // a block may read past the last
    tether_lengths_.assign(anchors_.size(), Tether{}.length);
    for (std::size_t i = 0; i < tethers.size(); ++i) {
        const bool none = tethers[i].anchor == Tether::kNone;
        anchors_[i] = none ? static_cast<std::uint32_t>(i % vertex_count_) : tethers[i].anchor;
        tether_lengths_[i] = tethers[i].length;
    }
}

void CpuJacobi::refresh_springs(const SimParams& params)
{
    const SimParams* const before = made_for_ ? &*made_for_ : nullptr;
    const auto differs = [&](auto member) { return before->*member != params.*member; };
    if (before && !masses_changed_ && !spring_weights_differ(*before, params) && !differs(&SimParams::substeps) &&
        !differs(&SimParams::frame_rate) && !differs(&SimParams::iterations) && !differs(&SimParams::strain_limit))
        return;
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
    refresh_springs(params);
    forces_.refresh(params);
    if (tethers_.refresh(params)) place_tethers();
    if (made_for_ && (made_for_->substeps != params.substeps || made_for_->frame_rate != params.frame_rate))
        last_is_known_ = false;
    made_for_ = params;
    if (!last_is_known_)
        for (std::uint32_t v = 0; v < vertex_count_; ++v) forget_last(v);
    last_is_known_ = true;
}

void CpuJacobi::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    refresh(input.params);
    bodies_.plan(input);
    run_blocks([&](Range blocks, SpinBarrier* barrier) {
        for (int k = 0; k < input.substep_count; ++k) run_substep(substep_at(input, k), k, blocks, barrier);
    });
    current_ = (current_ + input.substep_count) % 2;
}

CpuJacobi::Substep CpuJacobi::substep_at(const StepInput& input, int k)
{
    const SimParams& p = input.params;
    const int from = (current_ + k) % 2, to = 1 - from;
    const double time_s = input.start_time_s + k * double(substep_s(p));
    Substep s{.forces = forces_.terms(p, time_s),
              .bodies = bodies_.contacts(k, p),
              .times = SubstepTimes(p),
              .common = {p.gravity_x, p.gravity_y, p.gravity_z + wind_pressure(p, time_s) / p.areal_density},
              .passes = jacobi_passes(p),
              .springs = springs_,
              .limits = limits_,
              .limited = p.strain_limit > 0,
              .x = positions_[to].lanes(),
              .v = velocities_[to].lanes(),
              .predicted = predicted_.lanes(),
              .passed = passed_.lanes(),
              .anchors = tethers_.any() ? anchors_.data() : nullptr,
              .tether_lengths = tether_lengths_.data(),
              .vertex_count = static_cast<std::int32_t>(vertex_count_)};
    s.forces.x = positions_[from].lanes();
    s.forces.v = velocities_[from].lanes();
    s.forces.inverse_mass = inverse_mass_.first();
    s.forces.area = area_.first();
    return s;
}

void CpuJacobi::run_substep(const Substep& s, int k, Range blocks, SpinBarrier* barrier)
{
    const auto wait = [&] {
        if (barrier) barrier->arrive_and_wait();
    };
    run_face_pass(s.forces, blocks, barrier);
    bodies_.place_pins(k, blocks, s.forces.x, s.forces.v);
    wait();
    predict_blocks(s, blocks);
    wait();
    for (int pass = 0; pass < s.passes; ++pass) {
        const bool there = pass % 2 == 0;
        pass_over_blocks(s, there ? s.x : s.passed, there ? s.passed : s.x, blocks);
        wait();
    }
    finish_blocks(s, blocks);
    wait();
}

}  // namespace nuno
