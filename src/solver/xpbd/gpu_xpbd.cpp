// XPBD in compute shaders.
#include "solver/xpbd/gpu_xpbd.h"

#include <algorithm>

#include "gl/barriers.h"
#include "gl/context.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {
namespace {

// Left to nuno, colours are taken wherever they can be: measured on software they are as fast as all springs at once,
// or several times as fast (bench/position_bench.cpp). But a hardware device waits for each dispatch: 13 a substep for
// grids, whose colours go by fours (spring_quads.h), some 26 for other meshes, where gathering takes 8. So there, for
// meshes between what fits into one work group and what fills the device, all springs are taken at once, which is
// reasoned, not measured (docs/limits.md).
constexpr std::uint32_t kMostForJacobi = 16384;

bool all_at_once(const SimParams& p, const ClothModel& model)
{
    if (p.sweep != Sweep::automatic) return p.sweep == Sweep::jacobi;
    const bool grids =
        std::all_of(model.sheets.begin(), model.sheets.end(), [](const Sheet& sheet) { return sheet.is_grid(); });
    return !gl_info().software && !bends(p) && !grids && model.vertex_count() > GpuSprings::kSmallVertices &&
           model.vertex_count() <= kMostForJacobi;
}

}  // namespace

GpuXpbd::GpuXpbd(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model),
      model_(model),
      forces_(model, kNoSprings),
      bodies_(bodies, model),
      tethers_(model),
      inverse_masses_(model.vertex_count()),
      predicted_(vertex_count_),
      given_(vertex_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_DRAW),
      forget_(compute_program("sim/xpbd_forget.comp"))
{
    if (vertex_count_ <= GpuSprings::kSmallVertices) one_group_.emplace(vertex_count_);
    refresh(params);
}

void GpuXpbd::upload(const ClothState& state)
{
    GpuSolver::upload(state);
    tethers_.pins().upload(state);
    for (std::uint32_t v = 0; v < vertex_count_; ++v) inverse_masses_[v] = state.positions[v].w;
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
    tethers_.pins().set_vertex(vertex, position);
    if (!last_is_known_) return;
    const formulas::Motion last = assumed_past(*made_for_, glm::vec3(position), glm::vec3(0));
    const glm::vec4 x(last.position, 0), v(last.velocity, 0);
    positions_[1 - current_].buffer.update(vertex * sizeof x, std::as_bytes(std::span(&x, 1)));
    velocities_[1 - current_].buffer.update(vertex * sizeof v, std::as_bytes(std::span(&v, 1)));
}

void GpuXpbd::compile(bool new_motion, bool new_springs)
{
    std::vector<Define> motion = forces_.defines();
    for (const std::vector<Define>& more : {bodies_.defines(), tethers_.defines()})
        motion.insert(motion.end(), more.begin(), more.end());
    if (new_motion) {
        predict_ = gpu_program("sim/xpbd_predict.comp", {motion});
        finish_ = gpu_program("sim/xpbd_finish.comp", {motion});
    }
    if ((new_motion || new_springs) && constraints_ && constraints_->fit_one_group())
        one_group_->compile(constraints_->springs(), motion);
}

bool GpuXpbd::refresh_springs(const SimParams& params)
{
    const XpbdChanges changes = xpbd_changes(made_for_, params);
    const bool jacobi = all_at_once(params, model_), switches = !made_for_ || jacobi != gather_.has_value();
    if (switches) {
        gather_.reset();
        constraints_.reset();
        if (jacobi)
            gather_.emplace(vertex_count_);
        else
            constraints_.emplace(model_);
    }
    const bool others = switches || (made_for_->strain_limit > 0) != (params.strain_limit > 0) ||
                        spring_weights_differ(*made_for_, params);
    if (others || changes.shares || masses_changed_) {
        if (gather_)
            gather_->upload(make_jacobi_springs(model_, params, inverse_masses_));
        else
            refresh_constraints(params, others);
    }
    masses_changed_ = false;
    if (changes.times) last_is_known_ = false;
    return others;
}

// `others`: other constraints than before, not only other numbers.
void GpuXpbd::refresh_constraints(const SimParams& params, bool others)
{
    const GpuConstraints::Numbers numbers{SubstepTimes(params).step, 2 * sweep_pairs(params), params.strain_limit};
    if (others)
        constraints_->choose(spring_weights(model_, params), numbers, inverse_masses_);
    else
        constraints_->set_numbers(numbers, inverse_masses_);
}

void GpuXpbd::refresh(const SimParams& params)
{
    const bool new_springs = refresh_springs(params);
    const bool new_forces = forces_.refresh(params), new_tethers = tethers_.refresh(params);
    compile(!made_for_ || new_forces || new_tethers, new_springs);
    made_for_ = params;
    const SubstepTimes times(params);
    for (const Program* program : {&predict_, &finish_, &forget_}) {
        program->set(LOCATION_SUBSTEP, times.h);
        program->set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    }
    predict_.set(LOCATION_STEP, times.step);
    predict_.set(LOCATION_KEEP, times.keep);
    finish_.set(LOCATION_PER_STEP, times.per_step);
    forget_.set(LOCATION_GRAVITY, glm::vec3(params.gravity_x, params.gravity_y, params.gravity_z));
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

void GpuXpbd::carry(Archive& archive, const SimParams& params)
{
    bool known = last_is_known_ && !xpbd_changes(made_for_, params).times;
    archive.value(known);
    if (archive.reads()) refresh(params);
    last_is_known_ = known;
    if (!known) return;
    carry_buffer(archive, positions_[1 - current_].buffer);
    carry_buffer(archive, velocities_[1 - current_].buffer);
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
    if (is_small(input.params)) return run_small(input);
    for (int k = 0; k < input.substep_count; ++k) run_substep(input, k);
}

GpuOneGroup::Work GpuXpbd::small_work(const SimParams& params) const
{
    return {constraints_->springs(), bodies_, sweep_pairs(params), SubstepTimes(params)};
}

bool GpuXpbd::is_small(const SimParams& params) const
{
    return constraints_ && constraints_->fit_one_group() && !forces_.on_faces() && !bodies_.moves_pins() &&
           one_group_->does(small_work(params));
}

void GpuXpbd::run_small(const StepInput& input)
{
    const double h = double(substep_s(input.params));
    std::vector<glm::vec4> commons;
    for (int k = 0; k < input.substep_count; ++k)
        commons.emplace_back(common_acceleration(input.params, input.start_time_s + k * h), 0);
    tethers_.bind();
    one_group_->run({positions_, velocities_, current_}, small_work(input.params), commons);
    current_ = (current_ + input.substep_count) % 2;
}

void GpuXpbd::project_springs(const SimParams& params, int to) const
{
    positions_[to].texture.bind(UNIT_POSITIONS);
    if (gather_)
        gather_->run(jacobi_passes(params), positions_[to]);
    else if (constraints_->fit_one_group())
        one_group_->sweep(constraints_->springs(), sweep_pairs(params), positions_[to]);
    else
        constraints_->sweep(sweep_pairs(params));
}

void GpuXpbd::run_substep(const StepInput& input, int k)
{
    const SimParams& p = input.params;
    const int from = current_, to = 1 - current_;
    const double time_s = input.start_time_s + k * double(substep_s(p));
    const glm::vec3 common = common_acceleration(p, time_s);
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
    tethers_.bind();
    predict_.use();
    predict_.set(LOCATION_COMMON, common);
    bodies_.set_substep(predict_, k);
    dispatch();
    barrier_compute_to_compute();

    project_springs(p, to);

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
