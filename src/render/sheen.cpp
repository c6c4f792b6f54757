// The formulas as C++, and integrals of them.
#include "render/sheen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#define SHARED_FN inline

namespace nuno {
namespace formulas {
namespace {

using Real = float;
inline Real max_real(Real a, Real b) { return std::max(a, b); }
inline Real min_real(Real a, Real b) { return std::min(a, b); }
inline Real sqrt_real(Real a) { return std::sqrt(a); }
inline Real exp_real(Real a) { return std::exp(a); }
inline Real pow_real(Real a, Real b) { return std::pow(a, b); }
#include "shaders/shared/sheen.h"

}  // namespace
}  // namespace formulas

float sheen_brdf(glm::vec3 light, glm::vec3 eye, float roughness)
{
    const float cos_half = glm::normalize(light + eye).z;
    return formulas::sheen_reflection(light.z, eye.z, cos_half, roughness) / light.z;
}

float integrate_sheen(float cosine, float roughness, int count)
{
    const glm::vec3 eye(std::sqrt(1 - cosine * cosine), 0, cosine);
    double sum = 0;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            // Equal steps of the cosine are equal solid angles; both halves of the circle are alike.
            const float z = (float(i) + 0.5f) / float(count), side = std::sqrt(1 - z * z);
            const float around = std::numbers::pi_v<float> * (float(j) + 0.5f) / float(count);
            const glm::vec3 light(side * std::cos(around), side * std::sin(around), z);
            sum += double(z * sheen_brdf(light, eye, roughness));
        }
    return static_cast<float>(2 * std::numbers::pi * sum / (double(count) * count));
}

glm::vec4 fit_sheen_albedo(float roughness)
{
    // Through four points, chosen so that between them it is rather too much: then no light is made.
    constexpr float cosines[] = {0.02f, 0.15f, 0.5f, 0.95f};
    glm::mat4 powers(1);
    glm::vec4 albedo(0);
    for (int k = 0; k < 4; ++k) {
        for (int power = 0; power < 4; ++power) powers[power][k] = std::pow(cosines[k], 0.25f * float(power));
        albedo[k] = integrate_sheen(cosines[k], roughness, 48);
    }
    return glm::inverse(powers) * albedo;
}

float fitted_sheen_albedo(const glm::vec4& fit, float cosine)
{
    return formulas::sheen_albedo(cosine, fit.x, fit.y, fit.z, fit.w);
}

}  // namespace nuno
