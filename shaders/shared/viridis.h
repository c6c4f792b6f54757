// The colour map viridis of S. van der Walt and N. Smith (matplotlib, 2015): even steps of t, 0 .. 1, are even steps to
// the eye, also to one that is blind to some colours, and in grey. Here as the polynomial of degree 6 that M. Zucker
// fitted to its table (shadertoy.com/view/WlfXRN), off by less than 4 of 255. sRGB.
SHARED_FN Vec3 viridis(Real value)
{
    const Real t = max_real(Real(0.0f), min_real(value, Real(1.0f)));
    const Vec3 c0 = Vec3(0.2777273f, 0.0054073f, 0.3340998f), c1 = Vec3(0.1050930f, 1.4046135f, 1.3845902f);
    const Vec3 c2 = Vec3(-0.3308618f, 0.2148476f, 0.0950952f), c3 = Vec3(-4.6342305f, -5.7991010f, -19.3324410f);
    const Vec3 c4 = Vec3(6.2282699f, 14.1799334f, 56.6905526f), c5 = Vec3(4.7763850f, -13.7451454f, -65.3530326f);
    const Vec3 c6 = Vec3(-5.4354559f, 4.6458526f, 26.3124352f);
    return c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * c6)))));
}
