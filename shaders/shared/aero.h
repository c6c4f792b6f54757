// The quasi-steady force of moving air on a face.

struct Air
{
    Real density;         // rho [kg/m3]
    Real pressure, skin;  // coefficients Cn, Ct
    Real areal_density;   // of the cloth [kg/m2]
    Real h;               // substep [s]
};

// Share of a damper's force that is kept where it would take `lost` of the relative velocity in one substep: all up to
// a half, and never more than that half. So the force cannot turn the velocity round, and its rate stays below 1 / h.
SHARED_FN Real kept_of_damper(Real lost) { return Real(1.0f) / max_real(Real(1.0f), Real(2.0f) * lost); }

// F = rho A / 2 (Cn |u.n| (u.n) n + Ct |u| u_t) [N], u: velocity of the air relative to the face [m/s], u_t its part
// along the face, A and n area and normal of the face with edges e1, e2; mass_area as FaceRest has it. A face without
// area feels nothing.
SHARED_FN Vec3 face_air_force(Vec3 e1, Vec3 e2, Vec3 u, Real mass_area, Air air)
{
    PRECISE Vec3 c = area_vector(e1, e2);
    PRECISE Real twice_area = vector_length(c);
    PRECISE Vec3 n = c / max_real(twice_area, Real(1e-30f));
    PRECISE Real normal_speed = dot_product(u, n);
    PRECISE Vec3 along = u - normal_speed * n;
    PRECISE Real drag = Real(0.25f) * air.density * twice_area;
    PRECISE Real normal_drag = drag * air.pressure * max_real(normal_speed, -normal_speed);
    PRECISE Real skin_drag = drag * air.skin * vector_length(u);
    PRECISE Real lost = air.h / max_real(air.areal_density * mass_area, Real(1e-20f));
    PRECISE Real normal_kept = normal_drag * kept_of_damper(lost * normal_drag);
    PRECISE Real skin_kept = skin_drag * kept_of_damper(lost * skin_drag);
    PRECISE Vec3 force = (normal_kept * normal_speed) * n + skin_kept * along;
    return force;
}

// What a face has of its corners' places or velocities.
SHARED_FN Vec3 face_mean(Vec3 a, Vec3 b, Vec3 c)
{
    PRECISE Vec3 sum = a + b + c;
    PRECISE Vec3 mean = Real(0.333333343f) * sum;
    return mean;
}

SHARED_FN Vec3 relative_air(Vec3 air, Vec3 face_velocity) { return air - face_velocity; }

// A corner's share of a force on its face.
SHARED_FN Vec3 third_of(Vec3 force)
{
    PRECISE Vec3 third = Real(0.333333343f) * force;
    return third;
}
