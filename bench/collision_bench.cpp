// Times of the stages of self-collision: refit, and query with the search for contacts, on a flat and a crumpled sheet.
#include <benchmark/benchmark.h>

#include <utility>

#include "collision/self_collision.h"
#include "tests/collision/poses.h"

namespace nuno {
namespace {

// A sheet of `side` x `side` vertices, one metre wide; a quarter of the spacing thick.
struct Bench
{
    Pose pose;
    ThreadPool pool;
    SelfCollision collision;
    CollisionSettings settings;
    std::vector<glm::vec4> velocities, mirrored;

    Bench(const benchmark::State& state, float amplitude)
        : pose(amplitude > 0 ? crumpled_sheet(static_cast<int>(state.range(0)), amplitude, 1)
                             : flat_sheet(static_cast<int>(state.range(0)))),
          pool(static_cast<int>(state.range(1))),
          collision(pose.rest, pose.faces, pose.sheets, pool),
          velocities(pose.positions.size()),
          mirrored(pose.positions)
    {
        for (glm::vec4& p : mirrored) p.x = -p.x;
        settings.culling = static_cast<Culling>(state.range(2));
        settings.range = {0.25f / static_cast<float>(state.range(0)), 0.05f};
    }
    // So far off that no query goes through the pairs of the one before.
    void mirror() { std::swap(pose.positions, mirrored); }
    // Every vertex a sphere as wide as the spacing.
    void use_spheres(const benchmark::State& state)
    {
        settings.level = CollisionLevel::spheres;
        settings.range.thickness = 1.0f / static_cast<float>(state.range(0));
    }
    CollisionStep step() { return {pose.positions, pose.positions, velocities, 0.01f}; }
    void count(benchmark::State& state)
    {
        state.counters["pairs"] = static_cast<double>(collision.counts().pairs_tested);
        state.counters["contacts"] = collision.counts().contacts;
    }
};

void refit(benchmark::State& state, float amplitude)
{
    Bench bench(state, amplitude);
    for (auto _ : state) {
        bench.mirror();
        bench.collision.refit(bench.step(), bench.settings);
    }
}

void query(benchmark::State& state, float amplitude)
{
    Bench bench(state, amplitude);
    bench.collision.refit(bench.step(), bench.settings);
    for (auto _ : state) benchmark::DoNotOptimize(bench.collision.query(bench.step()));
    bench.count(state);
}

void respond(benchmark::State& state, float amplitude)
{
    Bench bench(state, amplitude);
    bench.collision.refit(bench.step(), bench.settings);
    bench.collision.query(bench.step());
    for (auto _ : state) bench.collision.respond(bench.step());
    bench.count(state);
}

void pass_through(benchmark::State& state, float amplitude)
{
    Bench bench(state, amplitude);
    std::vector<glm::vec4> moved = shaken(bench.pose.positions, bench.settings.range.thickness, 1),
                           moved_mirrored = shaken(bench.mirrored, bench.settings.range.thickness, 1);
    for (auto _ : state) {
        bench.mirror();
        std::swap(moved, moved_mirrored);
        CollisionStep step = bench.step();
        step.positions_t0 = moved;
        bench.collision.count_pass_through(step);
    }
    state.counters["unresolved"] = bench.collision.counts().unresolved;
}

// Stage 0: refit, 1: query, 2: respond.
void spheres(benchmark::State& state, float amplitude, int stage)
{
    Bench bench(state, amplitude);
    bench.use_spheres(state);
    const std::vector<glm::vec4> positions = bench.pose.positions;
    bench.collision.refit(bench.step(), bench.settings);
    bench.collision.query(bench.step());
    bench.count(state);
    for (auto _ : state) {
        if (stage == 0) bench.collision.refit(bench.step(), bench.settings);
        if (stage == 1) benchmark::DoNotOptimize(bench.collision.query(bench.step()));
        if (stage == 2) {
            bench.collision.respond(bench.step());
            bench.pose.positions = positions;
        }
    }
}

constexpr float kFlat = 0, kCrumpled = 0.1f;

void all_sizes(benchmark::internal::Benchmark* b)
{
    b->ArgNames({"side", "threads", "culling"})->Unit(benchmark::kMicrosecond)->UseRealTime();
    for (const int side : {17, 64, 128}) b->Args({side, 1, 0});
    b->Args({128, 2, 0})->Args({128, 1, 1})->Args({128, 1, 2});
}

BENCHMARK_CAPTURE(refit, flat, kFlat)->Apply(all_sizes);
BENCHMARK_CAPTURE(refit, crumpled, kCrumpled)->Apply(all_sizes);
BENCHMARK_CAPTURE(query, flat, kFlat)->Apply(all_sizes);
BENCHMARK_CAPTURE(query, crumpled, kCrumpled)->Apply(all_sizes);
BENCHMARK_CAPTURE(respond, crumpled, kCrumpled)->Apply(all_sizes);
BENCHMARK_CAPTURE(pass_through, crumpled, kCrumpled)->Apply(all_sizes);

BENCHMARK_CAPTURE(spheres, refit, kCrumpled, 0)->Apply(all_sizes);
BENCHMARK_CAPTURE(spheres, query, kCrumpled, 1)->Apply(all_sizes);
BENCHMARK_CAPTURE(spheres, respond, kCrumpled, 2)->Apply(all_sizes);

}  // namespace
}  // namespace nuno

BENCHMARK_MAIN();
