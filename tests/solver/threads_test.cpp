// The number of threads changes nothing.
#include <gtest/gtest.h>

#include "solver/method_table.h"
#include "support/sheets.h"

namespace nuno {
namespace {

TEST(Threads, one_two_and_three_give_the_same_bits)
{
    const ClothModel model = square_cloth(64, 1, {0, 63});
    Colliders colliders;
    colliders.spheres.push_back({{0.5f, -0.6f, 0.1f}, 0.2f});
    SimParams params;
    params.backend = Backend::cpu;
    params.wind_strength = 3;
    params.substeps = 100;
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 3, 1}) {
        ThreadPool pool(threads);
        const auto solver = make_solver(model, colliders, params, pool);
        ClothState state = start_state(model, params);
        solver->upload(state);
        solver->step({params, 0.25, 101});
        solver->download_positions(state.positions);
        solver->download_velocities(state.velocities);
        hashes.push_back(state_hash(state));
    }
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

}  // namespace
}  // namespace nuno
