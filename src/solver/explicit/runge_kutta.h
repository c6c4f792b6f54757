// The explicit Runge-Kutta method of Dormand and Prince (1980), order 5 with an error estimate of order 4, in double.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/archive.h"

namespace nuno {

struct MotionInDouble
{
    std::vector<glm::dvec3> x, v;  // [m], [m/s]
};

class DormandPrince
{
  public:
    // Acceleration of each vertex [m/s2] at x, v and a time [s].
    using Acceleration = std::function<void(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time_s,
                                            std::span<glm::dvec3> a)>;

    explicit DormandPrince(std::size_t vertex_count);

    // One step of h [s] from `from` at `time_s` into `to`. Returns the largest estimate over all vertices of the error
    // in x and in h v [m]. `fresh`: the acceleration at the start is not that at the end of the step before.
    double step(const Acceleration& acceleration, const MotionInDouble& from, double time_s, double h, bool fresh,
                MotionInDouble& to);
    // To be called where the step is taken: its last stage is the next one's first.
    void accept();
    // Writes that stage, or reads it.
    void carry(Archive& archive);

    // The step for which the error would have been `wanted`, by the law err ~ h^5, at most 5 times h and at least a
    // fifth.
    static double next_step(double h, double error, double wanted);

  private:
    struct Stage
    {
        std::vector<glm::dvec3> v, a;  // the derivative: of x and of v
    };
    std::array<Stage, 7> stages_;
    MotionInDouble point_;
};

}  // namespace nuno
