// Pairs kept, and how long.
#include "collision/kept_pairs.h"

#include <algorithm>

namespace nuno {
namespace {

// Queries that a margin is to last for, and those it has to last for to be worth the larger lists.
constexpr double kQueriesAhead = 12, kLeastAhead = 4;
// Of the most, the margin that cloth at rest has.
constexpr double kLeastMargin = 1.0 / 16;
// Distances that differ by no more than this are asked for by the same caller.
constexpr float kAlike = 2;

}  // namespace

bool KeptPairs::are_like(const TreeSettings& settings) const
{
    return settings.culling == settings_.culling && settings.rest_share == settings_.rest_share &&
           settings.distance <= kAlike * settings_.distance && settings_.distance <= kAlike * settings.distance;
}

// What was left out keeps more than it has to by the margin, be it the distance or a share of that at rest.
bool KeptPairs::hold(const Poses& poses, const TreeSettings& settings, ThreadPool& pool)
{
    motion_ = bound_.relative_motion(poses, pool);
    ++queries_;
    const double further = std::max(0.0, double(settings.distance) - double(settings_.distance));
    return settings_.margin > 0 && are_like(settings) && motion_ + further <= double(settings_.margin);
}

float KeptPairs::margin_for(const TreeSettings& settings, float most) const
{
    if (settings.culling == Culling::seed || !are_like(settings) || queries_ == 0) return 0;
    const double a_query = motion_ / queries_, limit = double(most);
    if (!(kLeastAhead * a_query <= limit)) return 0;
    return static_cast<float>(std::clamp(kQueriesAhead * a_query, kLeastMargin * limit, limit));
}

void KeptPairs::begin(const Poses& poses, const TreeSettings& settings)
{
    settings_ = settings;
    queries_ = 0;
    pairs.clear();
    if (settings.margin > 0)
        bound_.note_query(poses, settings.distance + settings.margin);
    else
        bound_.note_some(poses);
}

void KeptPairs::carry(Archive& archive)
{
    archive.list(pairs);
    archive.value(near_culled);
    bound_.carry(archive);
    archive.value(settings_.distance);
    archive.value(settings_.culling);
    archive.value(settings_.rest_share);
    archive.value(settings_.margin);
    archive.value(motion_);
    archive.value(queries_);
}

}  // namespace nuno
