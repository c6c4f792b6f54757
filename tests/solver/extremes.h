// Cloth at the extremes: which methods, on which backend, and the bounds that physics sets.
#pragma once

#include <gtest/gtest.h>

#include "gl/egl_context.h"
#include "model/diagnostics.h"
#include "solver/method_choice.h"
#include "solver/solver_runs.h"

namespace nuno {

struct Extreme
{
    Backend backend;
    MethodAndSweep method;
};

inline std::string name_of(const Extreme& each)
{
    return std::string(choice_names(each.backend)[std::size_t(each.backend)]) + "_" + name_of(each.method);
}

inline void PrintTo(const Extreme& each, std::ostream* out) { *out << name_of(each); }

// Those that must stand anything: stable at any substep, or chosen by nuno. Each program tests one backend.
std::vector<Extreme> extremes_to_test();

// The methods of `backend` that are stable at any substep, and the one that nuno chooses.
std::vector<Extreme> stable_on(Backend backend);

class ExtremesTest : public testing::TestWithParam<Extreme>
{
  protected:
    ExtremesTest();
    ~ExtremesTest() override;

    // A solver of the model with params_ resolved, uploaded, and what it is to be held to.
    struct Run
    {
        SimParams params;
        std::unique_ptr<ThreadPool> pool;
        std::unique_ptr<ClothSolver> solver;
    };
    Run start(const ClothModel& model, const ClothState& state);

    // Steps frame by frame and expects every number to stay finite. Returns the end.
    ClothState finish(Run& run, const ClothModel& model, int frames, const char* what);

    // Runs from `state` and expects what expect_less_energy does.
    void expect_no_energy_is_made(const ClothModel& model, const ClothState& state, int frames, const char* what);

    // Energy can come only from what the start holds and from gravity, less what dampers take:
    //     kinetic(end) <= kinetic(start) + elastic(start) + gravity(start) - gravity(end),
    // but for the energy of a symplectic method, which swings; for a thousandth of the weight times the side of the
    // sheet; and for rounding, where speeds are made of places: the springs of a vertex round its place by 3e-7 m, its
    // speed by that over h, each substep its own way.
    static void expect_less_energy(const SimParams& params, const Diagnostics& before, const Diagnostics& after,
                                   int frames, const char* what);

    std::unique_ptr<Context> context_;
    SimParams params_;
    const ClothModel model_ = square_cloth(20, 1, {0, 19}, MassLumping::area);
};

}  // namespace nuno
