// The springs and plates of one sheet of any mesh as coloured constraints.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/spring_weights.h"
#include "solver/xpbd/constraint_colours.h"

namespace nuno {

class MeshConstraints
{
  public:
    // `model` and `sheet` must outlive it.
    MeshConstraints(const ClothModel& model, const Sheet& sheet);

    // A numbering of the sheet's vertices in which constraints are short: breadth first.
    std::span<const std::uint32_t> places() const { return places_; }

    // For these weights, one a spring of the model; `place_count` places; `limited`: springs will have a limit; numbers
    // left to set. Springs without a force are left out.
    void choose(std::span<const SpringWeight> weights, std::uint32_t place_count, bool limited);
    // Numbers for a step [s] (shaders/shared/xpbd.h), `projections` of each constraint a substep, the largest stretch
    // of springs (0: no limit), and inverse masses, the w of positions, by place.
    void set_numbers(float step, int projections, float limit, std::span<const glm::vec4> positions);

    const ConstraintColours& springs() const { return *springs_; }
    const ConstraintColours& plates() const { return *plate_colours_; }

  private:
    // C = sum of coefficient x over four vertices; energy b C^2 / 2.
    struct Plate
    {
        std::array<std::uint32_t, 4> vertices;  // of the model
        std::array<float, 4> coefficients;
        // The pair of it that no other plate has, as a spring of the model; its weight is -b times this product.
        std::size_t spring;
        float product;
    };
    struct ChosenSpring
    {
        std::uint32_t a, b;  // places
        float rest_length, stiffness;
    };
    struct ChosenPlate
    {
        const Plate* plate;
        float stiffness;
    };

    void find_hinges();
    void find_grid_plates();
    std::uint32_t place(std::uint32_t vertex) const { return places_[vertex - sheet_.first_vertex]; }

    const ClothModel& model_;
    const Sheet& sheet_;
    std::vector<std::uint32_t> places_;
    std::vector<std::size_t> own_springs_;  // numbers of the model's, in the order of their constraints
    std::vector<Plate> plates_;
    std::vector<ChosenSpring> chosen_springs_;
    std::vector<ChosenPlate> chosen_plates_;
    std::optional<ConstraintColours> springs_, plate_colours_;
    bool limited_ = false;
};

}  // namespace nuno
