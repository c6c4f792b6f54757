// The session behind the window: what is refused or goes bad is told, and never ends it.
#include "app/viewer_session.h"

#include <fstream>

#include "core/error.h"
#include "gl/gl_test.h"

namespace nuno {
namespace {

ViewerScene seed_scene()
{
    Scene scene = load_scene("seed");
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    return {scene, params, {}};
}

ViewerOptions seed_options(bool paused)
{
    ViewerOptions options;
    options.start = seed_scene();
    options.paused = paused;
    options.load = [](const std::string& name) -> ViewerScene {
        if (name != "seed") throw Error("scene " + name + ": there is none");
        return seed_scene();
    };
    return options;
}

class ViewerSessionTest : public GlTest
{
  protected:
    void set(ViewerSession& session, std::string_view name, double value)
    {
        session.set_sim_param(*find_param(sim_param_table(), name), value);
    }
    ViewerLog log_{false};
};

TEST_F(ViewerSessionTest, a_change_acts_without_a_restart)
{
    ViewerSession session(seed_options(false), log_, false);
    ASSERT_EQ(session.advance(1.0 / 30).size(), 2u);
    set(session, "wind_strength", 5);
    EXPECT_EQ(session.simulation().params().wind_strength, 5);
    EXPECT_EQ(session.simulation().frame(), 2);
    EXPECT_EQ(session.start_count(), 1);
    EXPECT_EQ(session.file_params().wind_strength, load_scene("seed").params.wind_strength);
}

TEST_F(ViewerSessionTest, a_parameter_of_the_start_builds_another_cloth)
{
    ViewerSession session(seed_options(false), log_, false);
    session.advance(1.0 / 30);
    set(session, "resolution", 9);
    EXPECT_EQ(session.error(), "");
    EXPECT_EQ(session.start_count(), 2);
    EXPECT_EQ(session.simulation().frame(), 0);
    EXPECT_EQ(session.simulation().model().vertex_count(), 81u);
}

TEST_F(ViewerSessionTest, a_tangled_start_is_told_where_the_level_minds)
{
    const std::string path = testing::TempDir() + "nuno_tangled.toml";
    std::ofstream(path) << "[[sheet]]\nname = \"a\"\ncolumns = 5\n[[sheet]]\nname = \"b\"\ncolumns = 5\n"
                           "origin = [0.13, 0.0, -0.3]\nacross = [0.5, 0.0, 0.7]\n";
    ViewerOptions options = seed_options(true);
    options.quiet = true;
    options.start.scene = load_scene(path);
    options.start.params.collision = CollisionLevel::discrete;
    options.start.params.culling = Culling::sound;
    ViewerSession session(options, log_, false);
    EXPECT_EQ(session.error(), "");
    set(session, "collision", double(CollisionLevel::guaranteed));
    EXPECT_NE(session.error().find("at the start"), std::string::npos);
    EXPECT_NE(session.error().find("of sheet b goes through face"), std::string::npos) << session.error();
    session.dismiss_error();
    session.restart();
    EXPECT_EQ(session.error(), "") << "told already";
}

TEST_F(ViewerSessionTest, a_refused_value_is_told_and_the_old_one_stays)
{
    ViewerSession session(seed_options(true), log_, false);
    const int substeps = session.simulation().params().substeps;
    set(session, "substeps", -1);
    EXPECT_NE(session.error().find("substeps"), std::string::npos);
    EXPECT_EQ(session.simulation().params().substeps, substeps);
    set(session, "substeps", 30);
    EXPECT_EQ(session.error(), "") << "a good change ends the message";
}

TEST_F(ViewerSessionTest, a_scene_that_cannot_be_read_leaves_the_present_one)
{
    ViewerSession session(seed_options(false), log_, false);
    session.advance(1.0 / 30);
    session.load("nowhere");
    EXPECT_EQ(session.error(), "scene nowhere: there is none");
    EXPECT_EQ(session.simulation().frame(), 2);
    EXPECT_FALSE(session.advance(1.0 / 30).empty());
}

TEST_F(ViewerSessionTest, a_pause_holds_and_a_step_moves_by_one_frame)
{
    ViewerSession session(seed_options(true), log_, true);
    EXPECT_TRUE(session.advance(1).empty());
    EXPECT_EQ(session.step().size(), 1u);
    EXPECT_EQ(session.simulation().frame(), 1);
    session.set_paused(false);
    EXPECT_EQ(session.advance(1).size(), 4u) << "a slow machine slows the cloth down";
    EXPECT_EQ(session.simulation().frame(), 5);
}

TEST_F(ViewerSessionTest, numbers_that_go_bad_pause_it_until_a_restart)
{
    ViewerSession session(seed_options(false), log_, false);
    set(session, "method", double(Method::symplectic_euler));
    set(session, "substeps", 1);
    ASSERT_TRUE(session.stability_warning());
    for (int i = 0; i < 600 && !session.went_bad(); ++i) session.advance(1.0 / 60);
    ASSERT_TRUE(session.went_bad());
    EXPECT_TRUE(session.paused());
    EXPECT_NE(session.error().find("no longer finite"), std::string::npos);
    session.set_paused(false);
    EXPECT_TRUE(session.paused()) << "only a restart helps";
    EXPECT_TRUE(session.step().empty());
    session.use_stable_substeps();
    EXPECT_FALSE(session.went_bad());
    EXPECT_FALSE(session.paused());
    EXPECT_FALSE(session.stability_warning());
    EXPECT_EQ(session.simulation().frame(), 0);
}

}  // namespace
}  // namespace nuno
