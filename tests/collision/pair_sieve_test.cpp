// Bounds and contacts of many pairs at a time, against each pair by itself.
#include "collision/pair_sieve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/formulas.h"

namespace nuno {
namespace {

struct Pairs
{
    std::vector<glm::vec4> start, end, ways;
    std::vector<ElementPair> pairs;

    StraightStep step() const { return {start, ways}; }
};

// Four vertices of its own for each pair, in a box of `size` around `centre` [m], moving by up to `way` and all by
// `common`.
Pairs random_pairs(PairKind kind, int count, float size, float way, glm::vec3 centre, glm::vec3 common = glm::vec3(0))
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto vector = [&](float length) {
        return glm::vec4(length * unit(random), length * unit(random), length * unit(random), 0);
    };
    Pairs all;
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<std::uint32_t>(all.start.size());
        for (int corner = 0; corner < 4; ++corner) {
            all.start.push_back(glm::vec4(centre, 0) + vector(size));
            all.end.push_back(all.start.back() + glm::vec4(common, 0) + vector(way));
            all.ways.push_back(all.end.back() - all.start.back());
        }
        all.pairs.push_back({kind, {first, first + 1, first + 2, first + 3}, 0});
    }
    return all;
}

formulas_f64::ClosestPoints closest_at(const Pairs& all, const ElementPair& pair, double time)
{
    glm::dvec3 x[4];
    for (int corner = 0; corner < 4; ++corner) {
        const std::uint32_t v = pair.vertices[corner];
        x[corner] = glm::mix(glm::dvec3(all.start[v]), glm::dvec3(all.end[v]), time);
    }
    return pair.kind == PairKind::vertex_face ? formulas_f64::closest_vertex_face(x[0], x[1], x[2], x[3])
                                              : formulas_f64::closest_edge_edge(x[0], x[1], x[2], x[3]);
}

double least_distance(const Pairs& all, const ElementPair& pair)
{
    double least = INFINITY;
    for (int i = 0; i <= 64; ++i) least = std::min(least, glm::length(closest_at(all, pair, i / 64.0).separation));
    return least;
}

std::vector<float> bounds_of(const Pairs& all)
{
    std::vector<float> bounds(all.pairs.size());
    for (std::size_t i = 0; i < all.pairs.size(); i += kMostPairsAtOnce) {
        const std::size_t count = std::min(kMostPairsAtOnce, all.pairs.size() - i);
        bound_distances(all.pairs[i].kind, std::span(all.pairs).subspan(i, count), all.step(),
                        std::span(bounds).subspan(i, count));
    }
    return bounds;
}

class PairSieve : public testing::TestWithParam<PairKind>
{};

TEST_P(PairSieve, bounds_the_distance_on_the_whole_way_from_below)
{
    const glm::vec3 none(0), far(1e4f, -3e3f, 5e3f);
    for (const auto& [centre, common] : {std::pair(none, none), {far, none}, {none, far}})
        for (const float way : {0.0f, 0.02f, 0.5f}) {
            const Pairs all = random_pairs(GetParam(), 4000, 0.1f, way, centre, common);
            const std::vector<float> bounds = bounds_of(all);
            int above = 0;
            for (std::size_t i = 0; i < bounds.size(); ++i) {
                if (bounds[i] <= 0) continue;
                ++above;
                ASSERT_LE(double(bounds[i]), least_distance(all, all.pairs[i])) << "pair " << i << " of seed 7";
            }
            EXPECT_GT(above, way > 0.1f ? 20 : 700) << "way " << way;
        }
}

TEST_P(PairSieve, foresees_the_closest_points_of_each_pair_whatever_its_neighbours)
{
    const Pairs all = random_pairs(GetParam(), 61, 0.02f, 0.002f, glm::vec3(0));
    std::vector<ForeseenPair> together(all.pairs.size());
    foresee_pairs(GetParam(), all.pairs, all.step(), 1.0f, together);
    int kept = 0;
    for (std::size_t i = 0; i < all.pairs.size(); ++i) {
        ForeseenPair alone;
        foresee_pairs(GetParam(), std::span(all.pairs).subspan(i, 1), all.step(), 1.0f, {&alone, 1});
        EXPECT_EQ(alone.gap, together[i].gap);
        EXPECT_EQ(alone.normal, together[i].normal);
        if (std::isinf(alone.gap)) continue;
        ++kept;
        const glm::dvec3 separation = closest_at(all, all.pairs[i], 0).separation;
        const double distance = glm::length(separation);
        EXPECT_LT(glm::length(glm::dvec3(alone.normal) - separation / distance), 1e-3) << "pair " << i;
        EXPECT_LE(double(alone.gap), distance * (1 + 1e-5)) << "pair " << i;
    }
    EXPECT_GT(kept, 30);
}

TEST_P(PairSieve, leaves_out_what_stays_out_of_reach_and_keeps_what_comes_into_it)
{
    // One metre up, coming down through the other by half a metre, or not.
    Pairs all;
    all.start = {{0.2f, 0.2f, 1, 0}, {0.3f, 0.3f, 1, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
    all.ways.assign(5, glm::vec4(0));
    all.pairs = {GetParam() == PairKind::vertex_face ? ElementPair{GetParam(), {0, 2, 3, 4}, 0}
                                                     : ElementPair{GetParam(), {0, 1, 3, 4}, 0}};
    ForeseenPair foreseen;
    foresee_pairs(GetParam(), all.pairs, all.step(), 0.1f, {&foreseen, 1});
    EXPECT_TRUE(std::isinf(foreseen.gap));
    all.ways[0].z = all.ways[1].z = -1.5f;
    foresee_pairs(GetParam(), all.pairs, all.step(), 0.1f, {&foreseen, 1});
    EXPECT_LT(foreseen.gap, 0.1f);
    EXPECT_NEAR(foreseen.approach, 1.5f, 1e-6f);
}

TEST_P(PairSieve, calls_nothing_apart_that_has_no_size_or_touches)
{
    Pairs all;
    all.start.assign(8, glm::vec4(0.1f, 0.2f, 0.3f, 0));
    all.start[5].x += 1;
    all.ways.assign(8, glm::vec4(0));
    all.pairs = {{GetParam(), {0, 1, 2, 3}, 0}, {GetParam(), {4, 5, 6, 7}, 0}};
    for (const float bound : bounds_of(all)) EXPECT_LE(bound, 0.0f);
    std::vector<ForeseenPair> foreseen(2);
    foresee_pairs(GetParam(), all.pairs, all.step(), 1.0f, foreseen);
    for (const ForeseenPair& pair : foreseen) EXPECT_FALSE(std::isnan(pair.gap));
}

INSTANTIATE_TEST_SUITE_P(kinds, PairSieve, testing::Values(PairKind::vertex_face, PairKind::edge_edge),
                         [](const auto& kind) {
                             return kind.param == PairKind::vertex_face ? "vertex_face" : "edge_edge";
                         });

}  // namespace
}  // namespace nuno
