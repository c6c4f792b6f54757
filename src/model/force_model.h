// All forces on a cloth in double, one vertex, spring or face after another: the plain sum that every faster way of
// computing it is held against.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/cloth_model.h"
#include "model/face_table.h"
#include "model/spring_weights.h"

namespace nuno {

class ForceModel
{
  public:
    // `model` must outlive it.
    ForceModel(const ClothModel& model, const SimParams& params);

    // Force [N] on each vertex at positions x [m], velocities v [m/s] and a time: springs, plate, membrane and their
    // dampers, gravity, damper, wind. What holds a vertex is not part of it.
    void forces(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time_s,
                std::span<glm::dvec3> force) const;

    // Energy [J] of springs, plate and membrane, 0 at rest.
    double elastic_energy(std::span<const glm::dvec3> x) const;
    // The same with that of gravity, 0 at the origin.
    double potential_energy(std::span<const glm::dvec3> x) const;
    double kinetic_energy(std::span<const glm::dvec3> v) const;

    // Area times areal density [kg], of pinned vertices too.
    double mass(std::uint32_t vertex) const { return double(model_.areas[vertex]) * double(params_.areal_density); }

  private:
    void add_springs(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, std::span<glm::dvec3> force) const;
    void add_membrane(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, std::span<glm::dvec3> force) const;
    void add_air(std::span<const glm::dvec3> x, std::span<const glm::dvec3> v, double time_s,
                 std::span<glm::dvec3> force) const;

    const ClothModel& model_;
    const SimParams params_;
    const FaceForces face_forces_;
    std::vector<SpringWeight> weights_;
    std::vector<formulas_f64::FaceRest> faces_;  // empty: no forces on faces
};

}  // namespace nuno
