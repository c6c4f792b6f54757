// nuno explain: what is needed is found to be, and what is idle to go.
#include "study/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace nuno {
namespace {

Explanation explain_small(const char* name, int frames, const Setting& settings, double tolerance)
{
    Scene scene = load_scene(name);
    SimParams params = with_setting(scene.params, settings);
    params.threads = 1;
    scene.check.frames = frames;
    SceneStudy study(std::move(scene), params);
    return explain_scene(study, tolerance, [](std::size_t, std::size_t) { return true; });
}

const LeftOut& part_of(const Explanation& explanation, const std::string& name)
{
    const auto found = std::find_if(explanation.parts.begin(), explanation.parts.end(),
                                    [&](const LeftOut& out) { return out.part == name; });
    if (found == explanation.parts.end()) throw std::runtime_error("no part " + name);
    return *found;
}

TEST(Explain, what_moves_the_cloth_is_needed_and_what_nothing_touches_is_not)
{
    const Explanation seed = explain_small("seed", 20, {{"resolution", "17"}}, 0.01);
    EXPECT_TRUE(part_of(seed, "shear").is_needed);
    EXPECT_GT(part_of(seed, "shear").change_share, 0.01);
    // Layers do not meet so early.
    EXPECT_EQ(part_of(seed, "self-collision").change_share, 0);
    EXPECT_FALSE(part_of(seed, "self-collision").is_needed);
    EXPECT_FALSE(part_of(seed, "friction").is_needed);
    EXPECT_THAT(seed.absent, testing::Contains("gusts"));
}

TEST(Explain, self_collision_is_needed_where_layers_would_intersect_without)
{
    const Explanation stack = explain_small("stack", 40, {{"resolution", "12"}}, 1.0);
    EXPECT_EQ(stack.intersections, 0);
    EXPECT_GT(part_of(stack, "self-collision").intersections, 0);
    EXPECT_TRUE(part_of(stack, "self-collision").is_needed);
}

TEST(Explain, a_change_below_the_tolerance_does_not_matter)
{
    const Explanation strict = explain_small("seed", 20, {{"resolution", "9"}}, 1e-9);
    const Explanation lax = explain_small("seed", 20, {{"resolution", "9"}}, 1.0);
    EXPECT_TRUE(part_of(strict, "wind").is_needed);
    EXPECT_FALSE(part_of(lax, "wind").is_needed);
    EXPECT_THAT(setting_text(part_of(lax, "wind").set), testing::HasSubstr("wind_strength=0"));
    EXPECT_THAT(explain_table(lax), testing::HasSubstr("wind"));
    EXPECT_EQ(explain_json(lax)["parts"].size(), lax.parts.size());
}

TEST(Explain, a_scene_that_goes_bad_is_told_to)
{
    EXPECT_THAT(
        [] {
            explain_small("seed", 20,
                          {{"resolution", "9"},
                           {"method", "explicit_euler"},
                           {"substeps", "1"},
                           {"structural_stiffness", "1000000"}},
                          1.0);
        },
        testing::ThrowsMessage<Error>(testing::HasSubstr("no longer finite")));
}

}  // namespace
}  // namespace nuno
