// Cloth on handles that move, with tethers to them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

constexpr int kSide = 17;
const glm::dvec3 kWay(0.6, 0.3, 0.8);

std::vector<MethodAndSweep> tethered_methods()
{
    std::vector<MethodAndSweep> all = methods_and_sweeps();
    std::erase_if(all, [](const MethodAndSweep& each) { return !method_info(each.method).takes_tethers; });
    return all;
}

// A stiff sheet of 1 m by its upper corners.
class TetheredHandleTest : public testing::TestWithParam<MethodAndSweep>
{
  protected:
    TetheredHandleTest() : params_(on_cpu(GetParam().method, GetParam().sweep))
    {
        params_.tethers = Tethers::pins;
        params_.structural_stiffness = 1e4f;
        params_.shear_stiffness = 5e3f;
        params_.bend_stiffness = 200;
        params_.damping = 1;
        params_.frame_rate = 60;
        params_.substeps = 10;
    }

    // By the vertices `held` of its upper row, on a handle that goes `kWay` in a second.
    static ClothModel held_by_a_handle(const std::vector<std::uint32_t>& held)
    {
        SheetSource source = square_sheet(kSide, 1);
        for (const std::uint32_t v : held) source.handle_pins.push_back({v, 0});
        return build_cloth_model(std::span(&source, 1), MassLumping::area);
    }

    static Bodies moving_hand()
    {
        Bodies bodies;
        bodies.handles.push_back({"hand", {}});
        bodies.handles[0].motion.keyframes = {{0, {}}, {1, kWay}};
        return bodies;
    }

    SimParams params_;
};

// No vertex is further from a pin than along the cloth; springs, which come after the tethers, still move it a little:
// by the free fall of a substep and their own strain, 1 % here.
TEST_P(TetheredHandleTest, cloth_follows_within_its_own_length)
{
    const ClothModel model = held_by_a_handle({0, kSide - 1});
    const Bodies bodies = moving_hand();
    ThreadPool pool(1);
    const auto solver = make_solver(model, bodies, params_, pool);
    solver->upload(start_state(model, params_));
    double beyond = 0, strain = 0;
    for (int frame = 0; frame < 90; ++frame) {
        solver->step({params_, frame / 60.0, params_.substeps});
        const ClothState state = state_of(*solver, model);
        strain = std::max(strain, largest_thread_strain(model, state));
        for (const std::uint32_t pin : {0u, std::uint32_t(kSide - 1)}) {
            const double s = std::min((frame + 1) / 60.0, 1.0);
            const glm::dvec3 hand = glm::dvec3(model.start_positions[pin]) + s * s * (3 - 2 * s) * kWay;
            EXPECT_LT(glm::distance(glm::dvec3(state.positions[pin]), hand), 1e-6) << frame;
            beyond = std::max(beyond, furthest_beyond(model, state, pin));
        }
    }
    expect_measured(fmt::format("moving handle, {}: furthest beyond the tether, m", name_of(GetParam())), beyond, 0,
                    0.01);
    expect_measured(fmt::format("moving handle, {}: largest strain", name_of(GetParam())), strain, 0, 0.03);
}

// Damped to rest where the handle has brought it, and started there on fixed pins: one shape. The slowest mode, a swing
// of 3.8 rad/s damped by 2.5 / s, has fallen to e^(-22) after 9 s. What is left: where the hem hangs off the vertical
// by theta, each substep pulls it back by theta g h^2, which is lost where it is less than a place near 1 rounds by,
// 6e-8.
TEST_P(TetheredHandleTest, at_rest_it_hangs_as_from_fixed_pins)
{
    // By all of its upper row: by its corners alone it may fold one way or another.
    std::vector<std::uint32_t> row(kSide);
    std::iota(row.begin(), row.end(), 0u);
    const ClothModel moved = held_by_a_handle(row);
    const Bodies bodies = moving_hand();
    SheetSource source = square_sheet(kSide, 1, row);
    for (const glm::vec3& p : source.mesh.positions) source.start.push_back(p + glm::vec3(kWay));
    const ClothModel fixed = build_cloth_model(std::span(&source, 1), MassLumping::area);
    ClothState ends[2];
    for (const bool moves : {false, true}) {
        const ClothModel& model = moves ? moved : fixed;
        ThreadPool pool(1);
        const auto solver = make_solver(model, moves ? bodies : kNoBodies, params_, pool);
        solver->upload(start_state(model, params_));
        solver->step({params_, 0, 10 * 60 * params_.substeps});
        ends[moves] = state_of(*solver, model);
    }
    const double h = double(substep_s(params_));
    expect_measured(fmt::format("moved handle, {}: distance to cloth on fixed pins, m", name_of(GetParam())),
                    rms_distance(ends[0], ends[1]), 0, 6e-8 / (9.81 * h * h));
}

INSTANTIATE_TEST_SUITE_P(Methods, TetheredHandleTest, testing::ValuesIn(tethered_methods()), kMethodName);

}  // namespace
}  // namespace nuno
