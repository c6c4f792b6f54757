// XPBD in compute shaders.
#include "solver/xpbd/gpu_xpbd.h"

#include <algorithm>

#include "core/error.h"
#include "gl/barriers.h"
#include "gl/context.h"
#include "model/formulas.h"
#include "shaders/shared/bindings.h"
#include "solver/xpbd/xpbd_part.h"

namespace nuno {
namespace {

glm::vec3 gravity_of(const SimParams& p) { return {p.gravity_x, p.gravity_y, p.gravity_z}; }

// Left to nuno, colours are taken wherever they can be: measured on software they are as fast as all springs at once,
// or twice as fast (bench/position_bench.cpp). But a hardware device waits for each of some 26 dispatches a substep,
// where gathering takes 8; so there, between what fits into one work group and what fills the device, all springs are
// taken at once, which is reasoned, not measured (docs/limits.md).
constexpr std::uint32_t kLeastForJacobi = 1025, kMostForJacobi = 16384;

bool all_at_once(const SimParams& p, std::uint32_t vertex_count)
{
    if (p.sweep != Sweep::automatic) return p.sweep == Sweep::jacobi;
    return !gl_info().software && !bends(p) && vertex_count >= kLeastForJacobi && vertex_count <= kMostForJacobi;
}

}  // namespace

GpuXpbd::GpuXpbd(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model),
      model_(model),
      forces_(model),
      bodies_(bodies, model),
      tethers_(model),
      inverse_masses_(model.vertex_count()),
      predicted_(vertex_count_),
      given_(vertex_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_DRAW),
      forget_(compute_program("sim/xpbd_forget.comp"))
{
    refresh(params);
}

void GpuXpbd::upload(const ClothState& state)
{
    GpuSolver::upload(state);
    for (std::uint32_t v = 0; v < vertex_count_; ++v) {
        inverse_masses_[v] = state.positions[v].w;
        tethers_.set_held(v, state.positions[v].w == 0);
    }
    masses_changed_ = true;
    last_is_known_ = false;
}

void GpuXpbd::upload_velocities(std::span<const glm::vec4> velocities)
{
    if (!last_is_known_) return GpuSolver::upload_velocities(velocities);
    barrier_compute_to_upload();
    given_.update(0, std::as_bytes(velocities));
    forget_last(false);
}

void GpuXpbd::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    GpuSolver::set_vertex(vertex, position);
    masses_changed_ = masses_changed_ || inverse_masses_[vertex] != position.w;
    inverse_masses_[vertex] = position.w;
    tethers_.set_held(vertex, position.w == 0);
    if (!last_is_known_) return;
    const formulas::Motion last = formulas::assumed_last(formulas::motion(glm::vec3(position), glm::vec3(0)),
                                                         gravity_of(*made_for_), substep_s(*made_for_));
    const glm::vec4 x(last.position, 0), v(last.velocity, 0);
    positions_[1 - current_].buffer.update(vertex * sizeof x, std::as_bytes(std::span(&x, 1)));
    velocities_[1 - current_].buffer.update(vertex * sizeof v, std::as_bytes(std::span(&v, 1)));
}

void GpuXpbd::compile()
{
    std::vector<Define> defines = forces_.defines();
    for (const Define& count : bodies_.defines()) defines.push_back(count);
    defines.push_back({"TETHERED", tethers_.any() ? "1" : "0"});
    const std::vector<GeneratedInclude> params{{"generated/sim_params", glsl_fields(sim_param_table())}};
    predict_ = compute_program("sim/xpbd_predict.comp", defines, params);
    finish_ = compute_program("sim/xpbd_finish.comp", defines, params);
}

void GpuXpbd::refresh_springs(const SimParams& params)
{
    const SimParams* const before = made_for_ ? &*made_for_ : nullptr;
    const auto differs = [&](auto member) { return !before || before->*member != params.*member; };
    const bool limit_comes = before && (before->strain_limit > 0) != (params.strain_limit > 0);
    const bool jacobi = all_at_once(params, vertex_count_), switches = !before || jacobi != gather_.has_value();
    if (switches) {
        gather_.reset();
        constraints_.reset();
        if (jacobi)
            gather_.emplace(vertex_count_);
        else
            constraints_.emplace(model_);
    }
    const bool others = switches || limit_comes || spring_weights_differ(*before, params);
    const bool times = differs(&SimParams::substeps) || differs(&SimParams::frame_rate);
    if (others || times || masses_changed_ || differs(&SimParams::iterations) || differs(&SimParams::strain_limit)) {
        if (gather_)
            gather_->upload(make_jacobi_springs(model_, params, inverse_masses_));
        else
            refresh_constraints(params, others);
    }
    masses_changed_ = false;
    if (times) last_is_known_ = false;
}

