// The last seconds of a run can be looked at and gone on from.
#include "sim/rewind.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/run_recorder.h"
#include "sim/saved_run.h"

namespace nuno {
namespace {

class RewindTest : public testing::Test
{
  protected:
    // Frames from the present one on, each kept; what each was.
    void run(Rewind& rewind, int count)
    {
        for (int frame = 0; frame < count; ++frame) {
            simulation.advance_frame();
            rewind.keep(simulation);
            hashes.resize(static_cast<std::size_t>(simulation.frame()) + 1);
            hashes.back() = hash_text(simulation.state());
        }
    }

    Scene scene = SavedSceneFolder().scene();
    Simulation simulation{scene, scene.params};
    std::vector<std::string> hashes;
};

TEST_F(RewindTest, a_frame_shown_is_the_frame_that_was_and_the_others_stay)
{
    Rewind rewind;
    rewind.keep(simulation);
    run(rewind, 12);
    const std::vector<std::string> was = hashes;
    for (const int frame : {3, 11, 7, 12}) {
        rewind.show(simulation, frame);
        EXPECT_EQ(hash_text(simulation.state()), was[static_cast<std::size_t>(frame)]);
        EXPECT_EQ(simulation.frame(), frame);
    }
    EXPECT_EQ(rewind.first_frame(), 0);
    EXPECT_EQ(rewind.last_frame(), 12);
}

TEST_F(RewindTest, a_run_gone_on_from_a_frame_has_the_same_bits_as_the_first_time)
{
    Rewind rewind;
    run(rewind, 30);
    const std::vector<std::string> was = hashes;
    rewind.resume(simulation, 22);
    EXPECT_EQ(rewind.last_frame(), 22);
    run(rewind, 8);
    EXPECT_EQ(hashes, was);
    EXPECT_EQ(rewind.last_frame(), 30);
}

TEST_F(RewindTest, memory_and_time_are_bounded_and_the_newest_frame_stays)
{
    Rewind by_time({.bytes = std::size_t(1) << 30, .seconds = 0.105}), by_size({.bytes = 100000, .seconds = 1e9}),
        tiny({.bytes = 1, .seconds = 1e9});
    for (int frame = 0; frame < 40; ++frame) {
        simulation.advance_frame();
        for (Rewind* rewind : {&by_time, &by_size, &tiny}) rewind->keep(simulation);
    }
    EXPECT_EQ(by_time.frame_count(), 7u);
    EXPECT_LE(by_size.size_bytes(), 100000u);
    EXPECT_GT(by_size.frame_count(), 1u);
    EXPECT_EQ(tiny.frame_count(), 1u);
    EXPECT_EQ(tiny.last_frame(), 40);
}

TEST_F(RewindTest, a_restart_and_another_cloth_begin_anew)
{
    Rewind rewind;
    run(rewind, 5);
    simulation.restart();
    rewind.keep(simulation);
    EXPECT_EQ(rewind.frame_count(), 1u);
    run(rewind, 1);
    SimParams params = simulation.asked_params();
    params.resolution = 6;
    simulation.set_params(params);
    run(rewind, 2);
    EXPECT_EQ(rewind.first_frame(), 1);
    EXPECT_EQ(rewind.last_frame(), 2);
    rewind.clear();
    EXPECT_TRUE(rewind.empty());
    EXPECT_EQ(rewind.size_bytes(), 0u);
}

}  // namespace
}  // namespace nuno
