// The forces of the seed paper, section 2.2, on one particle [N].

// Spring, eq. of 2.2.1: f = k (|d| - l0) d / |d|, d = x_j - x_i [m], written as (stiffness - tension / |d|) d with
// stiffness = k [N/m] and tension = k l0 [N], so that a linear stiffness can be added to the first. Zero for d = 0,
// where no direction exists.
SHARED_FN Vec3 spring_force(Vec3 d, Real stiffness, Real tension)
{
    PRECISE Real length = max_real(vector_length(d), Real(1e-12f));
    PRECISE Vec3 force = (stiffness - tension / length) * d;
    return force;
}

// Damper along a spring, stiffness-proportional (Rayleigh): f = c (n . u) n, c [kg/s], n = d / |d|, u = v_j - v_i.
SHARED_FN Vec3 spring_damping_force(Vec3 d, Vec3 u, Real c)
{
    PRECISE Real length_sq = max_real(dot_product(d, d), Real(1e-24f));
    PRECISE Vec3 force = (c * dot_product(d, u) / length_sq) * d;
    return force;
}

// Gravity, 2.2.2: f = m g.
SHARED_FN Vec3 gravity_force(Real mass, Vec3 gravity)
{
    PRECISE Vec3 force = mass * gravity;
    return force;
}

// Damper, 2.2.3: f = -rho v, rho [kg/s].
SHARED_FN Vec3 damping_force(Real rho, Vec3 velocity)
{
    PRECISE Vec3 force = -rho * velocity;
    return force;
}

// Acceleration [m/s2], eq. of 2.2 and 2.3: a = (gravity + damper + springs + wind) / m, the wind a force along z [N].
// An inverse mass of 0 (pinned) gives 0.
SHARED_FN Vec3 acceleration(Real inverse_mass, Real mass, Vec3 gravity, Real rho, Vec3 velocity, Vec3 springs,
                            Real wind)
{
    PRECISE Vec3 force =
        gravity_force(mass, gravity) + damping_force(rho, velocity) + springs + Vec3(Real(0.0f), Real(0.0f), wind);
    PRECISE Vec3 a = inverse_mass * force;
    return a;
}
