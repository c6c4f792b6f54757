// The comparison of the backends: what it measures, and when it says that they do not agree.
#include "study/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gl/egl_context.h"
#include "solver/method_choice.h"
#include "solver/method_table.h"
#include "study/backend_probe.h"
#include "study/compare_plot.h"
#include "support/program_run.h"
#include "support/sheets.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

std::vector<ComparePoint> compare_seed(SimParams (*change)(SimParams))
{
    const Scene scene = load_scene("seed");
    const int sizes[] = {9, 17};
    return compare_backends({{scene, change(scene.params)}}, sizes, [](int, int, const std::string&) { return true; });
}

TEST(Compare, times_both_backends_and_finds_the_same_bits_on_a_software_renderer)
{
    const auto context = make_headless_context();
    const std::vector<ComparePoint> points = compare_seed([](SimParams p) { return p; });
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].particles, 81u);
    EXPECT_EQ(points[1].particles, 289u);
    for (const ComparePoint& p : points) {
        EXPECT_GE(p.timed_frames, 2);
        for (const BackendCost* cost : {&p.cpu, &p.gpu}) {
            EXPECT_GT(cost->frame_ms, 0);
            EXPECT_GT(cost->ns_per_particle_and_substep, 0);
            EXPECT_GE(cost->frame_ms, 0.5 * cost->stage_ms.solve);
        }
        if (gl_info().software) {
            EXPECT_THAT(p.largest_difference_m, testing::Each(0.0));
        }
    }
    EXPECT_TRUE(backends_agree(points, gl_info().software));
    EXPECT_THAT(compare_table(points, true), testing::AllOf(testing::HasSubstr("seed"), testing::HasSubstr("a CPU's")));
    EXPECT_EQ(compare_json(points).size(), 2u);
}

// Left to itself each backend would sweep in its own order.
TEST(Compare, xpbd_is_swept_in_colours_on_both_backends)
{
    const auto context = make_headless_context();
    const int sizes[] = {33};
    const Scene scene = load_scene("swing");
    const auto points =
        compare_backends({{scene, scene.params}}, sizes, [](int, int, const std::string&) { return true; });
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].method, Method::xpbd);
    if (gl_info().software) {
        EXPECT_THAT(points[0].largest_difference_m, testing::Each(0.0));
    }
    EXPECT_TRUE(backends_agree(points, gl_info().software));
    EXPECT_THAT(compare_table(points, true), testing::HasSubstr("xpbd"));
}

TEST(Compare, a_scene_that_goes_bad_is_told_and_does_not_end_the_rest)
{
    const auto context = make_headless_context();
    const std::vector<ComparePoint> points = compare_seed([](SimParams p) {
        p.method = Method::explicit_euler;
        p.damping = 0;
        p.structural_stiffness = 50000;
        return p;
    });
    ASSERT_EQ(points.size(), 2u);
    EXPECT_THAT(points[1].failure, testing::HasSubstr("no longer finite"));
    EXPECT_FALSE(backends_agree(points, true));
    EXPECT_NO_THROW(compare_table(points, true));
}

TEST(Compare, every_method_of_both_backends_runs_and_what_is_left_out_is_told)
{
    const auto context = make_headless_context();
    const Scene seed = load_scene("seed"), twist = load_scene("twist");
    const int sizes[] = {5};
    const std::vector<std::pair<Scene, SimParams>> runs{{seed, seed.params}, {twist, twist.params}};
    const MethodCases all = method_cases(runs, {}, sizes);
    std::vector<std::string> ids;
    std::vector<ComparePoint> points;
    for (const CompareCase& c : all.cases) {
        ids.push_back(c.id());
        if (c.scene->name != "seed") continue;
        points.push_back(compare_point(c));
        EXPECT_EQ(choice_names(Method{})[std::size_t(points.back().method)], method_info(c.params.method).name);
    }
    EXPECT_THAT(ids, testing::IsSupersetOf({"seed/symplectic_euler/5", "seed/verlet/5", "seed/rk4/5", "seed/xpbd/5",
                                            "seed/vbd/5", "twist/vbd/5"}));
    EXPECT_THAT(all.left_out, testing::IsSupersetOf({testing::HasSubstr("sdirk2: runs on the CPU alone"),
                                                     testing::HasSubstr("explicit_euler, 5")}));
    EXPECT_TRUE(backends_agree(points, gl_info().software));

    for (const ComparePoint& p : points) {
        const auto json = compare_json({p});
        EXPECT_EQ(compare_json({compare_point_of(json[0])}), json) << "a point goes to JSON and back";
    }
    const TemporaryDirectory directory;
    EXPECT_EQ(plot_ratios(points, true, directory.path()), std::system("command -v gnuplot >/dev/null") == 0);
    const std::string page = compare_page(points, all.left_out, {{"software_gl", true}}, directory.path());
    for (const char* part : {"times of a CPU", "seed", "rk4", "runs on the CPU alone"})
        EXPECT_THAT(page, testing::HasSubstr(part));
    for (const char* outside : {"src=", "href=\"", "url("}) EXPECT_EQ(page.find(outside), page.npos) << outside;

    const Method one[] = {Method::vbd};
    EXPECT_EQ(method_cases(runs, one, sizes).cases.size(), 2u);
}

TEST(Compare, disagreement_of_any_kind_is_seen)
{
    ComparePoint good;
    good.substep_hashes_agree = good.frame_hashes_agree = true;
    EXPECT_TRUE(backends_agree({good}, true));
    ComparePoint bad = good;
    bad.frame_hashes_agree = false;
    EXPECT_FALSE(backends_agree({good, bad}, true));
    EXPECT_TRUE(backends_agree({bad}, false)) << "hardware may round otherwise";
    bad = good;
    bad.largest_difference_m[0] = 1e-3;
    EXPECT_FALSE(backends_agree({bad}, false));
    bad = good;
    bad.largest_difference_m[3] = -1;
    EXPECT_FALSE(backends_agree({bad}, true)) << "no number agrees with nothing";
    bad = good;
    bad.failure = "went bad";
    EXPECT_FALSE(backends_agree({bad}, true));
}

TEST(Compare, the_picture_is_whole_or_not_there)
{
    ComparePoint point;
    point.scene = "it's_a_scene";
    point.particles = 100;
    point.cpu.ns_per_particle_and_substep = 4;
    point.gpu.ns_per_particle_and_substep = 30;
    std::vector<ComparePoint> points{point, point};
    points[1].particles = 1000;
    const TemporaryDirectory directory;
    const fs::path out = directory.path() / "it's here";
    fs::create_directory(out);
    const bool drawn = plot_comparison(points, true, out);
    EXPECT_EQ(drawn, std::system("command -v gnuplot >/dev/null") == 0);
    for (const char* name : {"compare.svg", "compare.png"}) {
        EXPECT_EQ(fs::exists(out / name), drawn);
        EXPECT_FALSE(fs::exists(out / (std::string(name) + ".part")));
    }
}

TEST(BackendProbe, gives_a_time_for_each_backend)
{
    const auto context = make_headless_context();
    const ClothModel model = square_cloth(17, 1);
    const BackendSpeed speed = probe_backends(model, {}, resolve_params(model, {}, {}));
    EXPECT_GT(speed.cpu_ns, 0);
    EXPECT_GT(speed.gpu_ns, 0);
    EXPECT_LT(speed.cpu_ns, 1e6);
}

}  // namespace
}  // namespace nuno
