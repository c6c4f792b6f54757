// What overlays say of a run: what is known of it, in the right place; and looking changes nothing.
#include "app/overlays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/overlay_heat.h"
#include "app/overlay_marks.h"
#include "model/wind_field.h"
#include "sim/run_recorder.h"
#include "support/sheets.h"

namespace nuno {
namespace {

Simulation simulation_of(const std::string& name, CollisionLevel level)
{
    const Scene scene = load_scene(name);
    SimParams params = scene.params;
    params.backend = Backend::cpu;
    params.collision = level;
    params.culling = Culling::sound;
    return Simulation(scene, params);
}

ViewParams all_overlays(Heat heat)
{
    ViewParams view;
    view.heat = heat;
    view.show_wireframe = view.show_springs = view.show_pins = view.show_contacts = view.show_boxes = view.show_wind =
        1;
    return view;
}

TEST(Overlays, nothing_asked_is_nothing_gathered_also_after_something_was)
{
    Simulation simulation = simulation_of("seed", CollisionLevel::discrete);
    Overlays overlays;
    EXPECT_EQ(overlays.gather({}, simulation), nullptr);
    EXPECT_TRUE(overlays.legend().empty());
    ASSERT_NE(overlays.gather(all_overlays(Heat::strain), simulation), nullptr);
    EXPECT_FALSE(overlays.legend().empty());
    EXPECT_EQ(overlays.gather({}, simulation), nullptr);
    EXPECT_TRUE(overlays.legend().empty());
}

TEST(Overlays, a_run_has_the_same_bits_whether_it_is_looked_at_or_not)
{
    for (const CollisionLevel level : {CollisionLevel::discrete, CollisionLevel::guaranteed}) {
        Simulation alone = simulation_of("seed", level), watched = simulation_of("seed", level);
        Overlays overlays;
        for (int frame = 0; frame < 40; ++frame) {
            alone.advance_frame();
            watched.advance_frame();
            for (const Heat heat : {Heat::strain, Heat::speed, Heat::culled, Heat::asleep})
                ASSERT_NE(overlays.gather(all_overlays(heat), watched), nullptr);
        }
        EXPECT_EQ(hash_text(alone.state()), hash_text(watched.state()));
    }
}

TEST(Overlays, strain_is_that_of_the_pulled_threads_and_nowhere_else)
{
    const ClothModel cloth = square_cloth(5, 1);
    std::vector<glm::vec4> positions;
    for (const glm::vec3& rest : cloth.rest_positions) positions.emplace_back(rest, 1);
    for (const float strain : thread_strains(cloth, positions)) EXPECT_NEAR(strain, 0, 1e-5);
    // The right column goes a tenth of a cell further right.
    const float right =
        std::max_element(positions.begin(), positions.end(), [](auto& a, auto& b) { return a.x < b.x; })->x;
    for (glm::vec4& p : positions)
        if (p.x > right - 1e-4f) p.x += 0.025f;
    const std::vector<float> strains = thread_strains(cloth, positions);
    for (std::size_t v = 0; v < positions.size(); ++v)
        EXPECT_NEAR(strains[v], positions[v].x > 0.7f ? 0.1f : 0.0f, 1e-4) << "at x = " << positions[v].x;
}

TEST(Overlays, the_bar_of_strain_is_in_percent_and_its_largest_is_that_of_the_report)
{
    Simulation simulation = simulation_of("seed", CollisionLevel::none);
    for (int frame = 0; frame < 20; ++frame) simulation.advance_frame();
    Overlays overlays;
    ViewParams view;
    view.heat = Heat::strain;
    const Overlay* overlay = overlays.gather(view, simulation);
    ASSERT_TRUE(overlay && overlays.legend().scale);
    const LegendScale scale = *overlays.legend().scale;
    const double largest = 100 * simulation.diagnostics().max_strain;
    EXPECT_NEAR(scale.largest, largest, 1e-3 * largest);
    EXPECT_EQ(overlay->heat.values.size(), simulation.model().vertex_count());
    view.strain_top = 50;
    overlay = overlays.gather(view, simulation);
    EXPECT_EQ(overlays.legend().scale->top, 50);
    const auto& values = overlay->heat.values;
    EXPECT_NEAR(double(*std::max_element(values.begin(), values.end())), largest / 50, 1e-4);
}

TEST(Overlays, the_top_of_a_bar_is_the_next_of_1_2_5_10)
{
    EXPECT_DOUBLE_EQ(round_top(0, 0.1), 0.1);
    EXPECT_DOUBLE_EQ(round_top(1, 0.1), 1);
    EXPECT_DOUBLE_EQ(round_top(1.1, 0.1), 2);
    EXPECT_DOUBLE_EQ(round_top(37, 0.1), 50);
    EXPECT_DOUBLE_EQ(round_top(0.7, 0.1), 1);
}

TEST(Overlays, boxes_of_every_depth_hold_every_vertex_and_there_are_more_further_down)
{
    Simulation simulation = simulation_of("seed", CollisionLevel::discrete);
    for (int frame = 0; frame < 30; ++frame) simulation.advance_frame();
    TreePicture tree(simulation.model());
    ASSERT_GE(tree.depth(), 2);
    std::size_t before = 0;
    for (int depth = 0; depth <= tree.depth(); ++depth) {
        const std::vector<FaceBox> boxes = tree.boxes(simulation.state().positions, 0.01f, depth);
        EXPECT_GT(boxes.size(), before);
        before = boxes.size();
        for (const glm::vec4& p : simulation.state().positions)
            EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(),
                                    [&](const FaceBox& box) {
                                        return box.overlaps({glm::vec3(p), glm::vec3(p)});
                                    }))
                << "depth " << depth;
    }
    ViewParams view;
    view.show_boxes = 1;
    view.box_depth = 0;
    Overlays overlays;
    EXPECT_EQ(overlays.gather(view, simulation)->through.size(), 12u) << "the edges of one box";
}

