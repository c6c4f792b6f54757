// How much light the sheen of cloth reflects, from the formulas of shaders/shared/sheen.h.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nuno {

// The BRDF [1/sr] between two directions of unit length around the normal +z, both above the surface; roughness 0.1 ..
// 1.
float sheen_brdf(glm::vec3 light, glm::vec3 eye, float roughness);

// The part of the light from a direction of this cosine, 0 .. 1, that is reflected: the integral of the BRDF times the
// cosine over the hemisphere, by the midpoint rule on count x count directions.
float integrate_sheen(float cosine, float roughness, int count);

// Coefficients c0 .. c3 of `sheen_albedo`; from a cosine of 0.02 on it is 0.01 less to 0.025 more than the
// integral.
glm::vec4 fit_sheen_albedo(float roughness);

// That cubic, as the shader has it.
float fitted_sheen_albedo(const glm::vec4& fit, float cosine);

}  // namespace nuno
