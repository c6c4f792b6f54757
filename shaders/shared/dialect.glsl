// The GLSL side of the common dialect: what the formula headers of this folder are written in.
// The C++ side is src/model/formulas.h.
#define SHARED_FN
#define PRECISE precise
#define Real float
#define Vec3 vec3
#define max_real max
#define sqrt_real sqrt
#define sin_real sin

// condition > 0 ? a : b, for every lane where the C++ side runs many particles at once.
float select_positive(float condition, float a, float b)
{
    return condition > 0.0 ? a : b;
}

vec3 select_positive(float condition, vec3 a, vec3 b)
{
    return condition > 0.0 ? a : b;
}
