// The sheen of cloth against what light allows: no more goes out than came in, and it goes both ways alike.
#include "render/sheen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kRoughnesses[] = {0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f};
constexpr float kCosines[] = {0.02f, 0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.7f, 0.85f, 1.0f};

// What sheen and threads together reflect of light from one direction, white threads below sheen of strength 1: the
// shader's formula, integrated over the directions of the eye.
double reflected_by_white_cloth(float cos_light, float roughness)
{
    const glm::vec4 fit = fit_sheen_albedo(roughness);
    constexpr int count = 400;
    double threads = 0;
    for (int i = 0; i < count; ++i) {
        const float cos_eye = (float(i) + 0.5f) / count;
        const float taken = std::max(fitted_sheen_albedo(fit, cos_eye), fitted_sheen_albedo(fit, cos_light));
        threads += 2.0 * double(cos_eye * (1 - taken)) / count;
    }
    return threads + double(integrate_sheen(cos_light, roughness, 128));
}

TEST(Sheen, reflects_some_light_and_never_more_than_comes)
{
    for (const float roughness : kRoughnesses)
        for (const float cosine : kCosines) {
            const float albedo = integrate_sheen(cosine, roughness, 128);
            EXPECT_LE(albedo, 1.0f) << "roughness " << roughness << ", cosine " << cosine;
            EXPECT_GT(albedo, 1e-4f) << "roughness " << roughness << ", cosine " << cosine;
        }
}

TEST(Sheen, is_the_same_with_light_and_eye_exchanged)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> height(0.02f, 1.0f), turn(0.0f, 2 * std::numbers::pi_v<float>);
    const auto direction = [&] {
        const float z = height(random), around = turn(random), side = std::sqrt(1 - z * z);
        return glm::vec3(side * std::cos(around), side * std::sin(around), z);
    };
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 light = direction(), eye = direction();
        const float there = sheen_brdf(light, eye, 0.4f), back = sheen_brdf(eye, light, 0.4f);
        ASSERT_GE(there, 0.0f);
        ASSERT_NEAR(there, back, 1e-4f * std::max(there, back)) << i;
    }
}

TEST(Sheen, glows_at_the_rim)
{
    for (const float roughness : kRoughnesses)
        EXPECT_GT(integrate_sheen(0.05f, roughness, 128), 3 * integrate_sheen(0.9f, roughness, 128)) << roughness;
}

TEST(Sheen, fit_is_near_the_integral_and_rather_above_it)
{
    for (const float roughness : kRoughnesses) {
        const glm::vec4 fit = fit_sheen_albedo(roughness);
        for (const float cosine : kCosines) {
            const float over = fitted_sheen_albedo(fit, cosine) - integrate_sheen(cosine, roughness, 128);
            EXPECT_GT(over, -0.01f) << "roughness " << roughness << ", cosine " << cosine;
            EXPECT_LT(over, 0.025f) << "roughness " << roughness << ", cosine " << cosine;
        }
    }
}

// The threads get what the sheen leaves: all in all no more than came, but for the error of the fit.
TEST(Sheen, over_white_threads_reflects_no_more_than_comes)
{
    for (const float roughness : kRoughnesses)
        for (const float cosine : kCosines) {
            const double reflected = reflected_by_white_cloth(cosine, roughness);
            EXPECT_LE(reflected, 1.01) << "roughness " << roughness << ", cosine " << cosine;
            EXPECT_GT(reflected, 0.5) << "roughness " << roughness << ", cosine " << cosine;
        }
}

}  // namespace
}  // namespace nuno
