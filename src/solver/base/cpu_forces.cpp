// The springs and faces of a model for the parameters of the moment.
#include "solver/base/cpu_forces.h"

namespace nuno {

void CpuForces::refresh(const SimParams& params)
{
    if (rule_.weights && (!made_for_ || rule_.differ(*made_for_, params)))
        springs_ = make_spring_blocks(spring_entries(model_, rule_.weights(model_, params)));
    const FaceForces wanted = face_forces(params);
    if (wanted.membrane) membrane_constants(params);
    if (wanted.any() && !faces_) faces_.emplace(model_);
    made_for_ = params;
}

ForceTerms CpuForces::terms(const SimParams& p, double time_s, const StateLanes& state) const
{
    ForceTerms f{.springs = springs_,
                 .x = state.x,
                 .v = state.v,
                 .inverse_mass = state.inverse_mass,
                 .area = state.area,
                 .gravity = {p.gravity_x, p.gravity_y, p.gravity_z},
                 .damping = p.damping,
                 .areal_density = p.areal_density,
                 .stiffness_damping = p.stiffness_damping,
                 .wind = wind_pressure(p, time_s)};
    const FaceForces wanted = face_forces(p);
    if (!wanted.any()) return f;
    f.faces = &*faces_;
    f.face_inputs = {.wanted = wanted, .air = air_of(p), .x = state.x, .v = state.v};
    if (wanted.membrane) f.face_inputs.membrane = membrane_constants(p);
    if (wanted.air) f.face_inputs.field = air_field(p, time_s);
    return f;
}

void run_face_pass(const ForceTerms& f, Range blocks, const Team& team)
{
    if (!f.faces) return;
    f.faces->run(f.face_inputs, blocks);
    team.wait();
}

}  // namespace nuno
