// The session behind the window: frames looked back at, changes taken back.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>

#include "app/overlay_keys.h"
#include "app/viewer_session.h"
#include "core/error.h"
#include "gl/gl_test.h"
#include "sim/run_recorder.h"

namespace nuno {
namespace {

class ViewerChangesTest : public GlTest
{
  protected:
    static ViewerOptions options()
    {
        ViewerOptions options;
        options.start.scene = load_scene("seed");
        options.start.params = options.start.scene.params;
        options.start.params.backend = Backend::cpu;
        options.paused = true;
        return options;
    }
    void set(std::string_view name, double value)
    {
        session.set_sim_param(*find_param(sim_param_table(), name), value);
    }
    const SimParams& asked() { return session.simulation().asked_params(); }
    std::string hash() { return hash_text(session.simulation().state()); }

    ViewerLog log{false};
    ViewerSession session{options(), log, false};
};

TEST_F(ViewerChangesTest, a_frame_looked_back_at_goes_on_with_the_same_bits)
{
    for (int frame = 0; frame < 6; ++frame) session.step();
    const std::string sixth = hash();
    session.show_frame(2);
    EXPECT_EQ(session.simulation().frame(), 2);
    EXPECT_NE(hash(), sixth);
    EXPECT_EQ(session.time().frames().last_frame(), 6);
    session.step();
    EXPECT_EQ(session.time().frames().last_frame(), 3) << "the later frames are forgotten";
    for (int frame = 3; frame < 6; ++frame) session.step();
    EXPECT_EQ(hash(), sixth);
}

TEST_F(ViewerChangesTest, slow_motion_simulates_fewer_frames)
{
    session.set_paused(false);
    session.set_slowness(2);
    EXPECT_EQ(session.advance(2.0 / 60).size(), 1u);
    session.set_slowness(64);
    EXPECT_EQ(session.time().slowness(), 16);
    session.set_slowness(0);
    EXPECT_EQ(session.time().slowness(), 1);
}

TEST_F(ViewerChangesTest, a_drag_is_taken_back_and_made_again_as_one)
{
    const float before = asked().wind_strength;
    for (const double value : {3.0, 4.0, 5.0}) set("wind_strength", value);
    session.end_drag();
    session.undo();
    EXPECT_EQ(asked().wind_strength, before);
    EXPECT_FALSE(session.history().can_undo());
    session.redo();
    EXPECT_EQ(asked().wind_strength, 5);
}

TEST_F(ViewerChangesTest, each_press_of_a_key_is_a_change_of_its_own)
{
    press_overlay_key(GLFW_KEY_1, session);
    press_overlay_key(GLFW_KEY_1, session);
    EXPECT_FALSE(session.view().show_wireframe);
    session.undo();
    EXPECT_TRUE(session.view().show_wireframe);
    session.undo();
    EXPECT_FALSE(session.view().show_wireframe);
    EXPECT_FALSE(session.history().can_undo());
}

TEST_F(ViewerChangesTest, a_change_of_the_view_taken_back_is_nothing_to_the_run)
{
    session.note_error(Error("something to be read"));
    press_overlay_key(GLFW_KEY_2, session);
    session.undo();
    EXPECT_FALSE(session.view().show_springs);
    EXPECT_EQ(session.error(), "something to be read");
    session.redo();
    EXPECT_TRUE(session.view().show_springs);
}

TEST_F(ViewerChangesTest, a_preset_is_taken_back_whole)
{
    set("fabric", 1);
    session.end_drag();
    const SimParams before = asked();
    for (const Preset& preset : preset_table()) {
        session.use_preset(preset);
        if (!session.history().can_undo() || session.history().undo_name() != preset.name) continue;
        session.undo();
        EXPECT_TRUE(changes_between(sim_param_table(), &before, &asked()).empty()) << preset.name;
    }
    EXPECT_EQ(session.error(), "");
    EXPECT_TRUE(session.history().can_redo());
}

TEST_F(ViewerChangesTest, a_change_of_the_start_taken_back_starts_again)
{
    const std::size_t before = session.simulation().model().vertex_count();
    set("resolution", 9);
    ASSERT_EQ(session.simulation().model().vertex_count(), 81u);
    session.undo();
    EXPECT_EQ(session.simulation().model().vertex_count(), before);
    EXPECT_EQ(session.start_count(), 3);
}

}  // namespace
}  // namespace nuno
