// Contact of one particle with a fixed rigid body. `gap` is the signed distance [m] to the surface less the distance
// that the cloth keeps from it, `normal` the unit outward normal, `friction` the Coulomb coefficient.

// Where gap < 0 the particle is put back on the surface, keeps no velocity into it, and loses at most friction times
// the lost normal velocity of its tangential one. Where gap >= 0 nothing changes.
SHARED_FN Motion push_out(Motion m, Vec3 normal, Real gap, Real friction)
{
    PRECISE Real depth = max_real(-gap, Real(0.0f));
    PRECISE Vec3 position = m.position + depth * normal;
    PRECISE Real inward = max_real(-dot_product(m.velocity, normal), Real(0.0f));
    PRECISE Vec3 tangential = m.velocity + inward * normal;
    PRECISE Real speed = max_real(vector_length(tangential), Real(1e-12f));
    PRECISE Real kept = max_real(Real(1.0f) - friction * inward / speed, Real(0.0f));
    PRECISE Vec3 velocity = kept * tangential;
    return motion(position, select_positive(depth, velocity, m.velocity));
}

// Half-space n . x >= offset.
SHARED_FN Motion push_out_of_plane(Motion m, Vec3 normal, Real offset, Real distance, Real friction)
{
    PRECISE Real gap = dot_product(m.position, normal) - offset - distance;
    return push_out(m, normal, gap, friction);
}

// Ball. A particle at its very centre leaves along +y.
SHARED_FN Motion push_out_of_sphere(Motion m, Vec3 centre, Real radius, Real distance, Real friction)
{
    PRECISE Vec3 d = m.position - centre;
    PRECISE Real length = vector_length(d);
    PRECISE Vec3 normal =
        select_positive(length, d / max_real(length, Real(1e-12f)), Vec3(Real(0.0f), Real(1.0f), Real(0.0f)));
    return push_out(m, normal, length - radius - distance, friction);
}
