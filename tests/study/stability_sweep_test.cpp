// A stability sweep on disk: it resumes, falls into parts, and does not depend on threads; and its report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "core/files.h"
#include "study/stability_report.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto kGoOn = [](std::size_t, std::size_t) { return true; };

StabilityScene small_scene()
{
    static const Scene seed = load_scene("seed");
    SimParams params = seed.params;
    params.resolution = 3;
    params.method = Method::symplectic_euler;
    StabilityScene scene;
    scene.maps = std::make_unique<StabilityMaps>(seed, params, MapSize{2, 2});
    return scene;
}

Json header() { return {{"study", "stability"}}; }

std::string sweep(const StabilityScene& scene, const fs::path& directory, Shard shard, int threads)
{
    PointStore store(directory, header());
    ThreadPool pool(threads);
    EXPECT_TRUE(run_sweep(scene.maps->points(), shard, store, pool, kGoOn));
    return read_text(directory / "points.jsonl");
}

TEST(StabilitySweep, the_file_is_the_same_with_any_number_of_threads)
{
    const StabilityScene scene = small_scene();
    const TemporaryDirectory one, three;
    EXPECT_EQ(sweep(scene, one.path(), {}, 1), sweep(scene, three.path(), {}, 3));
}

TEST(StabilitySweep, half_of_the_lines_lost_and_half_a_line_are_measured_anew_to_the_same_results)
{
    const StabilityScene scene = small_scene();
    const TemporaryDirectory directory;
    sweep(scene, directory.path(), {}, 2);
    const auto whole = read_points(directory.path()).results;
    const std::string text = read_text(directory.path() / "points.jsonl");
    write_whole(directory.path() / "points.jsonl", text.substr(0, text.size() / 2));
    const StoredPoints half = read_points(directory.path());
    EXPECT_TRUE(half.ends_in_half_a_line);
    EXPECT_LT(half.results.size(), whole.size());
    sweep(scene, directory.path(), {}, 2);
    EXPECT_EQ(read_points(directory.path()).results, whole);
}

TEST(StabilitySweep, parts_join_to_the_whole)
{
    const StabilityScene scene = small_scene();
    const TemporaryDirectory whole, first, second;
    sweep(scene, whole.path(), {}, 2);
    sweep(scene, first.path(), {1, 2}, 2);
    sweep(scene, second.path(), {2, 2}, 2);
    const StoredPoints all = joined_points({first.path(), second.path()});
    EXPECT_EQ(all.results, read_points(whole.path()).results);
}

TEST(StabilitySweep, the_report_tells_what_was_measured_and_what_is_missing)
{
    StabilityScene scene = small_scene();
    const TemporaryDirectory directory;
    sweep(scene, directory.path(), {1, 2}, 2);
    scene.results = read_points(directory.path()).results;
    std::vector<StabilityScene> scenes;
    scenes.push_back(std::move(scene));
    const std::string csv = stability_csv(scenes);
    const auto cells = std::count_if(scenes[0].results.begin(), scenes[0].results.end(),
                                     [](const auto& entry) { return !entry.first.ends_with("limit"); });
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), cells + 1);
    const Json json = stability_json(scenes);
    ASSERT_EQ(json[0]["maps"].size(), kMapKinds.size());
    int missing = 0;
    for (const Json& map : json[0]["maps"]) missing += map["missing"].get<int>();
    EXPECT_EQ(missing, int(4 * kMapKinds.size()) - cells);
    EXPECT_TRUE(json[0]["holds"].is_null());
    EXPECT_EQ(holds(scenes[0]), std::nullopt);
    const bool drawn = draw_stability(scenes[0], directory.path());
    EXPECT_EQ(drawn, std::system("command -v gnuplot >/dev/null") == 0);
    EXPECT_EQ(fs::exists(directory.path() / "stability-seed-mass.png"), drawn);
    EXPECT_THAT(stability_page(scenes, {header(), 3, {"seed/a"}}, directory.path()),
                testing::AllOf(testing::HasSubstr("</html>"), testing::HasSubstr("symplectic_euler"),
                               testing::HasSubstr("1 of 3 points are missing"),
                               testing::Not(testing::HasSubstr("href=\"http"))));
}

}  // namespace
}  // namespace nuno
