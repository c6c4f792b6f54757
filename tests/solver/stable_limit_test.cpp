// Where explicit methods blow up, measured, against the limit that is predicted: within 3 %.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/stability.h"
#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

struct Case
{
    Method method;
    InternalModel internal;
    float damping, stiffness_damping;
};

std::string name_of(const Case& c)
{
    std::string name = name_of(c.method);
    name += c.internal == InternalModel::continuum ? "_continuum" : "_springs";
    if (c.damping > 0) name += "_damped";
    if (c.stiffness_damping > 0) name += "_rayleigh";
    return name;
}

class StableLimitTest : public testing::TestWithParam<Case>
{
  protected:
    // Whether noise of 2e-5 m grows past 5e-4 m within so many substeps that 1 % past the limit is enough for it; of
    // explicit Euler, which grows by W^2 / 200 a substep there, with W near 0.1, these are many.
    bool blows_up(const SimParams& params) const
    {
        SimParams noisy = params;
        noisy.seed = 1;
        noisy.jitter = 2e-5f;
        const int substeps = params.method == Method::explicit_euler ? 60000 : 12000;
        const ClothState start = start_state(model_, noisy), end = run(model_, params, start, substeps);
        for (std::size_t v = 0; v < end.positions.size(); ++v)
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(end.positions[v][axis] - start.positions[v][axis]) < 5e-4f)) return true;
        return false;
    }

    const ClothModel model_ = square_cloth(12, 1, {0, 11});
};

TEST_P(StableLimitTest, the_measured_limit_is_within_3_percent_of_the_prediction)
{
    SimParams params = on_cpu(GetParam().method);
    params.areal_density = 0.072f;
    params.structural_stiffness = 50;
    params.shear_stiffness = 25;
    params.bend_stiffness = 10;
    params.internal_model = GetParam().internal;
    params.warp_stiffness = params.weft_stiffness = 80;
    params.cross_stiffness = 20;
    params.shear_modulus = 25;
    params.damping = GetParam().damping;
    params.stiffness_damping = GetParam().stiffness_damping;
    params.gravity_y = 0;
    std::vector<glm::dvec3> mode;
    const ClothState state = start_state(model_, params);
    for (int i = 0; i < 10; ++i) omega_max(model_, params, state, mode);
    const double predicted = largest_stable_substep(params, omega_max(model_, params, state, mode));
    // One substep a frame would be too long; 1 / h substeps in a frame of 1 s.
    double stable = 0.9 * predicted, unstable = 1.1 * predicted;
    for (int i = 0; i < 5; ++i) {
        const double middle = (stable + unstable) / 2;
        params.substeps = static_cast<int>(std::lround(1 / middle));
        (blows_up(params) ? unstable : stable) = middle;
    }
    expect_measured(fmt::format("stability limit, {}: substep, s", name_of(GetParam())), (stable + unstable) / 2,
                    predicted, 0.03 * predicted);
}

constexpr InternalModel kSprings = InternalModel::springs, kContinuum = InternalModel::continuum;

INSTANTIATE_TEST_SUITE_P(
    Cases, StableLimitTest,
    testing::Values(Case{Method::explicit_euler, kSprings, 7, 0}, Case{Method::explicit_euler, kContinuum, 7, 0},
                    Case{Method::explicit_euler, kSprings, 0, 5e-4f}, Case{Method::symplectic_euler, kSprings, 0, 0},
                    Case{Method::symplectic_euler, kSprings, 30, 0}, Case{Method::symplectic_euler, kSprings, 0, 1e-3f},
                    Case{Method::symplectic_euler, kContinuum, 0, 0},
                    Case{Method::symplectic_euler, kContinuum, 0, 1e-3f}, Case{Method::verlet, kSprings, 0, 0},
                    Case{Method::verlet, kSprings, 30, 0}, Case{Method::verlet, kSprings, 0, 1e-3f},
                    Case{Method::verlet, kContinuum, 0, 0}, Case{Method::verlet, kContinuum, 0, 1e-3f},
                    Case{Method::rk4, kSprings, 0, 0}, Case{Method::rk4, kSprings, 30, 0},
                    Case{Method::rk4, kSprings, 0, 1e-3f}, Case{Method::rk4, kContinuum, 0, 0},
                    Case{Method::rk4, kContinuum, 0, 1e-3f}),
    [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace nuno
