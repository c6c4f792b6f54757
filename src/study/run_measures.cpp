// Measures of a run.
#include "study/run_measures.h"

#include <glm/vec4.hpp>

#include "collision/tangle.h"

namespace nuno {

glm::dvec3 mean_centre(const Trajectory& run)
{
    glm::dvec3 sum(0);
    const int half = run.frames() / 2;
    for (int frame = half; frame <= run.frames(); ++frame) {
        glm::dvec3 centre(0);
        for (const glm::vec3& position : run.positions[std::size_t(frame)]) centre += glm::dvec3(position);
        sum += centre / double(run.positions[0].size());
    }
    return sum / double(run.frames() - half + 1);
}

Intersections count_intersections(const Scene& scene, const SimParams& params, const Trajectory& run, int every)
{
    TangleSearch search(build_cloth_model(make_sheets(scene, params), params.mass_lumping));
    ThreadPool pool(1);
    Intersections found;
    for (int frame = 0; frame <= run.frames(); frame += every) {
        std::vector<glm::vec4> positions;
        for (const glm::vec3& p : run.positions[std::size_t(frame)]) positions.emplace_back(p, 0);
        const std::uint64_t pairs = search.find(positions, pool).size();
        ++found.poses;
        found.poses_that_intersect += pairs > 0;
        found.pairs += pairs;
    }
    return found;
}

}  // namespace nuno
