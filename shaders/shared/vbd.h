// Vertex block descent (Chen et al. 2024): the energy of backward Euler over a substep h,
//     E(u) = sum_i m_i / (2 h^2) |u_i - target_i|^2 + springs + dampers,   u = x - x(start of the substep) [m],
// goes down vertex by vertex, each solving its own 3 x 3 Newton step with all others held.

// m / (m + h rho): the share of a velocity that the air damper leaves over h, taken at the end of it; 1 where pinned.
SHARED_FN Real vbd_keep(Real inverse_mass, Real rho, Real h)
{
    PRECISE Real keep = Real(1.0f) / (Real(1.0f) + h * rho * inverse_mass);
    return keep;
}

// Where a particle would go without springs, a [m/s2] that of all other forces.
SHARED_FN Motion vbd_free_motion(Vec3 x, Vec3 v, Vec3 a, Real keep, Real h)
{
    PRECISE Vec3 v1 = keep * (v + h * a);
    PRECISE Vec3 x1 = x + h * v1;
    return motion(x1, v1);
}

// What one vertex sums up over its springs: minus the gradient [N], and the Hessian [N/m] as
// even I + the symmetric matrix of `diagonal` and `mixed` (xy, xz, yz).
struct VertexBlock
{
    Vec3 force;
    Vec3 diagonal;
    Vec3 mixed;
    Real even;
};

SHARED_FN VertexBlock empty_block()
{
    const Real zero = Real(0.0f);
    VertexBlock b;
    b.force = Vec3(zero, zero, zero);
    b.diagonal = Vec3(zero, zero, zero);
    b.mixed = Vec3(zero, zero, zero);
    b.even = zero;
    return b;
}

// Adds a spring as spring_force has it, axial k and rest length tension / k, d to the other end. Its Hessian is
//     k (n n^T + max(0, 1 - l0 / l) (I - n n^T)) + (stiffness - k) I:
// a spring that is too short would push sideways, which is left out so that the matrix stays positive.
SHARED_FN VertexBlock with_spring(VertexBlock b, Vec3 d, Real stiffness, Real tension, Real axial)
{
    PRECISE Real inverse = Real(1.0f) / max_real(vector_length(d), Real(1e-12f));
    PRECISE Real pull = tension * inverse;
    PRECISE Real along = min_real(axial, pull);
    PRECISE Vec3 slope = (along * inverse * inverse) * d;
    PRECISE Vec3 force = b.force + (stiffness - pull) * d;
    PRECISE Vec3 diagonal = b.diagonal + Vec3(slope.x * d.x, slope.y * d.y, slope.z * d.z);
    PRECISE Vec3 mixed = b.mixed + Vec3(slope.x * d.y, slope.x * d.z, slope.y * d.z);
    PRECISE Real even = b.even + (stiffness - along);
    b.force = force;
    b.diagonal = diagonal;
    b.mixed = mixed;
    b.even = even;
    return b;
}

// Adds a damper along d: force c (n . w) n, c [N/m] its coefficient over h, w = u_j - u_i.
SHARED_FN VertexBlock with_damper(VertexBlock b, Vec3 d, Vec3 w, Real c)
{
    PRECISE Vec3 slope = (c / max_real(dot_product(d, d), Real(1e-24f))) * d;
    PRECISE Vec3 force = b.force + dot_product(slope, w) * d;
    PRECISE Vec3 diagonal = b.diagonal + Vec3(slope.x * d.x, slope.y * d.y, slope.z * d.z);
    PRECISE Vec3 mixed = b.mixed + Vec3(slope.x * d.y, slope.x * d.z, slope.y * d.z);
    b.force = force;
    b.diagonal = diagonal;
    b.mixed = mixed;
    return b;
}

// Past `longest` times its rest length a spring is `stiffer` times as stiff on top.
SHARED_FN VertexBlock with_limit(VertexBlock b, Vec3 d, Real tension, Real axial, Real longest, Real stiffer)
{
    PRECISE Real k = stiffer * axial;
    PRECISE Real t = stiffer * longest * tension;
    PRECISE Real over = k * vector_length(d) - t;
    const Real zero = Real(0.0f);
    PRECISE Real k_over = select_positive(over, k, zero);
    PRECISE Real t_over = select_positive(over, t, zero);
    return with_spring(b, d, k_over, t_over, k_over);
}

// The Newton step of u: (I + s H) step = target - u + s force, with s = h^2 / (m + h rho) [m/N], 0 where pinned. The
// matrix is never below I, and so neither are the pivots of its factors L D L^T; 5e-7 of its trace more on the diagonal
// outweighs their rounding where s H is huge, and moves no solution.
SHARED_FN Vec3 newton_step(VertexBlock b, Vec3 target, Vec3 u, Real s)
{
    const Real one = Real(1.0f);
    PRECISE Vec3 rest = target - u + s * b.force;
    PRECISE Vec3 stiff = Vec3(s * (b.even + b.diagonal.x), s * (b.even + b.diagonal.y), s * (b.even + b.diagonal.z));
    PRECISE Vec3 mixed = s * b.mixed;
    PRECISE Real least = one + Real(5e-7f) * (stiff.x + stiff.y + stiff.z);
    PRECISE Real inverse_x = one / (least + stiff.x);
    PRECISE Real yx = mixed.x * inverse_x;
    PRECISE Real zx = mixed.y * inverse_x;
    PRECISE Real inverse_y = one / max_real(least + stiff.y - yx * mixed.x, one);
    PRECISE Real below = mixed.z - zx * mixed.x;
    PRECISE Real zy = below * inverse_y;
    PRECISE Real pivot_z = max_real(least + stiff.z - zx * mixed.y - zy * below, one);
    PRECISE Real y = rest.y - yx * rest.x;
    PRECISE Real z = (rest.z - zx * rest.x - zy * y) / pivot_z;
    PRECISE Real step_y = y * inverse_y - zy * z;
    PRECISE Real step_x = rest.x * inverse_x - yx * step_y - zx * z;
    return Vec3(step_x, step_y, z);
}
