// Explicit methods past their limit: the run stops with exit code 3 and the number of substeps that holds, and it
// holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "core/error.h"
#include "sim/simulation.h"
#include "solver/method_table.h"
#include "solver/solver_runs.h"

namespace nuno {
namespace {

class AdviceTest : public testing::TestWithParam<Method>
{};

// What a run of `scene` says where numbers go bad within `frames`; empty where they do not.
std::string last_words(const Scene& scene, const SimParams& params, int frames)
{
    Simulation simulation(scene, params);
    EXPECT_TRUE(simulation.stability_warning());
    try {
        for (int i = 0; i < frames; ++i) simulation.advance_frame();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::went_bad);
        return error.what();
    }
    return "";
}

TEST_P(AdviceTest, past_its_limit_a_run_stops_and_what_it_advises_holds)
{
    const Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    params.method = GetParam();
    params.collision = CollisionLevel::none;
    params.count_pass_through = 0;
    params.wind_strength = 0;
    // Without damping explicit Euler has no limit to be advised of.
    if (params.method == Method::explicit_euler) params.damping = 20;
    for (const float stiffness : {1e3f, 1e5f}) {
        params.structural_stiffness = stiffness;
        params.shear_stiffness = stiffness / 2;
        params.bend_stiffness = stiffness / 50;
        if (params.method == Method::explicit_euler && stiffness > 1e3f) continue;  // would be more than 10000
        params.substeps = 4;
        const std::string message = last_words(scene, params, 200);
        EXPECT_THAT(message, testing::AllOf(testing::HasSubstr("seed"), testing::HasSubstr("frame"),
                                            testing::HasSubstr("vertex"), testing::HasSubstr("substeps")));
        std::smatch advice;
        ASSERT_TRUE(std::regex_search(message, advice, std::regex("--set substeps=([0-9]+)"))) << message;
        params.substeps = std::stoi(advice[1]);
        Simulation advised(scene, params);
        EXPECT_EQ(advised.stability_warning(), std::nullopt);
        double fastest = 0, strain = 0;
        for (int i = 0; i < 60; ++i) {
            advised.advance_frame();
            const Diagnostics now = advised.diagnostics();
            fastest = std::max(fastest, now.max_speed);
            strain = std::max(strain, now.max_strain);
        }
        // No vertex of a sheet of 1 m can fall faster than from a height of 4 m, whip and all.
        EXPECT_LT(fastest, std::sqrt(2 * 9.81 * 4)) << message;
        EXPECT_LT(strain, 0.2) << message;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, AdviceTest, testing::ValuesIn(explicit_methods()), kMethodName);

}  // namespace
}  // namespace nuno
