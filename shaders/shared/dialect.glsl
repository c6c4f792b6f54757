// The GLSL side of the common dialect: what the formula headers of this folder are written in.
// The C++ side is src/model/formulas.h.
#define SHARED_FN
#define PRECISE precise
#define Real float
#define Vec3 vec3
#define Bits uint
#define max_real max
#define min_real min
#define floor_real floor
#define sqrt_real sqrt
#define sin_real sin
#define exp_real exp
#define pow_real pow

// condition > 0 ? a : b, for every lane where the C++ side runs many particles at once.
float select_positive(float condition, float a, float b)
{
    return condition > 0.0 ? a : b;
}

vec3 select_positive(float condition, vec3 a, vec3 b)
{
    return condition > 0.0 ? a : b;
}

// The bits of a whole number, and the other way for such below 2^24.
uint bits_of_whole(float a)
{
    return uint(int(a));
}

float real_of_bits(uint a)
{
    return float(a);
}

// The float whose bits are `minuend` less half of the bits of a.
float halved_bits_from(uint minuend, float a)
{
    return uintBitsToFloat(minuend - (floatBitsToUint(a) >> 1));
}
