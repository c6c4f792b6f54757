// Queries that go through the pairs of an earlier one: they miss nothing, and where the cloth has moved too far there
// are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

#include <glm/common.hpp>

#include "collision/element_query.h"
#include "collision/tree/face_distance.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

constexpr int kSide = 11;  // vertices
constexpr float kSpacing = 1.0f / (kSide - 1);
// As a pass asks twice: for what comes near in it, and for what meets.
const TreeSettings kAhead{0.4f * kSpacing, Culling::sound, 0.37f}, kMeeting{1e-5f, Culling::sound};

bool comes_before(const ElementPair& a, const ElementPair& b)
{
    const auto key = [](const ElementPair& p) {
        return std::tuple(p.kind, p.vertices.x, p.vertices.y, p.vertices.z, p.vertices.w);
    };
    return key(a) < key(b);
}

// In the order in which they are handed on.
std::vector<ElementPair> asked(ElementQuery& query, const Poses& poses, const TreeSettings& settings, ThreadPool& pool)
{
    std::vector<ElementPair> pairs;
    const int tasks = query.begin(poses, settings, pool);
    for (int task = 0; task < tasks; ++task) query.run(task, [&](const ElementPair& pair) { pairs.push_back(pair); });
    return pairs;
}

std::vector<ElementPair> in_order(std::vector<ElementPair> pairs)
{
    std::sort(pairs.begin(), pairs.end(), comes_before);
    EXPECT_TRUE(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end()) << "a pair is there twice";
    return pairs;
}

// Or the distance of their boxes along an axis, where that is more than `most` already.
template <class Place>
double pair_distance(const ElementPair& pair, double most, const Place& place)
{
    const glm::uvec4& v = pair.vertices;
    const glm::dvec3 a = place(v.x), b = place(v.y), c = place(v.z), d = place(v.w);
    const Triangle first = pair.kind == PairKind::vertex_face ? Triangle{a, a, a} : Triangle{a, b, b};
    const Triangle second = pair.kind == PairKind::vertex_face ? Triangle{b, c, d} : Triangle{c, d, d};
    const auto lo = [](const Triangle& t) { return glm::min(glm::min(t[0], t[1]), t[2]); };
    const auto hi = [](const Triangle& t) { return glm::max(glm::max(t[0], t[1]), t[2]); };
    const glm::dvec3 gaps = glm::max(lo(first) - hi(second), lo(second) - hi(first));
    const double gap = std::max({gaps.x, gaps.y, gaps.z});
    return gap > most ? gap : triangle_distance(first, second);
}

// A crumpled sheet and two flat ones beside it, above each other at about the distance asked for, where boxes are as
// far apart as what is in them.
TreeCase layers()
{
    TreeCase cloth = as_grid("crumple", crumpled_sheet(kSide, 0.1f, 5), kSide, kSide);
    for (int layer = 0; layer < 2; ++layer) {
        TreeCase flat = as_grid("flat", flat_sheet(5), 5, 5);
        for (glm::vec4& p : flat.t0) p += glm::vec4(2, 0, 1.12f * kAhead.distance * static_cast<float>(layer), 0);
        cloth = together(cloth, flat);
    }
    return cloth;
}

// The sheets swing to and fro, and go down with all their vertices.
struct Swinging
{
    TreeCase cloth = layers();
    std::vector<glm::vec4> from = cloth.t0;
    float reach;

    explicit Swinging(float reach_m) : reach(reach_m) {}
    // To the poses of step k, on a way as long as the next step.
    void go_to(int k)
    {
        for (std::size_t v = 0; v < from.size(); ++v) {
            // Each flat sheet as a whole, against the other.
            const glm::vec2 at = v < from.size() - 50   ? glm::vec2(cloth.rest[v])
                                 : v < from.size() - 25 ? glm::vec2(0)
                                                        : glm::vec2(0.62f, 0);
            const auto place = [&](int step) {
                const float t = 0.15f * static_cast<float>(step);
                return from[v] +
                       reach *
                           glm::vec4(std::sin(t + 6 * at.x), std::cos(t + 4 * at.y), std::sin(1.3f * t + 5 * at.x), 0) -
                       glm::vec4(0, 0.1f * static_cast<float>(step), 0, 0);
            };
            cloth.t0[v] = place(k);
            cloth.t1[v] = place(k + 1);
        }
    }
};

std::size_t sheet_of(const TreeCase& cloth, std::uint32_t vertex)
{
    std::size_t sheet = cloth.sheets.size() - 1;
    while (vertex < cloth.sheets[sheet].first_vertex) --sheet;
    return sheet;
}

