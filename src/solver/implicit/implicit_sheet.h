// One sheet under an implicit method: Newton's method on the equation of a stage, with a step check on its energy.
#pragma once

#include <memory>
#include <vector>

#include "solver/implicit/conjugate_gradients.h"
#include "solver/implicit/sheet_system.h"

namespace nuno {

// Loads that do not depend on the sheet, and how precisely a stage is solved.
struct StageSettings
{
    float gravity[3];         // [m/s2]
    float wind;               // pressure along z [N/m2]
    float damping;            // to still air [kg/(m2 s)]
    float stiffness_damping;  // [s]
    double tolerance;         // energy of the error that a solve may leave, of that which the loads give in a stage
    int newton_steps;
};

// Sums over all solves.
struct SolveCounts
{
    long solves = 0, iterations = 0;
    long capped = 0;  // solves that stopped at the cap on iterations
};

class ImplicitSheet
{
  public:
    explicit ImplicitSheet(std::unique_ptr<SheetSystem> system);

    SheetSystem& system() { return *system_; }
    SheetMotion& motion() { return now_; }
    // Where the sheet was at the start of the last step.
    const SheetMotion& motion_before() const { return at_; }
    Field& inertia() { return inertia_; }  // mass [kg], 0: held
    Field& area() { return area_; }        // [m2]
    Field3& air() { return air_; }         // force of moving air [N], held through a step
    const SolveCounts& counts() const { return counts_; }

    // The functions below are called by every thread of the team.

    // One step of backward Euler.
    void backward_euler(float h, const StageSettings& settings, const Team& team);
    // One step of the diagonally implicit Runge-Kutta method of order 2 that is L-stable (Alexander 1977): two stages
    // of gamma h, gamma = 1 - 1 / sqrt(2).
    void sdirk2(float h, const StageSettings& first, const StageSettings& second, const Team& team);

  private:
    // From at_ on, where x and v satisfy x = x_bar + tau v, finds x and v on that line with
    // m (v - w) / tau = force(x, v), w = goal_, and leaves them in at_.
    void solve_stage(float tau, const StageSettings& settings, const Team& team);
    void start_first_stage(float tau, const Team& team);
    void set_load(float tau, const StageSettings& settings, const Team& team);
    SolveResult newton_step(float tau, const StageSettings& settings, const Field3* guess, const SolveLimits& limits,
                            const Team& team);
    double linearise(const StageTerms& terms, const StageSettings& settings, const Team& team);
    bool take_step(const StageTerms& terms, const StageSettings& settings, double most, const Team& team);
    double energy_of_step(const StageTerms& terms, const StageSettings& settings, float share, const Team& team);
    void count(const SolveResult& solved);

    std::unique_ptr<SheetSystem> system_;
    ConjugateGradients solver_;
    SheetMotion now_, at_, trial_;  // at the start of the step, at the point of linearisation, after a Newton step
    Field3 goal_, guess_, zero_;    // w of the stage; first guess of its displacement [m]
    Field inertia_, area_, mass_;
    Field3 air_;
    Field3 r_, d_, tried_;
    std::vector<double> row_energy_, row_sums_;
    double load_sq_ = 0;
    SolveCounts counts_;
};

}  // namespace nuno