// `others`: other constraints than before, not only other numbers.
void GpuXpbd::refresh_constraints(const SimParams& params, bool others)
{
    const GpuConstraints::Numbers numbers{SubstepTimes(params).step, 2 * std::max(params.iterations, 1),
                                          params.strain_limit};
    if (others)
        constraints_->choose(spring_weights(model_, params), numbers, inverse_masses_);
    else
        constraints_->set_numbers(numbers, inverse_masses_);
}

void GpuXpbd::refresh(const SimParams& params)
{
    refresh_springs(params);
    const bool first = !made_for_, tethered = tethers_.any();
    const bool new_forces = forces_.refresh(params);
    if (tethers_.refresh(params) && tethers_.any()) gpu_tethers_.upload(tethers_.tethers());
    made_for_ = params;
    if (first || new_forces || tethers_.any() != tethered) compile();
    const SubstepTimes times(params);
    for (const Program* program : {&predict_, &finish_, &forget_}) {
        program->set(LOCATION_SUBSTEP, times.h);
        program->set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    }
    predict_.set(LOCATION_STEP, times.step);
    predict_.set(LOCATION_KEEP, times.keep);
    finish_.set(LOCATION_PER_STEP, times.per_step);
    forget_.set(LOCATION_KEEP, gravity_of(params));
}

void GpuXpbd::forget_last(bool all)
{
    barrier_compute_to_compute();
    positions_[current_].texture.bind(UNIT_POSITIONS);
    velocities_[current_].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
    given_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_GIVEN_VELOCITIES);
    positions_[1 - current_].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_LAST_POSITIONS);
    velocities_[1 - current_].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_LAST_VELOCITIES);
    forget_.use();
    forget_.set(LOCATION_ALL, std::int32_t(all));
    dispatch();
    barrier_compute_to_compute();
}

void GpuXpbd::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    refresh(input.params);
    bind_params(input.params);
    bodies_.plan(input);
    barrier_draw_to_compute();
    if (!last_is_known_) forget_last(true);
    last_is_known_ = true;
    for (int k = 0; k < input.substep_count; ++k) run_substep(input, k);
}

void GpuXpbd::run_substep(const StepInput& input, int k)
{
    const SimParams& p = input.params;
    const int from = current_, to = 1 - current_;
    const double time_s = input.start_time_s + k * double(substep_s(p));
    const glm::vec3 common(p.gravity_x, p.gravity_y, p.gravity_z + wind_pressure(p, time_s) / p.areal_density);
    forces_.bind();
    bind_state(from, to);
    forces_.run_face_pass(time_s);
    if (bodies_.moves_pins()) {
        bind_state(to, from);
        bodies_.place_pins(k);
        barrier_compute_to_compute();
        bind_state(from, to);
    }
    predicted_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_XPBD_PREDICTED);
    if (tethers_.any()) gpu_tethers_.bind();
    predict_.use();
    predict_.set(LOCATION_COMMON, common);
    bodies_.set_substep(predict_, k);
    dispatch();
    barrier_compute_to_compute();

    positions_[to].texture.bind(UNIT_POSITIONS);
    if (gather_)
        gather_->run(jacobi_passes(p), positions_[to]);
    else
        constraints_->sweep(std::max(p.iterations, 1));

    bind_state(from, to);
    predicted_.texture.bind(UNIT_PREDICTED);
    positions_[from].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_LAST_POSITIONS);
    velocities_[from].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_LAST_VELOCITIES);
    finish_.use();
    finish_.set(LOCATION_COMMON, common);
    bodies_.set_substep(finish_, k);
    dispatch();
    barrier_compute_to_compute();
    current_ = to;
}

}  // namespace nuno
