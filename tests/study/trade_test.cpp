// The trade of speed against accuracy: errors, fronts, and the study of a small scene from end to end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "study/grid_poses.h"
#include "study/trade_points.h"
#include "study/trade_report.h"
#include "study/trade_results.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

Trajectory trajectory_of(const std::vector<std::vector<glm::vec3>>& positions, const std::vector<double>& energies)
{
    Trajectory run;
    run.positions = positions;
    run.mechanical_j = energies;
    run.kinetic_j.assign(energies.size(), 0);
    return run;
}

TEST(Trade, the_error_is_the_root_mean_square_distance_of_all_vertices_and_frames)
{
    const glm::vec3 o(0), x(1, 0, 0);
    const Trajectory reference = trajectory_of({{o, o}, {o, o}, {o, o}}, {4, 2, 0});
    const Trajectory run = trajectory_of({{x, x}, {x, o}, {2.0f * x, o}}, {4, 3, 0});
    const TrajectoryError error = error_against(run, reference, 2);  // the start does not count
    EXPECT_DOUBLE_EQ(error.rms_m, std::sqrt(5.0 / 4));
    EXPECT_DOUBLE_EQ(error.largest_m, 2);
    EXPECT_DOUBLE_EQ(error.energy_share, 0.25);
}

// A bilinear pose is the same on every grid; one shifted by d is d away on each.
TEST(Trade, poses_of_grids_are_compared_at_the_same_places_of_the_cloth)
{
    const auto sheet_of = [](int columns, int rows) {
        SheetSource sheet;
        sheet.columns = columns;
        sheet.rows = rows;
        sheet.mesh.positions.resize(std::size_t(columns) * std::size_t(rows));
        return sheet;
    };
    const auto pose_of = [](int columns, int rows, float shift) {
        std::vector<glm::vec3> pose;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const float u = float(i) / float(columns - 1), v = float(j) / float(rows - 1);
                pose.emplace_back(2 * u + u * v, v - u, 3 * u * v + shift);
            }
        return pose;
    };
    const SheetSource coarse = sheet_of(5, 4), fine = sheet_of(12, 9);
    const Trajectory a = trajectory_of({{}, pose_of(5, 4, 0)}, {0, 0}),
                     b = trajectory_of({{}, pose_of(12, 9, 0)}, {0, 0}),
                     c = trajectory_of({{}, pose_of(12, 9, 0.25f)}, {0, 0});
    EXPECT_NEAR(rms_of_grids({&coarse, 1}, a, {&fine, 1}, b, 1), 0, 1e-6);
    EXPECT_NEAR(rms_of_grids({&coarse, 1}, a, {&fine, 1}, c, 1), 0.25, 1e-6);
}

TradePoint point_of(double ms, double error)
{
    TradePoint point;
    point.ms_per_second = ms;
    point.error_share = error;
    point.is_measured = true;
    return point;
}

TEST(Trade, the_front_is_what_nothing_beats_in_both_cost_and_error)
{
    std::vector<TradePoint> points{point_of(4, 0.1), point_of(1, 0.5), point_of(2, 0.2), point_of(3, 0.3),
                                   point_of(4, 0.2)};
    points.push_back(point_of(0.5, 0.01));
    points.back().is_measured = false;  // it went bad
    mark_front(points);
    std::vector<bool> on_front;
    for (const TradePoint& point : points) on_front.push_back(point.is_on_front);
    EXPECT_THAT(on_front, testing::ElementsAre(true, true, true, false, false, false));
}

TEST(Trade, the_pick_is_the_cheapest_that_keeps_the_error)
{
    TradeScene scene;
    scene.time = {point_of(4, 0.1), point_of(1, 0.5), point_of(2, 0.2)};
    EXPECT_EQ(scene.pick(0.2), &scene.time[2]);
    EXPECT_EQ(scene.pick(0.15), &scene.time[0]);
    EXPECT_EQ(scene.pick(0.01), nullptr);
}

