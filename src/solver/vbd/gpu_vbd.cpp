// Vertex block descent in compute shaders.
#include "solver/vbd/gpu_vbd.h"

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"

namespace nuno {
namespace {

// Kept small, so that a colour of a small sheet is not all filling up.
constexpr std::uint32_t kGrain = 8;

}  // namespace

GpuVbd::GpuVbd(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model),
      model_(model),
      forces_(model, kVbdSprings),
      bodies_(bodies, model),
      tethers_(model),
      order_(GL_R32I),
      moves_(vertex_count_),
      targets_(vertex_count_)
{
    const VertexColours colours = colour_vertices(model, kGrain);
    first_place_ = colours.first_place;
    order_.upload(colours.vertices);
    refresh(params);
}

void GpuVbd::upload(const ClothState& state)
{
    GpuSolver::upload(state);
    tethers_.pins().upload(state);
}

void GpuVbd::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    GpuSolver::set_vertex(vertex, position);
    tethers_.pins().set_vertex(vertex, position);
}

void GpuVbd::compile()
{
    const std::vector<Define> own{{"LIMITED", made_for_->strain_limit > 0 ? "1" : "0"}};
    predict_ = gpu_program("sim/vbd_predict.comp", {forces_.defines(), tethers_.defines()});
    descend_ = gpu_program("sim/vbd_descend.comp", {forces_.defines(), own});
    finish_ = gpu_program("sim/vbd_finish.comp", {forces_.defines(), bodies_.defines()});
}

void GpuVbd::refresh(const SimParams& params)
{
    const bool first = !made_for_, changed = first || !same_params(*made_for_, params);
    const bool limited = !first && made_for_->strain_limit > 0;
    const bool new_forces = forces_.refresh(params), new_tethers = tethers_.refresh(params);
    made_for_ = params;
    if (changed) terms_ = vbd_terms(model_, params);
    const bool compiles = first || new_forces || new_tethers || (params.strain_limit > 0) != limited;
    if (compiles) compile();
    if (compiles || changed) set_uniforms();
}

void GpuVbd::set_uniforms()
{
    for (const Program* program : {&predict_, &descend_, &finish_}) {
        program->set(LOCATION_SUBSTEP, terms_.h);
        program->set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
    }
    descend_.set(LOCATION_LONGEST, terms_.longest);
    descend_.set(LOCATION_STIFFER, terms_.stiffer);
    descend_.set(LOCATION_DAMPER, terms_.damper);
    finish_.set(LOCATION_INVERSE_SUBSTEP, terms_.inverse_h);
}

void GpuVbd::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    refresh(input.params);
    bind_params(input.params);
    bodies_.plan(input);
    barrier_draw_to_compute();
    for (int k = 0; k < input.substep_count; ++k) run_substep(input, k);
}

void GpuVbd::run_substep(const StepInput& input, int k)
{
    const int from = current_, to = 1 - current_;
    const double time_s = input.start_time_s + k * double(terms_.h);
    forces_.bind();
    if (bodies_.moves_pins()) {
        bind_state(to, from);
        bodies_.place_pins(k);
        barrier_compute_to_compute();
    }
    bind_state(from, to);
    forces_.run_face_pass(time_s);
    moves_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_MOVES);
    targets_.buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_TARGETS);
    tethers_.bind();
    predict_.use();
    predict_.set(LOCATION_WIND, wind_pressure(input.params, time_s));
    dispatch();
    barrier_compute_to_compute();
    moves_.texture.bind(UNIT_MOVES);
    targets_.texture.bind(UNIT_TARGETS);
    positions_[to].texture.bind(UNIT_POSITIONS);
    sweep();
    bind_state(from, to);
    bodies_.set_substep(finish_, k);
    finish_.use();
    dispatch();
    barrier_compute_to_compute();
    current_ = to;
}

// The order of CpuVbd::run_substep.
void GpuVbd::sweep()
{
    order_.bind(UNIT_ORDER);
    descend_.use();
    const int last = static_cast<int>(first_place_.size()) - 2;
    for (int iteration = 0; iteration < terms_.iterations; ++iteration)
        for (int turn = iteration == 0 ? 0 : 1; turn <= 2 * last; ++turn) {
            const auto colour = static_cast<std::size_t>(turn <= last ? turn : 2 * last - turn);
            const std::uint32_t first = first_place_[colour], end = first_place_[colour + 1];
            descend_.set(LOCATION_FIRST_PLACE, static_cast<std::int32_t>(first));
            descend_.set(LOCATION_END_PLACE, static_cast<std::int32_t>(end));
            glDispatchCompute((end - first + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1);
            barrier_compute_to_compute();
        }
}

}  // namespace nuno
