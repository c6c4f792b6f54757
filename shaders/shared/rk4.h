// The classic Runge-Kutta method of fourth order for one particle over a substep h [s]. The slopes k of the state (x,
// v) are (v, a(x, v)); stages s = 1 .. 4 take theirs at the start plus 0, h/2, h/2, h times the slope before, and
//   x1 = x0 + h/6 (k1 + 2 k2 + 2 k3 + k4),  v1 alike.

// The state at which the next stage takes its slope: `step` [s] from the start along the slope (v, a).
SHARED_FN Motion rk4_stage(Motion start, Vec3 v, Vec3 a, Real step)
{
    PRECISE Vec3 stage_x = start.position + step * v;
    PRECISE Vec3 stage_v = start.velocity + step * a;
    return motion(stage_x, stage_v);
}

// Sum of the slopes so far, with (v, a) of this stage.
SHARED_FN Motion rk4_add(Motion sum, Vec3 v, Vec3 a, Real weight)
{
    PRECISE Vec3 sum_v = sum.position + weight * v;
    PRECISE Vec3 sum_a = sum.velocity + weight * a;
    return motion(sum_v, sum_a);
}

// The end of the substep, from the sum over all four stages.
SHARED_FN Motion rk4_end(Motion start, Motion sum, Real h)
{
    PRECISE Real sixth = h / Real(6.0f);
    return rk4_stage(start, sum.position, sum.velocity, sixth);
}