// Of all pairs of elements, those that come nearer than they may and are not handed on; counts all that come so near.
std::size_t missed(const TreeCase& cloth, const FaceElements& elements, const std::vector<ElementPair>& handed_on,
                   const TreeSettings& settings, std::size_t& near)
{
    const auto face_count = static_cast<std::uint32_t>(cloth.faces.size());
    std::size_t lost = 0;
    const auto look_at = [&](const ElementPair& pair) {
        double least = 1e30;
        for (const double t : {0.0, 0.5, 1.0})
            least = std::min(least, pair_distance(pair, double(settings.distance), [&](std::uint32_t v) {
                                 const glm::dvec3 t0(cloth.t0[v]), t1(cloth.t1[v]);
                                 return t0 + t * (t1 - t0);
                             }));
        if (least > double(settings.distance)) return;
        const double at_rest = pair_distance(pair, 1e30, [&](std::uint32_t v) { return glm::dvec3(cloth.rest[v]); });
        const bool same_sheet = sheet_of(cloth, pair.vertices.x) == sheet_of(cloth, pair.vertices.w);
        if (same_sheet && least > double(settings.rest_share) * at_rest) return;
        ++near;
        lost += !std::binary_search(handed_on.begin(), handed_on.end(), pair, comes_before);
    };
    for (std::uint32_t a = 0; a < face_count; ++a)
        for (std::uint32_t b = a + 1; b < face_count; ++b) elements.for_pairs_of(a, b, look_at);
    return lost;
}

// Asks for all of these at every step.
void expect_none_missed(const std::vector<TreeSettings>& asked_for)
{
    ThreadPool pool(1);
    Swinging swing(0.004f);
    ElementQuery query(swing.cloth.rest, swing.cloth.faces, swing.cloth.sheets);
    const FaceElements elements(swing.cloth.faces, static_cast<std::uint32_t>(swing.cloth.rest.size()));
    constexpr int kSteps = 14;
    std::size_t near = 0;
    for (int step = 0; step < kSteps; ++step) {
        swing.go_to(step);
        for (const TreeSettings& settings : asked_for) {
            const std::vector<ElementPair> pairs = in_order(asked(query, swing.cloth.moving(), settings, pool));
            EXPECT_EQ(missed(swing.cloth, elements, pairs, settings, near), 0u) << "step " << step;
        }
    }
    EXPECT_GT(near, 1000u);
    EXPECT_GT(query.queries_skipped(), kSteps / 2 * asked_for.size());
    EXPECT_LT(query.queries_skipped(), (kSteps - 2) * asked_for.size()) << "some had to be done";
    std::cout << near << " pairs near, none missed; " << query.queries_skipped() << " of " << kSteps * asked_for.size()
              << " queries skipped\n";
}

TEST(KeptPairs, miss_nothing_while_the_cloth_moves_slowly)
{
    expect_none_missed({kAhead, kMeeting});
    expect_none_missed({{kAhead.distance, Culling::none}});
}

TEST(KeptPairs, do_not_hold_where_the_cloth_moves_fast_or_is_put_elsewhere_or_more_is_asked_for)
{
    ThreadPool pool(1);
    Swinging fast(0.1f);
    ElementQuery query(fast.cloth.rest, fast.cloth.faces, fast.cloth.sheets);
    for (int step = 0; step < 12; ++step) {
        fast.go_to(step);
        asked(query, fast.cloth.moving(), kAhead, pool);
    }
    EXPECT_EQ(query.queries_skipped(), 0u);

    TreeCase cloth = fast.cloth;
    const auto skips = [&](const TreeSettings& settings) {
        const std::uint64_t before = query.queries_skipped();
        asked(query, cloth.still(), settings, pool);
        return query.queries_skipped() > before;
    };
    const auto settle = [&] {
        for (int k = 0; k < 3; ++k) skips(kAhead);
        return skips(kAhead);
    };
    EXPECT_TRUE(settle());
    cloth.t0[0].x += 0.3f * kSpacing;
    EXPECT_FALSE(skips(kAhead)) << "one vertex alone has moved";
    EXPECT_TRUE(settle());
    EXPECT_FALSE(skips({kAhead.distance, Culling::none, kAhead.rest_share}));
    EXPECT_TRUE(settle());
    EXPECT_FALSE(skips({kAhead.distance, Culling::sound, 0.5f}));
    EXPECT_TRUE(settle());
    EXPECT_FALSE(skips({1.3f * kAhead.distance, Culling::sound, kAhead.rest_share}));
    cloth.t0 = shaken(cloth.t0, 0.3f, 1);
    EXPECT_FALSE(skips(kAhead));
}

TEST(KeptPairsThreads, are_the_same_in_the_same_order_for_any_number_of_threads)
{
    const auto all_asked = [](int threads) {
        ThreadPool pool(threads);
        Swinging swing(0.001f);
        ElementQuery query(swing.cloth.rest, swing.cloth.faces, swing.cloth.sheets);
        std::vector<ElementPair> all;
        for (int step = 0; step < 8; ++step) {
            swing.go_to(step);
            const std::vector<ElementPair> pairs = asked(query, swing.cloth.moving(), kAhead, pool);
            all.insert(all.end(), pairs.begin(), pairs.end());
        }
        EXPECT_GT(query.queries_skipped(), 2u);
        return all;
    };
    const std::vector<ElementPair> one = all_asked(1);
    EXPECT_TRUE(all_asked(2) == one);
    EXPECT_TRUE(all_asked(3) == one);
}

}  // namespace
}  // namespace nuno
