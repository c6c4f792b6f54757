// The seed's wind, section 2.2.4: alpha sin(100 t / 85) sin(100 t / 65) along z, here as a pressure [N/m2] on the
// vertex area. Called once a substep on the CPU: sin is not rounded alike everywhere, so both backends are handed its
// value.
SHARED_FN Real sines_wind(Real alpha, Real time)
{
    return alpha * sin_real(time * Real(100.0f) / Real(85.0f)) * sin_real(time * Real(100.0f) / Real(65.0f));
}
