// Contact of one particle with a rigid body, with Coulomb friction.

// What contact leaves of a particle.
struct Contact
{
    Motion motion;
    Real sticks;  // 1 where static friction holds the particle to a body, else 0
};

SHARED_FN Contact free_of_contact(Motion m)
{
    Contact c;
    c.motion = m;
    c.sticks = Real(0.0f);
    return c;
}

// Nearer than this [m] counts as contact: a particle at rest must not leave it by rounding.
#define CONTACT_SKIN 1e-6f

// Coulomb coefficients: `kinetic` while sliding; `resting`, no less, is what a particle that sticks can bear.
struct Friction
{
    Real kinetic, resting;
};

// A particle that was at `x_start` [m] before a substep h [s] and has the motion `m` after it, where `s` is the surface
// less the distance that the cloth keeps, and `body_velocity` [m/s] that of the body at x_start, its way over h.
// Its velocity relative to the body is split into the part into the body, which is lost, and the rest, `across`:
//     |across| loses at most kinetic times what was lost; all of it where |across| < resting times what was lost.
// The way along the surface that it went relative to the body loses the same share, so that one that sticks does not
// creep. It is put back on the surface.
SHARED_FN Contact push_out(Vec3 x_start, Motion m, Surface s, Vec3 body_velocity, Friction friction, Real h)
{
    const Real zero = Real(0.0f), one = Real(1.0f);
    PRECISE Real touches = Real(CONTACT_SKIN) - s.distance;
    PRECISE Real depth = select_positive(-s.distance, -s.distance, zero);
    PRECISE Vec3 relative = m.velocity - body_velocity;
    PRECISE Real into = -dot_product(relative, s.normal);
    PRECISE Real lost = select_positive(into, into, zero);
    PRECISE Vec3 across = relative + lost * s.normal;
    PRECISE Real speed = max_real(vector_length(across), Real(1e-12f));
    PRECISE Real sticks = select_positive(friction.resting * lost - speed, one, zero);
    PRECISE Real sliding = one - friction.kinetic * lost / speed;
    PRECISE Real kept = select_positive(sticks, zero, select_positive(sliding, sliding, zero));

    PRECISE Vec3 way = m.position - x_start - h * body_velocity;
    PRECISE Vec3 way_across = way - dot_product(way, s.normal) * s.normal;
    PRECISE Vec3 position = m.position + depth * s.normal - (one - kept) * way_across;
    PRECISE Vec3 velocity = body_velocity + kept * across;

    Contact c;
    c.motion = motion(select_positive(touches, position, m.position), select_positive(touches, velocity, m.velocity));
    c.sticks = select_positive(touches, sticks, zero);
    return c;
}

// The velocity [m/s] over a substep of the point of a moving body that was at x_start, from the rows of BodyStep
// (src/model/body_steps.h); `speed` is that of the body's origin.
SHARED_FN Vec3 velocity_of_body(Vec3 x_start, Vec3 origin, Vec3 row_x, Vec3 row_y, Vec3 row_z, Vec3 speed)
{
    PRECISE Vec3 arm = x_start - origin;
    PRECISE Vec3 turning = Vec3(dot_product(row_x, arm), dot_product(row_y, arm), dot_product(row_z, arm));
    PRECISE Vec3 velocity = speed + turning;
    return velocity;
}
