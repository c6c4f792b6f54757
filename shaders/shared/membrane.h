// In-plane elasticity of a face: orthotropic St. Venant-Kirchhoff membrane.

// A face at rest. With e1, e2 the edges from corner 0 to 1 and 2, the columns of the deformation gradient, along warp
// and weft, are  f_warp = warp_1 e1 + warp_2 e2,  f_weft = weft_1 e1 + weft_2 e2.
struct FaceRest
{
    Real warp_1, warp_2, weft_1, weft_2;  // [1/m]
    Real area;                            // [m2]
    Real mass_area;                       // [m2] of cloth: three times the face's share of its lightest corner
};

// [N/m]: C11, C22, C12, C33; damping: beta [s] of the Rayleigh damper.
struct MembraneConstants
{
    Real warp, weft, cross, shear, damping;
};

// Forces [N] on the corners; the one on corner 0 is minus their sum.
struct CornerForces
{
    Vec3 on_1, on_2;
};

// Energy per area at rest, with the strain E = (F^T F - 1) / 2 of F = (f_warp, f_weft):
//   1/2 (C11 E11^2 + C22 E22^2) + C12 E11 E22 + 1/2 C33 (2 E12)^2.
// The stress S = C (E + beta dE/dt) gives the forces  -area F S  along the shape functions' gradients. u1, u2: velocity
// of corner 1 and 2 relative to corner 0 [m/s].
SHARED_FN CornerForces membrane_forces(Vec3 e1, Vec3 e2, Vec3 u1, Vec3 u2, FaceRest rest, MembraneConstants c)
{
    const Real one_half = Real(0.5f), one = Real(1.0f);
    PRECISE Vec3 f_warp = rest.warp_1 * e1 + rest.warp_2 * e2;
    PRECISE Vec3 f_weft = rest.weft_1 * e1 + rest.weft_2 * e2;
    PRECISE Vec3 g_warp = rest.warp_1 * u1 + rest.warp_2 * u2;
    PRECISE Vec3 g_weft = rest.weft_1 * u1 + rest.weft_2 * u2;
    PRECISE Real along_warp = one_half * (dot_product(f_warp, f_warp) - one) + c.damping * dot_product(f_warp, g_warp);
    PRECISE Real along_weft = one_half * (dot_product(f_weft, f_weft) - one) + c.damping * dot_product(f_weft, g_weft);
    PRECISE Real angle =
        dot_product(f_warp, f_weft) + c.damping * (dot_product(f_warp, g_weft) + dot_product(g_warp, f_weft));
    PRECISE Real s_warp = rest.area * (c.warp * along_warp + c.cross * along_weft);
    PRECISE Real s_weft = rest.area * (c.cross * along_warp + c.weft * along_weft);
    PRECISE Real s_angle = rest.area * (c.shear * angle);
    PRECISE Vec3 p_warp = s_warp * f_warp + s_angle * f_weft;
    PRECISE Vec3 p_weft = s_angle * f_warp + s_weft * f_weft;
    CornerForces forces;
    PRECISE Vec3 on_1 = -rest.warp_1 * p_warp - rest.weft_1 * p_weft;
    PRECISE Vec3 on_2 = -rest.warp_2 * p_warp - rest.weft_2 * p_weft;
    forces.on_1 = on_1;
    forces.on_2 = on_2;
    return forces;
}
