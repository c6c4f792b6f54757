// The sheen of cloth: the microfacet model "Charlie" of A. C. Estevez and C. Kulla, Production Friendly Microfacet
// Sheen BRDF, 2017, whose facets are the fibres that stand off a fabric. Roughness r: 0 .. 1; cosines are with the
// normal.

// D = (2 + 1/r) sin(h)^(1/r) / (2 pi), equation 2 of the paper.
SHARED_FN Real sheen_distribution(Real cos_half, Real r)
{
    Real sin_sq = max_real(Real(1.0f) - cos_half * cos_half, Real(1e-6f));
    return (Real(2.0f) + Real(1.0f) / r) * pow_real(sin_sq, Real(0.5f) / r) * Real(0.159154943f);
}

// L of the paper: its fit, between the numbers for r = 0 and for r = 1, to the logarithm of what is below.
SHARED_FN Real sheen_shadowing_fit(Real x, Real r)
{
    Real t = (Real(1.0f) - r) * (Real(1.0f) - r);
    Real a = Real(21.5473f) + t * Real(3.7772f);
    Real b = Real(3.82987f) - t * Real(0.50552f);
    Real c = Real(0.19823f) - t * Real(0.03022f);
    Real d = Real(-1.97760f) + t * Real(0.70367f);
    Real e = Real(-4.32054f) - t * Real(0.53913f);
    return a / (Real(1.0f) + b * pow_real(x, c)) + d * x + e;
}

// Lambda of Smith for this distribution: how many facets hide each one that is seen along a direction.
SHARED_FN Real sheen_shadowing(Real cosine, Real r)
{
    Real x = min_real(cosine, Real(1.0f) - cosine);
    Real fit = sheen_shadowing_fit(max_real(x, Real(0.0f)), r);
    Real mirrored = Real(2.0f) * sheen_shadowing_fit(Real(0.5f), r) - fit;
    return exp_real(cosine < Real(0.5f) ? fit : mirrored);
}

// The BRDF [1/sr] times the cosine of the light, of a fabric that is all fibres. The paper's softer terminator is left
// out, for with it light would not go both ways alike.
SHARED_FN Real sheen_reflection(Real cos_light, Real cos_eye, Real cos_half, Real r)
{
    Real hidden = sheen_shadowing(cos_light, r) + sheen_shadowing(cos_eye, r);
    return sheen_distribution(cos_half, r) / ((Real(1.0f) + hidden) * Real(4.0f) * cos_eye);
}

// The part of the light from one direction that the sheen sends anywhere, by a fit of its integral: a cubic in the fourth
// root of the direction's cosine (coefficients: fit_sheen_albedo of src/render/sheen.h).
SHARED_FN Real sheen_albedo(Real cosine, Real c0, Real c1, Real c2, Real c3)
{
    Real s = sqrt_real(sqrt_real(max_real(cosine, Real(0.0f))));
    return c0 + s * (c1 + s * (c2 + s * c3));
}
