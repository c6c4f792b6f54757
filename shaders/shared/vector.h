// Vector sums written out in one order, so that every compiler rounds them alike (GLSL's dot and length do not promise
// it).
SHARED_FN Real dot_product(Vec3 a, Vec3 b)
{
    PRECISE Real sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

SHARED_FN Real vector_length(Vec3 a) { return sqrt_real(dot_product(a, a)); }
