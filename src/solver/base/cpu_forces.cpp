// The springs and faces of a model for the parameters of the moment.
#include "solver/base/cpu_forces.h"

namespace nuno {

void CpuForces::refresh(const SimParams& params)
{
    if (!made_for_ || rule_.differ(*made_for_, params))
        springs_ = make_spring_blocks(spring_entries(model_, rule_.weights(model_, params)));
    const FaceForces wanted = face_forces(params);
    if (wanted.membrane) membrane_constants(params);
    if (wanted.any() && !faces_) faces_.emplace(model_);
    made_for_ = params;
}

ForceTerms CpuForces::terms(const SimParams& p) const
{
    return {.springs = springs_,
            .x = {},
            .v = {},
            .inverse_mass = nullptr,
            .area = nullptr,
            .gravity = {p.gravity_x, p.gravity_y, p.gravity_z},
            .damping = p.damping,
            .areal_density = p.areal_density,
            .stiffness_damping = p.stiffness_damping,
            .wind = 0};
}

ForceTerms CpuForces::terms(const SimParams& p, double time_s) const
{
    ForceTerms f = terms(p);
    const FaceForces wanted = face_forces(p);
    if (wanted.any()) {
        f.faces = &*faces_;
        f.face_inputs.wanted = wanted;
        if (wanted.membrane) f.face_inputs.membrane = membrane_constants(p);
        f.face_inputs.air = air_of(p);
    }
    f.set_time(p, time_s);
    return f;
}

void ForceTerms::set_time(const SimParams& p, double time_s)
{
    wind = wind_pressure(p, time_s);
    if (face_inputs.wanted.air) face_inputs.field = air_field(p, time_s);
}

void run_face_pass(const ForceTerms& f, Range blocks, SpinBarrier* barrier)
{
    if (!f.faces) return;
    FaceInputs in = f.face_inputs;
    in.x = f.x;
    in.v = f.v;
    f.faces->run(in, blocks);
    if (barrier) barrier->arrive_and_wait();
}

}  // namespace nuno
