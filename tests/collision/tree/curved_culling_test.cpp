// Sound culling of meshes that are curved at rest, with holes or with notches: nothing is lost, and where the cloth is
// near rest little is left to look at.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

#include "collision/tree/culling_outcome.h"
#include "collision/tree/curved_cases.h"
#include "collision/tree/face_tree.h"

namespace nuno {
namespace {

constexpr int kSide = 41;  // vertices a metre

struct Shape
{
    const char* name;
    Bend bend;
    float amount;
};
constexpr Shape kShapes[] = {
    {"waved", waved, 0.01f},       {"waved", waved, 0.03f},       {"waved", waved, 0.06f},
    {"crumpled", crumpled, 0.01f}, {"crumpled", crumpled, 0.03f}, {"crumpled", crumpled, 0.08f},
    {"folded", folded, 0.02f},     {"folded", folded, 0.3f},      {"rolled", rolled, 0.03f}};

// A quarter turn and a long way.
std::vector<glm::vec4> elsewhere(std::vector<glm::vec4> positions)
{
    for (glm::vec4& p : positions) p = {0.7f * (p.x - p.y) + 3, 0.7f * (p.x + p.y) - 40, p.z + 7, 1};
    return positions;
}

struct Sum
{
    std::size_t near = 0, left_out = 0;

