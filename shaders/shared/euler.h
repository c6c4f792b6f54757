// Euler integration of one particle over a substep h [s]: x [m], v [m/s], a [m/s2] at the start of the substep.
struct Motion
{
    Vec3 position;
    Vec3 velocity;
};

SHARED_FN Motion motion(Vec3 position, Vec3 velocity)
{
    Motion m;
    m.position = position;
    m.velocity = velocity;
    return m;
}

// condition > 0 ? a : b.
SHARED_FN Motion select_motion(Real condition, Motion a, Motion b)
{
    return motion(select_positive(condition, a.position, b.position),
                  select_positive(condition, a.velocity, b.velocity));
}

// As the seed writes it (section 2.4), both updates from the old state: v1 = v0 + a h, x1 = x0 + v0 h.
SHARED_FN Motion explicit_euler(Vec3 x, Vec3 v, Vec3 a, Real h)
{
    PRECISE Vec3 v1 = v + h * a;
    PRECISE Vec3 x1 = x + h * v;
    return motion(x1, v1);
}

// Symplectic (semi-implicit) Euler: v1 = v0 + a h, x1 = x0 + v1 h.
SHARED_FN Motion symplectic_euler(Vec3 x, Vec3 v, Vec3 a, Real h)
{
    PRECISE Vec3 v1 = v + h * a;
    PRECISE Vec3 x1 = x + h * v1;
    return motion(x1, v1);
}
