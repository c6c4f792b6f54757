// The number of threads changes nothing of what vertex block descent gives.
#include <gtest/gtest.h>

#include "solver/vbd/cpu_vbd.h"
#include "support/sheets.h"

namespace nuno {
namespace {

TEST(VbdThreads, one_two_and_three_give_the_same_bits)
{
    const SheetSource mesh = square_mesh(48, 1, 64);
    Bodies bodies;
    bodies.spheres.push_back({{0.5f, -0.6f, 0.1f}, 0.2f});
    for (const ClothModel& model :
         {square_cloth(50, 1, {0, 49}), build_cloth_model(std::span(&mesh, 1), MassLumping::area)})
    {
        SimParams params;
        params.method = Method::vbd;
        params.substeps = 5;
        params.tethers = Tethers::pins;
        params.wind_strength = 3;
        params.stiffness_damping = 1e-3f;
        std::vector<std::uint64_t> hashes;
        for (const int threads : {1, 2, 3, 1}) {
            ThreadPool pool(threads);
            CpuVbd solver(model, bodies, params, pool);
            ClothState state = start_state(model, params);
            solver.upload(state);
            solver.step({params, 0.25, 7});
            solver.download_positions(state.positions);
            solver.download_velocities(state.velocities);
            hashes.push_back(state_hash(state));
        }
        for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
    }
}

}  // namespace
}  // namespace nuno
