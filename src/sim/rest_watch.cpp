// Cloth at rest, and still surroundings.
#include "sim/rest_watch.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "model/wind_field.h"

namespace nuno {
namespace {

// What is over and over again counts as changing at all times.
bool changes(const BodyMotion& motion, double from_s, double to_s)
{
    const auto is_within = [&](const Keyframe& key) { return key.time_s > from_s && key.time_s < to_s; };
    if (motion.repeat || std::any_of(motion.keyframes.begin(), motion.keyframes.end(), is_within))
        return motion.moves();
    const Displacement a = displacement_at(motion, from_s), b = displacement_at(motion, to_s);
    return motion.moves() && (a.move != b.move || a.rotation != b.rotation);
}

bool wind_changes(const SimParams& params, double from_s, double to_s)
{
    if (params.wind_model == WindModel::sines) return params.wind_strength != 0;
    return params.gust_speed != 0 && air_field(params, from_s).offset != air_field(params, to_s).offset;
}

}  // namespace

void RestWatch::look(std::span<const glm::vec4> positions, double time_s, float most_motion)
{
    const auto stays = [&](const glm::vec4& now, const glm::vec4& then) {
        const glm::vec3 way = glm::vec3(now) - glm::vec3(then);
        return glm::dot(way, way) < most_motion * most_motion;
    };
    if (places_.size() != positions.size() || !std::equal(positions.begin(), positions.end(), places_.begin(), stays)) {
        places_.assign(positions.begin(), positions.end());
        since_s_ = time_s;
    }
    at_rest_ = time_s - since_s_ >= kRestSeconds;
}

void RestWatch::carry(Archive& archive)
{
    archive.list(places_);
    archive.value(since_s_);
    archive.value(at_rest_);
}

bool surroundings_change(const SimParams& params, const Bodies& bodies, double from_s, double to_s)
{
    const std::vector<PlacedBody> placed = placed_bodies(bodies);
    return wind_changes(params, from_s, to_s) ||
           std::any_of(placed.begin(), placed.end(),
                       [&](const PlacedBody& body) { return changes(*body.motion, from_s, to_s); }) ||
           std::any_of(bodies.handles.begin(), bodies.handles.end(),
                       [&](const Handle& handle) { return changes(handle.motion, from_s, to_s); });
}

}  // namespace nuno
