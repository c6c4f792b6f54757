// Points of a sweep on disk: going on after an interrupt, shares, and joining them.
#include "study/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

#include "core/error.h"
#include "core/files.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::ThrowsMessage;

const Json kHeader{{"study", "squares"}, {"version", "1"}};

// Squares of 0 .. count - 1; `measured` counts them.
std::vector<SweepPoint> squares(int count, int& measured)
{
    std::vector<SweepPoint> points;
    for (int k = 0; k < count; ++k)
        points.push_back({"square/" + std::to_string(k), [k, &measured] {
                              ++measured;
                              return Json{{"value", k * k}};
                          }});
    return points;
}

bool go_on(std::size_t, std::size_t) { return true; }

TEST(Sweep, goes_on_where_it_was_interrupted_and_measures_nothing_twice)
{
    const TemporaryDirectory directory;
    int measured = 0;
    {
        PointStore store(directory.path(), kHeader);
        EXPECT_FALSE(
            run_sweep(squares(10, measured), {}, store, [](std::size_t done, std::size_t) { return done < 4; }));
    }
    EXPECT_EQ(measured, 4);
    PointStore store(directory.path(), kHeader);
    EXPECT_EQ(store.resumed(), 4u);
    EXPECT_TRUE(run_sweep(squares(10, measured), {}, store, go_on));
    EXPECT_EQ(measured, 10);
    EXPECT_EQ(store.results().at("square/9").at("value"), 81);
    EXPECT_EQ(read_points(directory.path()).results.size(), 10u);
}

TEST(Sweep, half_a_line_is_dropped_and_measured_anew)
{
    const TemporaryDirectory directory;
    int measured = 0;
    {
        PointStore store(directory.path(), kHeader);
        run_sweep(squares(3, measured), {}, store, go_on);
    }
    fs::resize_file(directory.path() / "points.jsonl", fs::file_size(directory.path() / "points.jsonl") - 5);
    {
        PointStore store(directory.path(), kHeader);
        EXPECT_TRUE(store.dropped_half_a_line());
        EXPECT_EQ(store.resumed(), 2u);
        run_sweep(squares(3, measured), {}, store, go_on);
    }
    EXPECT_EQ(measured, 4);
    const StoredPoints stored = read_points(directory.path());
    EXPECT_FALSE(stored.ends_in_half_a_line);
    EXPECT_EQ(stored.results.size(), 3u);
}

TEST(Sweep, points_of_another_sweep_are_refused_and_left_alone)
{
    const TemporaryDirectory directory;
    int measured = 0;
    {
        PointStore store(directory.path(), kHeader);
        run_sweep(squares(2, measured), {}, store, go_on);
    }
    const std::string before = read_text(directory.path() / "points.jsonl");
    EXPECT_THAT(
        [&] {
            PointStore(directory.path(), {{"study", "squares"}, {"version", "2"}});
        },
        ThrowsMessage<Error>(testing::AllOf(HasSubstr("version"), HasSubstr("another"))));
    EXPECT_EQ(read_text(directory.path() / "points.jsonl"), before);
}

TEST(Sweep, a_line_that_is_no_point_is_named)
{
    const TemporaryDirectory directory;
    directory.write("points.jsonl", kHeader.dump() + "\n{\"id\":\"a\",\"result\":1}\nnonsense\n");
    EXPECT_THAT([&] { read_points(directory.path()); }, ThrowsMessage<Error>(HasSubstr("points.jsonl:3")));
}

TEST(Sweep, parts_join_to_the_whole_whatever_their_order)
{
    const TemporaryDirectory directory;
    int measured = 0;
    std::vector<fs::path> parts;
    for (int k = 1; k <= 3; ++k) {
        parts.push_back(directory.path() / std::to_string(k));
        PointStore store(parts.back(), kHeader);
        EXPECT_TRUE(run_sweep(squares(8, measured), {k, 3}, store, go_on));
    }
    EXPECT_EQ(measured, 8);
    const auto join = [&](const fs::path& out) { PointStore(out, kHeader).add_missing(joined_points(parts).results); };
    EXPECT_EQ(joined_points(parts).results.size(), 8u);
    join(directory.path() / "a");
    std::swap(parts[0], parts[2]);
    join(directory.path() / "b");
    EXPECT_EQ(read_text(directory.path() / "a/points.jsonl"), read_text(directory.path() / "b/points.jsonl"));
}

TEST(Sweep, parts_that_disagree_are_not_joined)
{
    const TemporaryDirectory directory;
    const fs::path a = directory.path() / "a", b = directory.path() / "b", c = directory.path() / "c";
    PointStore(a, kHeader).add("x", {{"value", 1}});
    PointStore(b, kHeader).add("x", {{"value", 2}});
    PointStore(c, {{"study", "cubes"}, {"version", "1"}}).add("y", {{"value", 2}});
    EXPECT_THAT([&] { joined_points({a, b}); }, ThrowsMessage<Error>(HasSubstr("another result for x")));
    EXPECT_THAT([&] { joined_points({a, c}); }, ThrowsMessage<Error>(HasSubstr("study")));
    EXPECT_THAT([&] { joined_points({a, directory.path() / "none"}); }, ThrowsMessage<Error>(HasSubstr("none")));
}

