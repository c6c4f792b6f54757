// Brute force over boxes, then distances at the times of a way.
#include "collision/tree/culling_outcome.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace nuno {
namespace {

constexpr int kTimes = 16;  // of a way that are looked at

// The least distance of two faces at the times of a way.
double least_distance(const TreeCase& cloth, const Poses& poses, FacePair pair)
{
    double least = face_distance(cloth, poses, pair, 0);
    for (int k = 1; poses.is_swept() && k <= kTimes; ++k)
        least = std::min(least, face_distance(cloth, poses, pair, double(k) / kTimes));
    return least;
}

}  // namespace

CullingOutcome culling_outcome(const TreeCase& cloth, const Poses& poses, float distance, Culling culling)
{
    ThreadPool pool(1);
    FaceTree tree = cloth.tree();
    tree.refit(poses, {distance, Culling::none}, pool);
    const std::vector<FacePair> all = brute_force_pairs(tree);
    tree.refit(poses, {distance, culling}, pool);
    tree.query(pool);
    const std::vector<FacePair> found = sorted_pairs(tree);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), found.begin(), found.end()));

    CullingOutcome outcome;
    outcome.in_reach = all.size();
    outcome.left_out = all.size() - found.size();
    outcome.proven_apart = tree.is_proven_apart();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const FacePair pair = all[k];
        const bool is_found = std::binary_search(found.begin(), found.end(), pair);
        if (is_found && poses.is_swept() && k % 16 != 0) continue;
        const double least = least_distance(cloth, poses, pair);
        outcome.near += least <= distance;
        outcome.lost += least <= distance && !is_found;
        if (!is_found) outcome.nearest_left_out = std::min(outcome.nearest_left_out, least);
    }
    return outcome;
}

}  // namespace nuno