// The seed on a coarse grid: every kind of point, and what must hold of errors that converge.
class SeedTrade : public testing::Test
{
  protected:
    static void SetUpTestSuite()
    {
        Scene scene = load_scene("seed");
        SimParams params = scene.params;
        params.resolution = 9;
        params.threads = 1;
        scene.check.frames = 20;
        study_ = new SceneStudy(std::move(scene), params);
        TradeOptions options;
        options.repeats = 1;
        options.ensemble = 2;
        results_ = new std::map<std::string, Json>;
        for (const SweepPoint& point : trade_points(*study_, options)) (*results_)[point.id] = point.measure();
        scene_ = new TradeScene(trade_scenes(*results_).at(0));
    }
    static void TearDownTestSuite()
    {
        delete scene_;
        delete results_;
        delete study_;
    }
    // Errors of a curve, by rising substeps.
    static std::vector<double> errors_of(const std::string& variant)
    {
        std::vector<double> errors;
        for (const TradePoint& point : scene_->time)
            if (point.variant == variant && point.is_measured) errors.push_back(point.error_share);
        return errors;
    }

    static SceneStudy* study_;
    static std::map<std::string, Json>* results_;
    static TradeScene* scene_;
};
SceneStudy* SeedTrade::study_ = nullptr;
std::map<std::string, Json>* SeedTrade::results_ = nullptr;
TradeScene* SeedTrade::scene_ = nullptr;

TEST_F(SeedTrade, the_reference_is_converged_and_the_horizon_is_told)
{
    const SceneClass& found = study_->scene_class();
    EXPECT_NEAR(found.size_m, 1.0, 1e-6);
    EXPECT_EQ(found.particles, 81u);
    EXPECT_GE(found.frames, 12);
    EXPECT_LT(found.reference_error_m, 1e-5);
    EXPECT_EQ(study_->params().collision, CollisionLevel::none) << "layers do not meet so early";
    EXPECT_EQ(study_->asked_params().collision, CollisionLevel::discrete);
}

TEST_F(SeedTrade, errors_fall_as_substeps_rise)
{
    for (const char* variant : {"symplectic_euler", "verlet", "implicit_euler", "sdirk2", "xpbd, tethers none"}) {
        const std::vector<double> errors = errors_of(variant);
        ASSERT_GE(errors.size(), 4u) << variant;
        EXPECT_LT(errors.back(), 0.3 * errors.front()) << variant;
    }
    // Tethers are no physics: they forbid what the springs allow, and no number of substeps mends that.
    const std::vector<double> tethered = errors_of("xpbd");
    EXPECT_GT(tethered.back(), 10 * errors_of("xpbd, tethers none").back());
}

TEST_F(SeedTrade, every_kind_of_point_is_measured)
{
    EXPECT_FALSE(scene_->scene_class.is_null());
    EXPECT_EQ(scene_->others.at("level").size(), choice_names(CollisionLevel{}).size());
    EXPECT_EQ(scene_->others.at("threads").size(), 2u);
    EXPECT_GE(scene_->others.at("long").size(), 6u);
    for (const auto& [kind, results] : scene_->others)
        for (const Json& result : results) EXPECT_FALSE(result.contains("failure")) << kind << " " << result.dump();
    for (const TradePoint& point : scene_->time)
        EXPECT_TRUE(point.is_measured || !point.failure.empty()) << setting_text(point.set);
}

TEST_F(SeedTrade, the_page_needs_nothing_beside_it)
{
    const TemporaryDirectory directory;
    const bool drawn = plot_trade(*scene_, directory.path());
    const std::string page =
        trade_page({*scene_}, {{{"version", "1"}, {"machine", Json::object()}}, 9, {}}, directory.path());
    EXPECT_EQ(drawn, page.find("<svg") != page.npos);
    for (const char* part : {"What to pick", "symplectic_euler", "Self-collision"})
        EXPECT_NE(page.find(part), page.npos) << part;
    for (const char* outside : {"src=", "href=\"", "url("}) EXPECT_EQ(page.find(outside), page.npos) << outside;
    const std::string csv = trade_csv({*scene_});
    EXPECT_EQ(std::size_t(std::count(csv.begin(), csv.end(), '\n')), scene_->time.size() + 1);
}

}  // namespace
}  // namespace nuno