TEST(Overlays, flat_cloth_is_culled_whole_and_cloth_without_a_tree_keeps_its_look)
{
    ViewParams view;
    view.heat = Heat::culled;
    Overlays overlays;
    Simulation flat = simulation_of("seed", CollisionLevel::discrete);
    const ClothHeat& heat = overlays.gather(view, flat)->heat;
    EXPECT_TRUE(heat.is_of_faces);
    EXPECT_EQ(heat.values, std::vector<float>(flat.model().faces.size(), 1.0f));
    Simulation without = simulation_of("seed", CollisionLevel::none);
    Overlays others;
    EXPECT_TRUE(others.gather(view, without)->heat.values.empty());
    EXPECT_FALSE(others.legend().remarks.empty());
}

// Of folded cloth some is left out and some is looked at; what is proven apart has no contact in its smallest patch.
TEST(Overlays, folded_cloth_is_culled_in_patches)
{
    Simulation simulation = simulation_of("drape", CollisionLevel::discrete);
    for (int frame = 0; frame < 60; ++frame) simulation.advance_frame();
    ViewParams view;
    view.heat = Heat::culled;
    Overlays overlays;
    const std::vector<float>& values = overlays.gather(view, simulation)->heat.values;
    const auto looked_at = static_cast<std::size_t>(std::count(values.begin(), values.end(), 0.0f));
    EXPECT_GT(looked_at, values.size() / 20);
    EXPECT_LT(looked_at, values.size() - values.size() / 20);
}

TEST(Overlays, contacts_and_impacts_are_marked_where_layers_meet)
{
    Simulation simulation = simulation_of("twist", CollisionLevel::guaranteed);
    ViewParams view;
    view.show_contacts = 1;
    Overlays overlays;
    FrameStats stats;
    std::size_t contacts = 0;
    while (simulation.frame() < 40 && stats.count.impacts == 0) {
        stats = simulation.advance_frame();
        contacts = std::max(contacts, simulation.last_pass().foreseen.size());
    }
    ASSERT_GT(stats.count.impacts, 0u) << "the scene has none; take another";
    ASSERT_GT(contacts, 0u);
    const LastPass pass = simulation.last_pass();
    const std::vector<Mark> marks = overlays.gather(view, simulation)->through;
    EXPECT_GE(marks.size(), 3 * pass.foreseen.size());
    EXPECT_LE(marks.size(), 3 * (pass.foreseen.size() + pass.impacts.size()));
    const std::vector<glm::vec4>& x = simulation.state().positions;
    for (std::size_t i = 0; i < pass.foreseen.size(); ++i) {
        const glm::uvec4& v = pass.foreseen[i].vertices;
        glm::vec3 low(x[v.x]), high = low;
        for (int k = 1; k < 4; ++k) {
            low = glm::min(low, glm::vec3(x[v[k]]));
            high = glm::max(high, glm::vec3(x[v[k]]));
        }
        const glm::vec3 place = marks[3 * i + 1].from;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(place[axis], low[axis] - 1e-5f) << i;
            EXPECT_LE(place[axis], high[axis] + 1e-5f) << i;
        }
        const glm::vec3 normal = glm::normalize(marks[3 * i].to - marks[3 * i].from);
        EXPECT_GT(glm::dot(normal, pass.foreseen[i].normal), 0.999f);
    }
}

