// Dormand and Prince's pair of orders 5 and 4.
#include "solver/explicit/runge_kutta.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr int kStages = 7;

// The tableau (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, table 5.2): the last row is the
// solution of order 5, and its stage the first of the next step.
constexpr double kNodes[kStages] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
constexpr double kWeights[kStages][kStages - 1] = {
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
// Order 5 less order 4.
constexpr double kError[kStages] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                    -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

}  // namespace

DormandPrince::DormandPrince(std::size_t vertex_count)
{
    for (Stage& stage : stages_) {
        stage.v.resize(vertex_count);
        stage.a.resize(vertex_count);
    }
    point_.x.resize(vertex_count);
    point_.v.resize(vertex_count);
}

double DormandPrince::step(const Acceleration& acceleration, const MotionInDouble& from, double time_s, double h,
                           bool fresh, MotionInDouble& to)
{
    const std::size_t count = from.x.size();
    for (int s = fresh ? 0 : 1; s < kStages; ++s) {
        MotionInDouble& at = s == kStages - 1 ? to : point_;
        for (std::size_t i = 0; i < count; ++i) {
            glm::dvec3 dx(0), dv(0);
            for (int k = 0; k < s; ++k) {
                dx += kWeights[s][k] * stages_[std::size_t(k)].v[i];
                dv += kWeights[s][k] * stages_[std::size_t(k)].a[i];
            }
            at.x[i] = from.x[i] + h * dx;
            at.v[i] = from.v[i] + h * dv;
        }
        Stage& stage = stages_[std::size_t(s)];
        stage.v = at.v;
        acceleration(at.x, at.v, time_s + kNodes[s] * h, stage.a);
    }
    double error = 0;
    for (std::size_t i = 0; i < count; ++i) {
        glm::dvec3 dx(0), dv(0);
        for (int k = 0; k < kStages; ++k) {
            dx += kError[k] * stages_[std::size_t(k)].v[i];
            dv += kError[k] * stages_[std::size_t(k)].a[i];
        }
        // A comparison that is false for what is no number, so that such a step is never taken.
        const double here = h * glm::length(dx) + h * h * glm::length(dv);
        if (!(here <= error)) error = here;
    }
    return error;
}

void DormandPrince::accept() { std::swap(stages_.front(), stages_.back()); }

void DormandPrince::carry(Archive& archive)
{
    for (auto* values : {&stages_.front().v, &stages_.front().a}) archive.values(std::span(*values));
}

double DormandPrince::next_step(double h, double error, double wanted)
{
    if (!(error < 1e300)) return h / 5;
    const double ratio = 0.9 * std::pow(wanted / std::max(error, 1e-300), 0.2);
    return h * std::clamp(ratio, 0.2, 5.0);
}

}  // namespace nuno