TEST(Sweep, joining_keeps_what_is_there_and_refuses_to_mix_it)
{
    const TemporaryDirectory directory;
    const fs::path a = directory.path() / "a", b = directory.path() / "b";
    PointStore(a, kHeader).add("x", {{"value", 1}});
    PointStore(b, kHeader).add("y", {{"value", 2}});
    PointStore joined(b, kHeader);
    joined.add_missing(joined_points({a}).results);
    EXPECT_EQ(joined.results().size(), 2u);
    const std::string before = read_text(b / "points.jsonl");
    EXPECT_THAT(
        [&] {
            joined.add_missing({{"w", 4}, {"y", 3}});
        },
        ThrowsMessage<Error>(HasSubstr("another result for y")));
    EXPECT_EQ(read_text(b / "points.jsonl"), before);
}

TEST(Sweep, a_memory_drops_points_of_another_header_and_what_cannot_be_read)
{
    const TemporaryDirectory directory;
    PointStore(directory.path(), {{"study", "cubes"}}).add("z", {{"value", 3}});
    {
        PointStore store(directory.path(), kHeader, FormerPoints::keep_own);
        EXPECT_TRUE(store.dropped_others());
        EXPECT_TRUE(store.results().empty());
        store.add("x", {{"value", 1}});
    }
    {
        const PointStore store(directory.path(), kHeader, FormerPoints::keep_own);
        EXPECT_FALSE(store.dropped_others());
        EXPECT_EQ(store.results().size(), 1u);
        EXPECT_THAT([&] { PointStore(directory.path(), kHeader, FormerPoints::drop); },
                    ThrowsMessage<Error>(HasSubstr("another nuno")));
    }
    EXPECT_EQ(read_points(directory.path()).results.size(), 1u) << "nothing is dropped that another process holds";
    directory.write("points.jsonl", "no json\n");
    EXPECT_TRUE(PointStore(directory.path(), kHeader, FormerPoints::keep_own).dropped_others());
}

TEST(Sweep, a_directory_that_another_process_writes_to_is_refused)
{
    const TemporaryDirectory directory;
    const PointStore first(directory.path(), kHeader);
    EXPECT_THAT([&] { PointStore(directory.path(), kHeader); }, ThrowsMessage<Error>(HasSubstr("another nuno")));
}

TEST(Sweep, on_many_threads_an_interrupt_ends_it_after_the_points_at_hand)
{
    const TemporaryDirectory directory;
    std::atomic<int> measured{0};
    std::vector<SweepPoint> points;
    for (int k = 0; k < 200; ++k) points.push_back({std::to_string(k), [&measured] { return Json(++measured); }});
    ThreadPool pool(3);
    int asked = 0;
    {
        PointStore store(directory.path(), kHeader);
        EXPECT_FALSE(run_sweep(points, {}, store, pool, [&](std::size_t, std::size_t) { return ++asked < 3; }));
        EXPECT_EQ(store.results().size(), std::size_t(measured.load()));
        EXPECT_LT(measured, 200);
    }
    PointStore store(directory.path(), kHeader);
    EXPECT_TRUE(run_sweep(points, {}, store, pool, go_on));
    EXPECT_EQ(measured, 200);
    EXPECT_EQ(read_points(directory.path()).results.size(), 200u);
}

TEST(Sweep, what_is_missing_is_named)
{
    int measured = 0;
    const SweepState some = sweep_state(kHeader, squares(4, measured), {{"square/2", 4}});
    EXPECT_THAT(some.missing, testing::ElementsAre("square/0", "square/1", "square/3"));
    EXPECT_EQ(missing_text(some, 2), "3 of 4 points are missing: square/0, square/1 and 1 more");
    EXPECT_EQ(missing_text(some, 3), "3 of 4 points are missing: square/0, square/1, square/3");
    EXPECT_EQ(missing_text(sweep_state(kHeader, squares(1, measured), {{"square/0", 0}}), 3), "");
    EXPECT_EQ(measured, 0);
}

TEST(Sweep, a_shard_is_a_part_of_a_whole)
{
    const Shard second = parse_shard("2/3");
    std::vector<std::size_t> taken;
    for (std::size_t point = 0; point < 9; ++point)
        if (second.takes(point)) taken.push_back(point);
    EXPECT_THAT(taken, testing::ElementsAre(1, 4, 7));
    for (const char* wrong : {"", "2", "0/3", "4/3", "2/3x", "a/b", "-1/2", "2/"})
        EXPECT_THAT([&] { parse_shard(wrong); }, ThrowsMessage<Error>(HasSubstr("K/N"))) << wrong;
}

}  // namespace
}  // namespace nuno
