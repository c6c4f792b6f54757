// Step doubling.
#include "study/doubling_error.h"

#include <limits>

#include "solver/method_table.h"
#include "study/trajectory.h"

namespace nuno {
namespace {

// Positions after one frame from the present state.
std::vector<glm::vec4> next_frame(Simulation& simulation, const SimParams& params, ThreadPool& pool)
{
    const auto solver = make_solver(simulation.model(), simulation.scene().bodies, params, pool);
    solver->upload(simulation.state());
    solver->step({params, simulation.time_s(), params.substeps});
    solver->finish();
    std::vector<glm::vec4> positions(simulation.model().vertex_count());
    solver->download_positions(positions);
    return positions;
}

std::vector<glm::vec3> points(const std::vector<glm::vec4>& positions) { return {positions.begin(), positions.end()}; }

}  // namespace

double doubling_error_m(Simulation& simulation, ThreadPool& pool)
{
    SimParams once = simulation.params();
    once.backend = Backend::cpu;
    SimParams twice = once;
    twice.substeps *= 2;
    const std::vector<glm::vec4> coarse = next_frame(simulation, once, pool),
                                 fine = next_frame(simulation, twice, pool);
    if (first_lost(coarse) || first_lost(fine)) return std::numeric_limits<double>::infinity();
    return rms_distance(points(coarse), points(fine));
}

}  // namespace nuno