    void add(const CullingOutcome& outcome)
    {
        EXPECT_EQ(outcome.lost, 0u);
        near += outcome.near;
        left_out += outcome.left_out;
    }
    void expect_not_vacuous(const std::string& name, std::size_t least_near, std::size_t least_left_out) const
    {
        EXPECT_GT(near, least_near);
        EXPECT_GT(left_out, least_left_out);
        std::cout << name << ": " << near << " pairs within the distance, none lost; " << left_out << " left out\n";
    }
};

TEST(CurvedCulling, loses_no_pair_within_the_distance)
{
    for (const TreeCase& rest : curved_cases(kSide)) {
        Sum sum;
        for (const Shape& shape : kShapes)
            for (const float distance : {0.0f, 0.008f}) {
                SCOPED_TRACE(rest.name + " " + shape.name + " by " + std::to_string(shape.amount) + ", distance " +
                             std::to_string(distance));
                TreeCase cloth = in_random_order(rest, 3);
                cloth.t0 = shaken(bent(cloth, shape.bend, shape.amount), 0.002f, 7);
                const CullingOutcome outcome = culling_outcome(cloth, cloth.still(), distance, Culling::sound);
                EXPECT_GT(outcome.nearest_left_out, distance);
                sum.add(outcome);
            }
        sum.expect_not_vacuous(rest.name, 1000, 1000);
    }
}

TEST(CurvedCulling, loses_no_pair_at_any_time_of_a_way)
{
    for (const TreeCase& rest : curved_cases(33)) {
        Sum sum;
        for (std::size_t k = 0; k < std::size(kShapes); ++k) {
            const Shape &from = kShapes[k], &to = kShapes[(k + 1) % std::size(kShapes)];
            SCOPED_TRACE(rest.name + " from " + from.name + " by " + std::to_string(from.amount) + " to " + to.name);
            TreeCase cloth = rest;
            cloth.t0 = shaken(bent(cloth, from.bend, from.amount), 0.002f, 1);
            cloth.t1 = shaken(bent(cloth, to.bend, to.amount), 0.002f, 2);
            sum.add(culling_outcome(cloth, cloth.moving(), 0.006f, Culling::sound));
            cloth.t1 = elsewhere(shaken(k % 4 == 0 ? cloth.t1 : cloth.t0, 0.004f, 3));
            sum.add(culling_outcome(cloth, cloth.moving(), 0.006f, Culling::sound));
        }
        sum.expect_not_vacuous(rest.name, 1000, 1000);
    }
}

// The same rows and columns side by side, far from the origin.
TEST(CurvedCulling, loses_no_pair_between_sheets_nor_ten_kilometres_away)
{
    Sum sum;
    TreeCase both = together(bag(33), in_random_order(sleeve(41), 4));
    both = together(both, as_grid("grid", crumpled_sheet(17, 0.03f, 4), 17, 17));
    for (std::size_t v = 0; v < both.t0.size(); ++v)
        if (v < both.sheets[2].first_vertex)
            both.t0[v] = glm::vec4(waved(both.rest[v], 0.02f), 1);
        else
            both.t0[v] += glm::vec4(-0.5f, -0.5f, 0.1f, 0);
    both.t1 = both.t0;
    for (const float far : {0.0f, 1e4f}) {
        TreeCase cloth = both;
        for (glm::vec4& p : cloth.t0) p += glm::vec4(far, -far, 0.5f * far, 0);
        sum.add(culling_outcome(cloth, cloth.still(), 0.01f, Culling::sound));
    }
    sum.expect_not_vacuous("two sheets and a grid", 100, 1000);
}

// Vertices and edges of faces that share a vertex are in no list.
TEST(CurvedCulling, knows_which_faces_are_apart_from_their_neighbours)
{
    ThreadPool pool(1);
    constexpr float distance = 0.004f;
    for (const TreeCase& rest : curved_cases(kSide)) {
        std::size_t ruled_out = 0, others = 0;
        for (const Shape& shape : kShapes) {
            TreeCase cloth = rest;
            cloth.t0 = shaken(bent(cloth, shape.bend, shape.amount), 0.002f, 5);
            cloth.t1 = elsewhere(shaken(cloth.t0, 0.003f, 6));
            FaceTree tree = cloth.tree();
            tree.refit(cloth.moving(), {distance, Culling::sound}, pool);
            for (std::uint32_t a = 0; a < cloth.faces.size(); ++a) {
                const bool apart = tree.is_apart_from_neighbours(a);
                (apart ? ruled_out : others)++;
                if (!apart || a % 3 != 0) continue;
                for (std::uint32_t b = 0; b < cloth.faces.size(); ++b)
                    for (int k = 0; k < 3 && a != b && share_vertex(cloth.faces[a], cloth.faces[b]); ++k) {
                        ASSERT_GT(face_elements_distance(cloth, cloth.moving(), {a, b}, 0.5 * k), distance)
                            << rest.name << " " << shape.name << ", " << a << " and " << b;
                    }
            }
        }
        EXPECT_GT(ruled_out, 500u) << rest.name;
        EXPECT_GT(others, 500u) << rest.name;
    }
}

TEST(CurvedCulling, leaves_most_of_a_gently_moving_mesh_out)
{
    ThreadPool pool(1);
    constexpr float distance = 0.004f;
    for (const TreeCase& rest : curved_cases(65)) {
        TreeCase cloth = rest;
        cloth.t0 = bent(cloth, waved, 0.012f);
        cloth.t1 = bent(cloth, waved, 0.016f);
        for (glm::vec4& p : cloth.t1) p += glm::vec4(0.1f, 0, 0.3f, 0);
        FaceTree tree = cloth.tree();
        tree.refit(cloth.moving(), {distance, Culling::none}, pool);
        tree.query(pool);
        const std::uint64_t all = tree.pair_count();
        tree.refit(cloth.moving(), {distance, Culling::sound}, pool);
        tree.query(pool);
        std::size_t apart = 0;
        for (std::uint32_t f = 0; f < cloth.faces.size(); ++f) apart += tree.is_apart_from_neighbours(f);
        std::cout << cloth.name << ": " << tree.pair_count() << " of " << all << " pairs found, " << apart << " of "
                  << cloth.faces.size() << " faces apart from their neighbours\n";
        EXPECT_FALSE(tree.is_proven_apart());
        EXPECT_GT(all, cloth.faces.size() / 4);
        EXPECT_LT(tree.pair_count(), all / 4) << cloth.name;
        EXPECT_GT(apart, cloth.faces.size() * 3 / 4) << cloth.name;
    }
}

// What comes of all pairs of faces with a rest share: those left out keep it, or the distance, and the margin besides.
TEST(CurvedCulling, what_keeps_its_share_of_the_distance_at_rest_need_not_be_found)
{
    ThreadPool pool(1);
    constexpr float share = 0.4f, margin = 0.002f, distance = 0.12f;
    for (const TreeCase& rest : curved_cases(41)) {
        std::size_t left_out = 0, nearer = 0;
        double least_share = 1e30;
        for (const float scale : {0.5f, 0.7f, 0.95f}) {
            TreeCase cloth = rest;
            cloth.t0 = bent(cloth, waved, 0.01f);
            for (glm::vec4& p : cloth.t0) p = glm::vec4(scale * p.x, scale * p.y, scale * p.z, 1);
            FaceTree tree = cloth.tree();
            tree.refit(cloth.still(), {distance, Culling::sound, share, margin}, pool);
            tree.query(pool);
            const std::vector<FacePair> found = sorted_pairs(tree);
            for (const FacePair pair : brute_force_pairs(tree)) {
                if (std::binary_search(found.begin(), found.end(), pair)) continue;
                ++left_out;
                if (left_out % 8 != 0) continue;
                const double least = face_distance(cloth, cloth.still(), pair, 0);
                if (least > double(distance) + double(margin)) continue;
                ++nearer;
                const double at_rest = face_distance(rest, rest.still(), pair, 0);
                least_share = std::min(least_share, (least - double(margin)) / at_rest);
            }
        }
        EXPECT_GT(least_share, double(share)) << rest.name;
        EXPECT_GT(nearer, 100u) << rest.name;
        std::cout << rest.name << ": " << nearer << " of " << left_out
                  << " left out are nearer than the distance, and keep " << least_share << " of that at rest\n";
    }
}

// Large enough for the work to be shared out; some of it is proven and some is not.
TreeCase large_case()
{
    TreeCase cloth = together(in_random_order(sleeve(70), 2), plate_with_hole(60));
    for (std::size_t v = 0; v < cloth.t0.size(); ++v) {
        const glm::vec3 p = cloth.rest[v];
        cloth.t0[v] = glm::vec4(p.x < 0.2f ? waved(p, 0.01f) : crumpled(p, 0.05f), 1);
    }
    cloth.t1 = shaken(cloth.t0, 0.001f, 8);
    return cloth;
}

struct Found
{
    std::vector<std::vector<FacePair>> parts;
    std::vector<bool> apart;

