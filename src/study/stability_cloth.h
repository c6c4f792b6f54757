// A cloth at rest, about which limits of stability are measured and predicted, and a solver that shakes it with
// substeps of any length.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "core/thread_pool.h"
#include "model/cloth_model.h"
#include "model/cloth_state.h"
#include "solver/base/cloth_solver.h"

namespace nuno {

// What a map changes of a scene's cloth.
struct RestCase
{
    double stiffness = 1;   // times the scene's, of every kind
    double damping = 0;     // as SimParams::damping [kg/(m2 s)]
    double pressure = 0;    // along z [N/m2]
    double mass_ratio = 1;  // of neighbours: every other vertex is lighter by it
    bool loaded = false;    // at rest under gravity and the pressure; else at its rest shape, without either
};

struct RestCloth
{
    ClothModel model;
    SimParams params;  // without a method and a substep
    ClothState rest;
    double omega = 0, omega_bound = 0;    // the highest frequency here, and the bound on it [rad/s]
    std::vector<glm::dvec3> slow_motion;  // of the whole sheet, longest waves along its sides; at most 1
    double slow_omega = 0;                // its frequency [rad/s]
    std::vector<glm::dvec3> fast_motion;  // of the highest mode; at most 1
    double spring_m = 0;                  // mean length of a spring here
    double residual_speed = 0;            // that a loaded cloth is left with [m/s]
};

// Makes every other vertex of each sheet lighter by a ratio: of a grid those whose column and row add up to an odd
// number.
void make_every_other_lighter(ClothModel& model, double ratio);
// All stiffness of a cloth times a factor.
void scale_stiffness(SimParams& params, double factor);

// The sheets as a scene has them, in their rest shape; pins stay where they are.
RestCloth rest_cloth(const ClothModel& sheets, const SimParams& params, const RestCase& rest);

// The largest stable substep of a method here [s].
double predicted_limit_s(const RestCloth& cloth, Method method);

// How a cloth at rest is set in motion: the velocity of the slow motion, of all modes, repeatable by a seed, and of the
// highest.
struct Shake
{
    double share;  // of the length of a spring that the slow motion goes
    double noise;  // of all modes, in shares of the slow one
    double fast;   // of the highest, the same
    int seed;
};
ClothState shaken(const RestCloth& cloth, const Shake& shake);

// A method on one thread with substeps of any length [s], which SimParams has in whole parts of a second only: a second
// is cut as finely as needed and the unit of time stretched by the rest, up to twice. With t = r t', masses become
// m / r^2, dampers c / r, Rayleigh's beta / r, velocities r v; forces stay.
class ExactSubsteps
{
  public:
    // `cloth` must outlive it.
    ExactSubsteps(const RestCloth& cloth, Method method, double substep_s);

    void upload(const ClothState& state);
    void step(int count);
    const ClothState& state();  // velocities in m/s

  private:
    const Bodies no_bodies_;
    double unit_s_;
    SimParams params_;
    ThreadPool pool_{1};
    std::unique_ptr<ClothSolver> solver_;
    ClothState state_;
    int done_ = 0;
};

// The root of the mean of v^2 by mass [m/s], over the vertices that are free.
double mean_speed(const RestCloth& cloth, const ClothState& state);
// How far two states are apart [m/s]: the same of v^2 + (slow_omega x)^2, v and x the differences of theirs.
double difference(const RestCloth& cloth, const ClothState& a, const ClothState& b);

}  // namespace nuno
