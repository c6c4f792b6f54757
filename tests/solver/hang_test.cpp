// A stiff 2 m sheet that hangs by two corners, at the settings that nuno chooses by itself: stiff at any resolution,
// and not frozen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "model/diagnostics.h"
#include "solver/method_choice.h"
#include "solver/solver_runs.h"
#include "support/verification.h"

namespace nuno {
namespace {

// The scene `hang` with everything else left to nuno.
SimParams hang_params()
{
    SimParams params;
    params.backend = Backend::cpu;
    params.structural_stiffness = 1e4f;
    params.shear_stiffness = 5e3f;
    params.bend_stiffness = 200;
    params.damping = 0.04f;
    params.gravity_z = 1;
    return params;
}

ClothModel hang_model(int count) { return square_cloth(count, 2, {0, static_cast<std::uint32_t>(count - 1)}); }

Diagnostics after_two_seconds(const ClothModel& model, const SimParams& params)
{
    ThreadPool pool(1);
    const auto solver = make_solver(model, kNoBodies, params, pool);
    solver->upload(start_state(model, params));
    for (int frame = 0; frame < 120; ++frame) solver->step({params, frame / 60.0, params.substeps});
    return measure(model, state_of(*solver, model), params);
}

// Strain below 3 %, and the kinetic energy of the converged motion to 10 %.
void expect_hangs(const ClothModel& model, const char* layout, double converged_j)
{
    const SimParams params = resolve_params(model, {}, hang_params());
    const Diagnostics end = after_two_seconds(model, params);
    const auto what = [&](const char* number) {
        return fmt::format("hang, {} of {} a side, {} with {} substeps: {}", layout, std::sqrt(model.vertex_count()),
                           name_of(params.method), params.substeps, number);
    };
    expect_measured(what("largest strain"), end.max_strain, 0, 0.03);
    expect_measured(what("kinetic energy at 2 s, J"), end.kinetic_j, converged_j, 0.1 * converged_j);
}

void expect_grid_hangs(int count, double converged_j) { expect_hangs(hang_model(count), "grid", converged_j); }

// Converged, to the tolerance of `reference`: half a second to find at 17 a side, minutes at 128, which took it once.
// At 256 it would take hours, so that is held to the energy at 128; from 17 to 128 it grows by 2 %.
constexpr double kConverged64 = 0.02170, kConverged128 = 0.02211;

TEST(Hang, a_sheet_of_17_a_side_is_stiff_and_not_frozen)
{
    SimParams exact = hang_params();
    exact.method = Method::reference;
    const ClothModel model = hang_model(17);
    expect_grid_hangs(17, after_two_seconds(model, resolve_params(model, {}, exact)).kinetic_j);
}

TEST(Hang, a_sheet_of_64_a_side_is_stiff_and_not_frozen) { expect_grid_hangs(64, kConverged64); }
TEST(Hang, a_sheet_of_128_a_side_is_stiff_and_not_frozen) { expect_grid_hangs(128, kConverged128); }
TEST(Hang, a_sheet_of_256_a_side_is_stiff_and_not_frozen) { expect_grid_hangs(256, kConverged128); }

// Cells cut at random have other springs across, so that the cloth is another where it is sheared: held to the energy of
// the grid all the same.
TEST(Hang, a_mesh_that_is_no_grid_is_stiff_and_not_frozen)
{
    SheetSource source = square_sheet(64, 2, {0, 63});
    source.mesh = cut_at_random(source.mesh, 64, 64);
    source.columns = source.rows = 0;
    expect_hangs(build_cloth_model(std::span(&source, 1), MassLumping::equal), "mesh", kConverged64);
}

}  // namespace
}  // namespace nuno