    bool operator==(const Found&) const = default;
};

Found found_by(FaceTree& tree, const Poses& poses, ThreadPool& pool)
{
    tree.refit(poses, {0.004f, Culling::sound}, pool);
    tree.query(pool);
    Found found;
    for (const std::span<const FacePair> part : tree.pairs()) found.parts.emplace_back(part.begin(), part.end());
    for (std::uint32_t f = 0; f < tree.faces().size(); ++f) found.apart.push_back(tree.is_apart_from_neighbours(f));
    return found;
}

TEST(CurvedCullingThreads, does_not_depend_on_threads_nor_on_the_width_of_vectors)
{
    const TreeCase cloth = large_case();
    ThreadPool one(1);
    FaceTree tree = cloth.tree();
    const Found expected = found_by(tree, cloth.moving(), one);
    const auto apart = std::count(expected.apart.begin(), expected.apart.end(), true);
    EXPECT_GT(apart, 2000);
    EXPECT_LT(apart, std::ptrdiff_t(cloth.faces.size()) - 2000);
    for (const int threads : {2, 3}) {
        ThreadPool pool(threads);
        FaceTree other = cloth.tree();
        EXPECT_TRUE(found_by(other, cloth.moving(), pool) == expected) << threads;
    }
    for (const int lanes : {4, 8, 16}) {
        FaceTree other = cloth.tree();
        other.use_lanes(lanes);
        EXPECT_TRUE(found_by(other, cloth.moving(), one) == expected) << lanes;
    }
}

// A proof begins where the last one failed.
TEST(CurvedCulling, does_not_depend_on_what_was_asked_before)
{
    ThreadPool pool(1);
    const TreeCase cloth = large_case();
    FaceTree tree = cloth.tree();
    const Found expected = found_by(tree, cloth.moving(), pool);
    for (const Shape& shape : kShapes) {
        const std::vector<glm::vec4> other = bent(cloth, shape.bend, shape.amount);
        found_by(tree, {other, other}, pool);
        EXPECT_TRUE(found_by(tree, cloth.moving(), pool) == expected) << shape.name;
    }
}

}  // namespace
}  // namespace nuno
