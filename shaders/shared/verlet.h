// Velocity Verlet of one particle over a substep h [s], of second order also where forces depend on velocities:
//   v_half = v0 + h/2 a0,  x1 = x0 + h v_half,  a1 = a(x1, v_half + h/2 a0),  v1 = v_half + h/2 a1,
// and the next substep takes this a1 for its a0.

// Adds acceleration a over the time `half` = h/2: v0 to v_half, v_half to the velocity at which a1 is taken, or to v1.
SHARED_FN Vec3 verlet_kick(Vec3 v, Vec3 a, Real half_step)
{
    PRECISE Vec3 kicked = v + half_step * a;
    return kicked;
}

// x1 and v_half.
SHARED_FN Motion verlet_drift(Vec3 x, Vec3 v, Vec3 a, Real h)
{
    PRECISE Vec3 v_half = verlet_kick(v, a, Real(0.5f) * h);
    PRECISE Vec3 x1 = x + h * v_half;
    return motion(x1, v_half);
}
