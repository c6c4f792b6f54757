// What is measured of a whole run: where the cloth is, and how often it intersects itself.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "study/trajectory.h"

namespace nuno {

// Mean of the vertices over the frames of the second half [m].
glm::dvec3 mean_centre(const Trajectory& run);

// Pairs of faces that intersect, counted exactly in every `every`-th pose from the start on.
struct Intersections
{
    std::uint64_t poses = 0, poses_that_intersect = 0, pairs = 0;

    double per_pose() const { return double(pairs) / double(poses); }
};
Intersections count_intersections(const Scene& scene, const SimParams& params, const Trajectory& run, int every);

}  // namespace nuno
