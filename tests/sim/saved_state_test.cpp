// A run that was saved goes on with the same bits as the one that never stopped, on the CPU.
#include "sim/saved_state.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <tuple>

#include "core/error.h"
#include "core/hash.h"
#include "model/oscillator.h"
#include "sim/rewind.h"
#include "sim/run_recorder.h"
#include "sim/saved_run.h"

namespace nuno {
namespace {

Scene ball_scene() { return SavedSceneFolder().scene(); }

// Runs, saves half-way by a file, and goes on in both; the contacts in the frames after.
std::uint64_t expect_same_bits(const Scene& scene, const SimParams& params)
{
    const TemporaryDirectory folder;
    const std::filesystem::path file = folder.path() / "half.state";
    Simulation whole(scene, params), never_saved(scene, params), resumed(scene, params);
    advance_frames(whole, 24);
    advance_frames(never_saved, 24);
    write_state(file, whole.save());
    const SavedState saved = read_state(file, params, whole.model().vertex_count());
    resumed.resume(saved);
    EXPECT_EQ(hash_text(resumed.state()), hash_text(whole.state()));
    EXPECT_EQ(resumed.frame(), 24);
    EXPECT_EQ(resumed.time_s(), whole.time_s());
    std::uint64_t contacts = 0;
    for (int frame = 0; frame < 8; ++frame) {
        contacts += whole.advance_frame().count.contacts;
        resumed.advance_frame();
        never_saved.advance_frame();
        EXPECT_EQ(hash_text(resumed.state()), hash_text(whole.state())) << "frame " << frame;
        EXPECT_EQ(hash_text(never_saved.state()), hash_text(whole.state())) << "saving changes nothing";
    }
    return contacts;
}

class SavedMethod : public testing::TestWithParam<std::tuple<Method, Sweep, Tethers>>
{};

TEST_P(SavedMethod, goes_on_with_the_same_bits)
{
    const auto [method, sweep, tethers] = GetParam();
    Scene scene = ball_scene();
    if (tethers == Tethers::contacts) scene.bodies.spheres[0].motion = {};  // bodies must stand still
    SimParams params = scene.params;
    if (method == Method::explicit_euler) {  // which only drag keeps stable
        params.damping = 30;
        params.substeps = 300;
    }
    params.method = method;
    params.sweep = sweep;
    params.tethers = tethers;
    if (!is_explicit(method) && method != Method::reference) params.substeps = 8;
    const std::uint64_t contacts = expect_same_bits(scene, params);
    EXPECT_TRUE(contacts > 0 || method == Method::explicit_euler) << "layers meet in the frames compared";
}

INSTANTIATE_TEST_SUITE_P(Methods, SavedMethod,
                         testing::Values(std::tuple(Method::explicit_euler, Sweep::automatic, Tethers::automatic),
                                         std::tuple(Method::symplectic_euler, Sweep::automatic, Tethers::automatic),
                                         std::tuple(Method::verlet, Sweep::automatic, Tethers::automatic),
                                         std::tuple(Method::rk4, Sweep::automatic, Tethers::automatic),
                                         std::tuple(Method::xpbd, Sweep::rows, Tethers::pins),
                                         std::tuple(Method::xpbd, Sweep::rows, Tethers::contacts),
                                         std::tuple(Method::xpbd, Sweep::coloured, Tethers::pins),
                                         std::tuple(Method::xpbd, Sweep::jacobi, Tethers::pins),
                                         std::tuple(Method::vbd, Sweep::automatic, Tethers::pins),
                                         std::tuple(Method::implicit_euler, Sweep::automatic, Tethers::automatic),
                                         std::tuple(Method::sdirk2, Sweep::automatic, Tethers::automatic),
                                         std::tuple(Method::reference, Sweep::automatic, Tethers::automatic)));

class SavedLevel : public testing::TestWithParam<std::tuple<CollisionLevel, Method>>
{};

TEST_P(SavedLevel, goes_on_with_the_same_bits)
{
    const auto [level, method] = GetParam();
    const Scene scene = ball_scene();
    SimParams params = scene.params;
    params.collision = level;
    params.method = method;
    params.substeps = method == Method::xpbd ? 8 : 0;
    params.count_pass_through = level == CollisionLevel::discrete;
    const std::uint64_t contacts = expect_same_bits(scene, params);
    EXPECT_EQ(contacts > 0, level != CollisionLevel::none);
}

INSTANTIATE_TEST_SUITE_P(Levels, SavedLevel,
                         testing::Combine(testing::Values(CollisionLevel::none, CollisionLevel::spheres,
                                                          CollisionLevel::discrete, CollisionLevel::speculative,
                                                          CollisionLevel::continuous, CollisionLevel::guaranteed),
                                          testing::Values(Method::xpbd, Method::verlet)));

// A sheet with a hole, so that it is no grid.
std::string holed_mesh()
{
    constexpr int side = 7;
    std::string text;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) text += fmt::format("v {} 0.3 {}\n", 0.08 * i - 0.24, 0.08 * j - 0.24);
    for (int j = 0; j + 1 < side; ++j)
        for (int i = 0; i + 1 < side; ++i) {
            const int a = j * side + i + 1, b = a + 1, c = a + side, d = c + 1;
            text += fmt::format("f {} {} {}\n", a, c, d);
            if (i != 3 || j != 3) text += fmt::format("f {} {} {}\n", a, d, b);
        }
    return text;
}

TEST(SavedState, a_cloth_that_is_no_grid_goes_on_with_the_same_bits)
{
    const TemporaryDirectory folder;
    Scene scene = ball_scene();
    scene.sheets.pop_back();
    scene.sheets[0] = {
        .name = "holed", .where = "test", .mesh = folder.write("holed.obj", holed_mesh()), .pins = {}, .texture = {}};
    for (const Method method : {Method::xpbd, Method::vbd, Method::sdirk2}) {
        SimParams params = scene.params;
        params.method = method;
        params.substeps = 8;
        Simulation simulation(scene, params);
        ASSERT_FALSE(simulation.model().sheets[0].is_grid());
        expect_same_bits(scene, params);
    }
}

TEST(SavedState, a_membrane_whose_substeps_follow_its_stretch_goes_on_with_the_same_bits)
{
    const Scene scene = ball_scene();
    SimParams params = scene.params;
    params.internal_model = InternalModel::continuum;
    params.method = Method::verlet;
    params.wind_model = WindModel::aero;
    params.wind_z = 5;
    params.gust_speed = 2;
    expect_same_bits(scene, params);
}

TEST(SavedState, without_what_the_method_keeps_the_bits_are_others)
{
    const Scene scene = ball_scene();
    SimParams params = scene.params;
    params.method = Method::xpbd;
    params.substeps = 8;
    Simulation whole(scene, params), resumed(scene, params);
    advance_frames(whole, 24);
    SavedState saved = whole.save();
    saved.past_kind = "another program";
    resumed.resume(saved);
    advance_frames(whole, 8);
    advance_frames(resumed, 8);
    EXPECT_NE(hash_text(resumed.state()), hash_text(whole.state()));
}

TEST(SavedState, a_vertex_in_hand_is_saved_as_let_go)
{
    const Scene scene = ball_scene();
    Simulation simulation(scene, scene.params), other(scene, scene.params);
    simulation.hold_vertex(40, {0, 1, 0});
    simulation.advance_frame();
    ASSERT_EQ(simulation.state().positions[40].w, 0);
    other.resume(simulation.save());
    EXPECT_GT(other.state().positions[40].w, 0);
    EXPECT_EQ(simulation.state().positions[40].w, 0);
}

TEST(SavedState, takes_the_masses_of_the_present_density_and_another_method)
{
    const Scene scene = ball_scene();
    Simulation simulation(scene, scene.params);
    advance_frames(simulation, 3);
    SimParams params = scene.params;
    params.areal_density *= 2;
    params.method = Method::vbd;
    Simulation other(scene, params);
    other.resume(simulation.save());
    EXPECT_FLOAT_EQ(other.state().positions[40].w, simulation.state().positions[40].w / 2);
    EXPECT_GT(other.advance_frame().substeps, 0);
}

std::string error_of(const std::filesystem::path& file, std::string_view bytes)
{
    write_whole(file, bytes);
    try {
        read_state(file, {}, 145);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "none";
}

TEST(SavedState, a_bad_file_is_told_by_its_name_and_what_is_wrong)
{
    const TemporaryDirectory folder;
    const std::filesystem::path file = folder.path() / "a.state";
    const Scene scene = ball_scene();
    Simulation simulation(scene, scene.params);
    ASSERT_EQ(simulation.model().vertex_count(), 145u);
    write_state(file, simulation.save());
    const std::string good = read_text(file);
    EXPECT_EQ(error_of(file, good), "none");
    const auto has = [&](const std::string& text, std::string_view bytes) {
        const std::string error = error_of(file, bytes);
        EXPECT_NE(error.find(file.string()), std::string::npos) << error;
        EXPECT_NE(error.find(text), std::string::npos) << error;
    };
    has("is no state", "");
    has("is no state", "v 0 0 0\n");
    for (const std::size_t size : {std::size_t(12), std::size_t(20), good.size() / 2, good.size() - 1})
        has("is cut short", std::string_view(good).substr(0, size));
    has("was changed", good + "x");
    std::string flipped = good;
    flipped[good.size() / 3] ^= 1;
    has("was changed", flipped);
    std::string newer = good;
    newer[11] = 3;
    has("newer nuno", newer);
    SavedState lost = simulation.save();
    lost.cloth.velocities[7].y = std::nanf("");
    write_state(file, lost);
    has("vertex 7", read_text(file));
    SavedState away = simulation.save();
    away.shifts = {{.to = {0, 2e6, 0}}};
    write_state(file, away);
    has("a place of a body", read_text(file));
    write_state(file, simulation.save());
    EXPECT_THROW(read_state(file, {}, 144), Error);
    std::filesystem::remove(file);
    EXPECT_THROW(read_state(file, {}, 145), Error);
}

// Format 1 ended before the list of shifts, which is empty here: 8 bytes of its length.
TEST(SavedState, a_file_of_the_format_before_bodies_could_be_moved_is_read)
{
    const TemporaryDirectory folder;
    const std::filesystem::path file = folder.path() / "a.state";
    const Scene scene = ball_scene();
    Simulation simulation(scene, scene.params);
    simulation.advance_frame();
    write_state(file, simulation.save());
    std::string text = read_text(file);
    text.resize(text.size() - 8);
    constexpr std::size_t format_at = 11, hash_at = format_at + 4, body_at = hash_at + 8;
    text[format_at] = 1;
    Fnv1a hash;
    hash.add(text.data() + body_at, text.size() - body_at);
    const std::uint64_t value = hash.value();
    std::memcpy(text.data() + hash_at, &value, sizeof value);
    write_whole(file, std::string_view(text));
    const SavedState read = read_state(file, scene.params, 145);
    EXPECT_EQ(read.frame, 1);
    EXPECT_TRUE(read.shifts.empty());
    EXPECT_EQ(read.past, simulation.save().past);
}

TEST(SavedState, of_a_scene_with_other_bodies_is_refused)
{
    const Scene scene = ball_scene();
    Simulation simulation(scene, scene.params);
    SavedState saved = simulation.save();
    saved.shifts.resize(7);
    EXPECT_THROW(simulation.resume(saved), Error);
}

}  // namespace
}  // namespace nuno
