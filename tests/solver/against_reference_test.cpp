// The methods that are stable at any substep against `reference`, on a small cloth in motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr double kSeconds = 0.2, kGravity = 9.86;  // 9.81 down and 1 sideways

// 10 x 10 vertices of 5e-4 kg, springs of 40, 20 and 8 N/m, two pins, falling and pushed sideways from rest.
SimParams small_sheet(SimParams params)
{
    params.frame_rate = 5;
    params.bend_stiffness = 8;
    params.gravity_z = 1;
    params.damping = 0.1f;
    return params;
}

// What theory lets the mean error be, where the mean vertex has moved by `moved`: the modes that move most have A
// omega^2 = g, so omega = sqrt(g / moved).
//     Implicit Euler damps A by the share omega^2 h t / 2, and vbd with it:            g h t / 2.
//     Alexander's method turns a mode by 0.0404 (omega h)^2 omega t less than it should; higher modes, which move less
//     but turn more, are allowed twice that again:                                     3 * 0.0404 g t omega h^2.
//     xpbd takes each spring by itself, softer by the share s^2 k (w_a + w_b) with its step s = 2 h / 3, and moves the
//     cloth by no more than that share of its way.
double error_of_theory(const SimParams& params, double moved)
{
    const double h = double(substep_s(params)), mass = 5e-4;
    if (order_of(params.method) == 1) return kGravity * h * kSeconds / 2;
    if (params.method == Method::sdirk2) return 3 * 0.0404 * kGravity * kSeconds * std::sqrt(kGravity / moved) * h * h;
    return moved * std::pow(2 * h / 3, 2) * double(params.structural_stiffness) * 2 / mass;
}

class AgainstReferenceTest : public testing::TestWithParam<MethodAndSweep>
{};

TEST_P(AgainstReferenceTest, the_error_is_below_that_of_theory_and_falls_with_the_substep)
{
    const ClothModel model = square_cloth(10, 0.5f, {0, 9});
    SimParams params = small_sheet(on_cpu(GetParam().method, GetParam().sweep)),
              exact = small_sheet(on_cpu(Method::reference));
    exact.tolerance = 1e-6f;
    params.tolerance = 1e-8f;
    if (params.method == Method::vbd) params.iterations = 20;
    const ClothState start = start_state(model, params), truth = run(model, exact, start, 1);
    ASSERT_NEAR(double(1 / start.positions[50].w), 5e-4, 1e-9);
    const double moved = mean_distance(start, truth);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        params.substeps = 100 << i;
        errors[i] = mean_distance(run(model, params, start, params.substeps), truth);
        expect_measured(fmt::format("{} of {} ms against reference: mean error, m", name_of(GetParam()),
                                    1000 * kSeconds / params.substeps),
                        errors[i], 0, error_of_theory(params, moved));
    }
    EXPECT_LT(errors[1], errors[0] * std::exp2(0.5 - order_of(params.method)));
}

INSTANTIATE_TEST_SUITE_P(Methods, AgainstReferenceTest, testing::ValuesIn([] {
                             std::vector<MethodAndSweep> all = methods_and_sweeps();
                             std::erase_if(all, [](const MethodAndSweep& each) {
                                 return is_explicit(each.method) || each.method == Method::reference;
                             });
                             return all;
                         }()),
                         kMethodName);

}  // namespace
}  // namespace nuno
