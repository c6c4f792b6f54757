// Starts that intersect themselves, and the check of poses, seen from a simulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/pose_check.h"
#include "sim/run_recorder.h"
#include "sim/simulation.h"
#include "support/program_run.h"
#include "support/tangled_sheets.h"

namespace nuno {
namespace {

using testing::HasSubstr;

struct TangledScene
{
    TemporaryDirectory directory;
    Scene scene = load_scene(directory.write("tangled.toml", kTangledSheets).string());
    SimParams params = scene.params;
    TangledScene()
    {
        params.backend = Backend::cpu;
        params.collision = CollisionLevel::guaranteed;
    }
};

TEST(TangledStart, is_looked_for_only_where_the_level_needs_it)
{
    TangledScene tangled;
    for (const CollisionLevel level : {CollisionLevel::none, CollisionLevel::spheres, CollisionLevel::discrete}) {
        tangled.params.collision = level;
        EXPECT_FALSE(Simulation(tangled.scene, tangled.params).start_check().looked);
    }
    for (const CollisionLevel level :
         {CollisionLevel::speculative, CollisionLevel::continuous, CollisionLevel::guaranteed}) {
        tangled.params.collision = level;
        const StartCheck start = Simulation(tangled.scene, tangled.params).start_check();
        EXPECT_TRUE(start.looked);
        EXPECT_GT(start.tangled.crossing, 10u);
        EXPECT_EQ(start.tangled.touching, 0u);
        ASSERT_FALSE(start.places.empty());
        EXPECT_THAT(start.places[0], testing::AllOf(HasSubstr("sheet lower"), HasSubstr("sheet upper")));
        const std::vector<std::string> remarks = start_remarks(start, tangled.params);
        EXPECT_THAT(remarks.at(0),
                    testing::AllOf(HasSubstr("cross"), HasSubstr("--untangle"), HasSubstr(" keeps layers")));
        EXPECT_THAT(remarks.at(0), HasSubstr(param_text(*find_param(sim_param_table(), "collision"), double(level))));
    }
}

TEST(TangledStart, a_level_raised_later_looks_at_the_cloth_then)
{
    TangledScene tangled;
    tangled.params.collision = CollisionLevel::none;
    Simulation simulation(tangled.scene, tangled.params);
    EXPECT_FALSE(simulation.start_check().looked);
    tangled.params.collision = CollisionLevel::guaranteed;
    simulation.set_params(tangled.params);
    EXPECT_GT(simulation.start_check().tangled.crossing, 10u);
}

TEST(TangledStart, that_is_untangled_stays_free_of_intersections)
{
    TangledScene tangled;
    tangled.params.untangle = true;
    Simulation simulation(tangled.scene, tangled.params);
    const StartCheck& start = simulation.start_check();
    ASSERT_TRUE(start.untangling);
    EXPECT_GT(start.untangling->before.crossing, 10u);
    EXPECT_GT(start.untangling->steps, 0);
    EXPECT_GT(start.untangling->largest_move, 0);
    EXPECT_EQ(start.tangled.crossing, 0u);
    EXPECT_THAT(start_remarks(start, tangled.params).at(0), HasSubstr("untangled"));
    PoseCheck check(simulation.model(), 1, 1);
    check.look(0, simulation.state().positions);
    for (int frame = 1; frame <= 30; ++frame) {
        EXPECT_EQ(simulation.advance_frame().count.unresolved, 0u);
        for (const std::string& line : check.look(frame, simulation.state().positions)) ADD_FAILURE() << line;
    }
    simulation.restart();
    EXPECT_EQ(simulation.state().positions, Simulation(tangled.scene, tangled.params).state().positions);
}

TEST(TangledStart, of_scenes_that_are_clean_says_nothing)
{
    for (const char* name : {"gale", "stack", "fold"}) {
        const Scene scene = load_scene(name);
        SimParams params = scene.params;
        params.backend = Backend::cpu;
        params.collision = CollisionLevel::guaranteed;
        const Simulation simulation(scene, params);
        EXPECT_TRUE(simulation.start_check().looked);
        EXPECT_TRUE(start_remarks(simulation.start_check(), params).empty()) << name;
    }
}

TEST(PoseCheck, finds_intersections_and_what_passed_through_in_the_frames_asked_for)
{
    TangledScene tangled;
    const Simulation simulation(tangled.scene, tangled.params);
    const ClothModel& model = simulation.model();
    std::vector<glm::vec4> low, high;
    for (std::size_t v = 0; v < model.vertex_count(); ++v) {
        const bool is_upper = v >= model.sheets[1].first_vertex;
        const glm::vec3 x = model.rest_positions[v];
        high.emplace_back(x.x, is_upper ? 0.1f : 0.0f, x.z, 1.0f);
        low.emplace_back(x.x, is_upper ? -0.1f : 0.0f, x.z, 1.0f);
    }
    PoseCheck check(model, 2, 1);
    EXPECT_TRUE(check.wants(0) && check.wants(1) && check.wants(2));
    EXPECT_TRUE(check.look(0, high).empty());
    EXPECT_TRUE(check.look(1, high).empty());
    const std::vector<std::string> lines = check.look(2, low);
    EXPECT_EQ(check.counts().crossing, 0u);
    EXPECT_GE(check.counts().passed_through, std::uint64_t{model.sheets[1].vertex_count});
    EXPECT_EQ(check.counts().first_frame, 2);
    EXPECT_THAT(lines.at(0), testing::AllOf(HasSubstr("frame 2"), HasSubstr("went through face")));
    EXPECT_THAT(lines.back(), HasSubstr("more"));
    EXPECT_TRUE(check.look(3, high).empty());
    const std::uint64_t before = check.counts().passed_through;
    EXPECT_FALSE(check.look(4, low).empty());
    EXPECT_GT(check.counts().passed_through, before);
    EXPECT_EQ(check.counts().poses, 3u);
}

}  // namespace
}  // namespace nuno
