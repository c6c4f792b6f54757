// What TreeSettings::rest_share leaves out: only pairs that keep more than that share of their distance at rest, or
// more than the distance, and the margin besides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "collision/tree/face_tree.h"
#include "collision/tree/tree_cases.h"

namespace nuno {
namespace {

constexpr int kSide = 12;  // vertices
constexpr float kSpacing = 1.0f / (kSide - 1), kShare = 0.4f;
constexpr float kDistance = 2.2f * kSpacing;  // far more than that share of the distance at rest of neighbours
constexpr int kTimes = 2;                     // steps of a way that are looked at

// A flat rest shape with the sides u along its rows and v down its columns, in cells.
TreeCase flat_rest(const char* name, glm::vec2 u, glm::vec2 v, bool as_grid_sheet)
{
    TreeCase cloth = as_grid_sheet ? as_grid(name, flat_sheet(kSide), kSide, kSide) : as_mesh(name, flat_sheet(kSide));
    for (glm::vec3& p : cloth.rest) p = glm::vec3(p.x * u + p.y * v, 0);
    return cloth;
}

std::vector<TreeCase> rest_shapes()
{
    return {flat_rest("square", {1, 0}, {0, 1}, true),
            in_random_order(cut_at_random(flat_rest("square", {1, 0}, {0, 1}, true), 1), 1),
            flat_rest("sheared", {1, 0}, {0.6f, 0.9f}, true),
            flat_rest("not square", {1, 0}, {0, 1.7f}, true),
            flat_rest("mesh", {1, 0}, {0, 1}, false),
            in_random_order(cut_at_random(flat_rest("sheared mesh", {1, 0}, {0.6f, 0.9f}, false), 2), 2)};
}

// As large as the rest shape times `scale`, or with square cells of that many times the spacing, and in waves on the
// way; one corner is folded over by `fold`.
TreeCase pressed(TreeCase cloth, bool square_cells, float scale, float waves, float fold)
{
    for (std::size_t v = 0; v < cloth.t0.size(); ++v) {
        const glm::vec3 at = square_cells ? glm::vec3(cloth.t0[v]) : cloth.rest[v];
        const float beyond = std::max(0.0f, at.x + at.y - 1.2f);
        const glm::vec3 folded = scale * at - fold * beyond * glm::vec3(1, 1, -0.5f);
        cloth.t0[v] = glm::vec4(folded, 1);
        cloth.t1[v] = glm::vec4(folded.x + 5, folded.y, folded.z + waves * std::sin(8 * at.x - 5 * at.y), 1);
    }
    return cloth;
}

struct Outcome
{
    std::size_t left_out = 0, nearer = 0, lost = 0;  // of the pairs of faces; nearer than the distance
    double least_share = 1e30;  // of the distance at rest that those nearer than it keep, less the margin
    bool proven_apart = false;
};

// All faces against all, those with a common vertex too where they are proven apart.
Outcome outcome_of(const TreeCase& cloth, float margin)
{
    ThreadPool pool(1);
    FaceTree tree = cloth.tree();
    tree.refit(cloth.moving(), {kDistance, Culling::sound, kShare, margin}, pool);
    tree.query(pool);
    const std::vector<FacePair> found = sorted_pairs(tree);
    TreeCase rest = cloth;
    for (std::size_t v = 0; v < rest.t0.size(); ++v) rest.t0[v] = glm::vec4(rest.rest[v], 1);
    Outcome outcome;
    outcome.proven_apart = tree.is_proven_apart();
    for (std::uint32_t a = 0; a < cloth.faces.size(); ++a)
        for (std::uint32_t b = a + 1; b < cloth.faces.size(); ++b) {
            const bool neighbours = share_vertex(cloth.faces[a], cloth.faces[b]);
            if (neighbours ? !tree.is_apart_from_neighbours(a)
                           : std::binary_search(found.begin(), found.end(), FacePair{a, b}))
                continue;
            ++outcome.left_out;
            const auto distance_of = neighbours ? face_elements_distance : face_distance;
            double least = 1e30;
            for (int k = 0; k <= kTimes; ++k)
                least = std::min(least, distance_of(cloth, cloth.moving(), {a, b}, double(k) / kTimes));
            if (least > double(kDistance) + double(margin)) continue;
            ++outcome.nearer;
            const double share = (least - double(margin)) / distance_of(rest, rest.still(), {a, b}, 0);
            outcome.lost += share < double(kShare);
            outcome.least_share = std::min(outcome.least_share, share);
        }
    return outcome;
}

TEST(RestShare, no_pair_is_left_out_that_keeps_less_than_the_share_or_the_distance)
{
    for (const TreeCase& shape : rest_shapes()) {
        SCOPED_TRACE(shape.name);
        Outcome all;
        int proven = 0, open = 0;
        for (const bool square_cells : {false, true})
            for (const float scale : {0.395f, 0.402f, 0.5f, 0.525f, 0.8f})
                for (const float fold : {0.0f, 0.5f * scale}) {
                    const float margin = scale >= 0.5f ? 0.08f * kSpacing : 0.0f;
                    const Outcome one = outcome_of(pressed(shape, square_cells, scale, 0.04f, fold), margin);
                    EXPECT_EQ(one.lost, 0u) << scale << ", least share " << one.least_share;
                    (one.proven_apart ? proven : open)++;
                    all.left_out += one.left_out;
                    all.nearer += one.nearer;
                    all.least_share = std::min(all.least_share, one.least_share);
                }
        EXPECT_GT(all.nearer, 1000u);
        EXPECT_GT(proven, 0);
        EXPECT_GT(open, 1);
        std::cout << shape.name << ": " << all.nearer << " pairs within the distance left out, that keep "
                  << all.least_share << " of their distance at rest\n";
    }
}

}  // namespace
}  // namespace nuno
