// The stiffness matrix of springs and membrane at a state, times a vector.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/cloth_model.h"
#include "model/face_table.h"
#include "model/spring_weights.h"

namespace nuno {

class StiffnessProduct
{
  public:
    // `model` must outlive it.
    StiffnessProduct(const ClothModel& model, const SimParams& params);

    // K u = -d force / dx . u [N] for moves u [m] about the positions x; rows of vertices that are held are not left
    // out.
    void multiply(std::span<const glm::vec4> x, std::span<const glm::dvec3> u, std::span<glm::dvec3> product) const;

  private:
    void add_membrane(std::span<const glm::vec4> x, std::span<const glm::dvec3> u, std::span<glm::dvec3> product) const;

    const ClothModel& model_;
    std::vector<SpringWeight> weights_;
    std::vector<formulas::FaceRest> faces_;  // empty: no membrane
    formulas::MembraneConstants membrane_{};
};

}  // namespace nuno
