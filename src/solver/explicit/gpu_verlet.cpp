// Velocity Verlet in a compute shader.
#include "solver/explicit/gpu_verlet.h"

#include "gl/barriers.h"
#include "shaders/shared/bindings.h"
#include "solver/base/gpu_program.h"

namespace nuno {

GpuVerlet::GpuVerlet(const ClothModel& model, const Bodies& bodies, const SimParams& params)
    : GpuSolver(model),
      forces_(model),
      bodies_(bodies, model),
      predicted_{VertexBuffer(vertex_count_), VertexBuffer(vertex_count_)},
      accelerations_(vertex_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY)
{
    forces_.refresh(params);
    compile();
}

void GpuVerlet::compile()
{
    const auto variant = [&](const char* kicks, const char* drifts) {
        Program program = gpu_program("sim/verlet.comp",
                                      {forces_.defines(), bodies_.defines(), {{"KICKS", kicks}, {"DRIFTS", drifts}}});
        program.set(LOCATION_VERTEX_COUNT, static_cast<std::int32_t>(vertex_count_));
        return program;
    };
    kick_ = variant("1", "0");
    drift_ = variant("0", "1");
    kick_and_drift_ = variant("1", "1");
}

void GpuVerlet::upload(const ClothState& state)
{
    GpuSolver::upload(state);
    accelerations_for_.reset();
}

void GpuVerlet::upload_velocities(std::span<const glm::vec4> velocities)
{
    GpuSolver::upload_velocities(velocities);
    accelerations_for_.reset();
}

void GpuVerlet::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    GpuSolver::set_vertex(vertex, position);
    accelerations_for_.reset();
}

void GpuVerlet::carry(Archive& archive, const SimParams& params)
{
    bool known = accelerations_for_ && same_params(*accelerations_for_, params);
    archive.value(known);
    accelerations_for_ = known ? std::optional(params) : std::nullopt;
    if (known) carry_buffer(archive, accelerations_);
}

void GpuVerlet::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    if (forces_.refresh(input.params)) compile();
    bind_params(input.params);
    forces_.bind();
    bodies_.plan(input);
    accelerations_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_ACCELERATIONS);
    barrier_draw_to_compute();
    if (accelerations_for_ && !same_params(*accelerations_for_, input.params)) accelerations_for_.reset();
    if (!accelerations_for_) find_accelerations(input);
    for (int k = 0; k <= input.substep_count; ++k) pass(input, k);
    accelerations_for_ = input.params;
}

void GpuVerlet::run(const Program& program, const StepInput& input, double time_s)
{
    program.set(LOCATION_SUBSTEP, substep_s(input.params));
    program.set(LOCATION_WIND, wind_pressure(input.params, time_s));
    program.use();
    dispatch();
    barrier_compute_to_compute();
}

// At the velocities themselves, which a kick of no length leaves as they are.
void GpuVerlet::find_accelerations(const StepInput& input)
{
    const int other = 1 - current_;
    positions_[current_].texture.bind(UNIT_POSITIONS);
    velocities_[current_].texture.bind(UNIT_VELOCITIES);
    velocities_[current_].texture.bind(UNIT_START_VELOCITIES);
    velocities_[other].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
    forces_.run_face_pass(input.start_time_s);
    kick_.set(LOCATION_KICK, 0.0f);
    run(kick_, input, input.start_time_s);
}

void GpuVerlet::pass(const StepInput& input, int substep)
{
    const bool kicks = substep > 0, drifts = substep < input.substep_count;
    const int from = current_, to = 1 - from;
    const float h = substep_s(input.params);
    const double time_s = input.start_time_s + substep * double(h);
    positions_[from].texture.bind(UNIT_POSITIONS);
    predicted_[from].texture.bind(UNIT_VELOCITIES);
    velocities_[from].texture.bind(UNIT_START_VELOCITIES);
    if (kicks) forces_.run_face_pass(time_s);
    positions_[to].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_POSITIONS);
    velocities_[drifts ? to : from].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
    predicted_[to].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_PREDICTED);
    const Program& program = !drifts ? kick_ : kicks ? kick_and_drift_ : drift_;
    program.set(LOCATION_KICK, 0.5f * h);
    if (drifts) bodies_.set_substep(program, substep);
    run(program, input, time_s);
    if (!drifts) return;
    if (bodies_.moves_pins()) {
        bodies_.place_pins(substep);
        barrier_compute_to_compute();
        predicted_[to].buffer.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_VELOCITIES);
        bodies_.place_pins(substep);
        barrier_compute_to_compute();
    }
    current_ = to;
}

}  // namespace nuno