TEST(Overlays, contacts_of_a_former_start_are_not_shown)
{
    Simulation simulation = simulation_of("seed", CollisionLevel::discrete);
    for (int frame = 0; frame < 200 && simulation.last_pass().contacts.empty(); ++frame) simulation.advance_frame();
    ASSERT_FALSE(simulation.last_pass().contacts.empty());
    simulation.restart();
    EXPECT_TRUE(simulation.last_pass().contacts.empty());
    EXPECT_EQ(simulation.last_pass().level, CollisionLevel::none);
}

TEST(Overlays, wind_arrows_point_along_the_moving_air)
{
    Simulation simulation = simulation_of("seed", CollisionLevel::none);
    SimParams params = simulation.params();
    params.wind_model = WindModel::aero;
    params.wind_x = 3;
    params.gust_speed = 2;
    Overlay overlay;
    OverlayLegend legend;
    mark_wind(params, 0.4, simulation.state().positions, {overlay, legend});
    ASSERT_GT(overlay.through.size(), 2 * 8u);
    const AirField field = air_field(params, 0.4);
    for (std::size_t i = 0; i + 1 < overlay.through.size(); i += 2) {
        const glm::vec3 from = overlay.through[i].from, to = overlay.through[i + 1].to;
        const glm::vec3 air(air_velocity(field, glm::dvec3(0.5f * (from + to))));
        EXPECT_GT(glm::dot(glm::normalize(to - from), glm::normalize(air)), 0.999f);
        EXPECT_EQ(overlay.through[i + 1].to_width, 0) << "the tip";
    }
    params.wind_model = WindModel::sines;
    params.wind_strength = params.wind_mean = 0;
    Overlay still;
    mark_wind(params, 0.4, simulation.state().positions, {still, legend});
    EXPECT_TRUE(still.through.empty());
}

TEST(Overlays, springs_and_pins_and_edges_are_those_of_the_model)
{
    Simulation simulation = simulation_of("seed", CollisionLevel::none);
    const ClothModel& model = simulation.model();
    Overlays overlays;
    ViewParams view;
    view.show_springs = 1;
    EXPECT_EQ(overlays.gather(view, simulation)->on_cloth.size(), model.springs.size());
    EXPECT_EQ(overlays.legend().rows.size(), 3u);
    view = {};
    view.show_wireframe = 1;
    // Of 17 x 17 vertices: 2 x 16 x 17 sides and 16 x 16 diagonals.
    EXPECT_EQ(overlays.gather(view, simulation)->on_cloth.size(), 2u * 16 * 17 + 16 * 16);
    view = {};
    view.show_pins = 1;
    const auto pins = std::count(model.pinned.begin(), model.pinned.end(), std::uint8_t{1});
    EXPECT_EQ(overlays.gather(view, simulation)->through.size(), 2 * std::size_t(pins)) << "a dot and its rim each";
}

TEST(Overlays, sleep_is_told_of_the_whole_cloth)
{
    Simulation simulation = simulation_of("hang", CollisionLevel::none);
    SimParams params = simulation.asked_params();
    params.sleep_motion = 1;
    params.wind_strength = 0;
    params.gust_speed = 0;
    simulation.set_params(params);
    ViewParams view;
    view.heat = Heat::asleep;
    Overlays overlays;
    const std::vector<float> awake = overlays.gather(view, simulation)->heat.values;
    for (int frame = 0; frame < 60 && !simulation.is_asleep(); ++frame) simulation.advance_frame();
    ASSERT_TRUE(simulation.is_asleep());
    const std::vector<float> asleep = overlays.gather(view, simulation)->heat.values;
    ASSERT_EQ(awake.size(), asleep.size());
    EXPECT_EQ(std::vector<float>(asleep.size(), asleep.front()), asleep);
    EXPECT_GT(asleep.front(), awake.front());
}

}  // namespace
}  // namespace nuno
