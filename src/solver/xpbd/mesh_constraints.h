// The springs and plates of one sheet of any mesh as coloured constraints.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "model/spring_weights.h"
#include "solver/xpbd/constraint_colours.h"
#include "solver/xpbd/star_springs.h"

namespace nuno {

class MeshConstraints
{
  public:
    // `model` and `sheet` must outlive it.
    MeshConstraints(const ClothModel& model, const Sheet& sheet);

    // A numbering of the sheet's vertices in which constraints are short: breadth first.
    std::span<const std::uint32_t> places() const { return places_; }

    // What springs() holds: all springs, with room for a limit, or those that are left over by stars(), without.
    enum class Layout
    {
        springs,
        limited_springs,
        stars
    };
    // For these weights, one a spring of the model; `place_count` places; numbers left to set. Springs without a force
    // are left out.
    void choose(std::span<const SpringWeight> weights, std::uint32_t place_count, Layout layout);
    // Numbers for a step [s] (shaders/shared/xpbd.h), `projections` of each constraint a substep, the largest stretch
    // of springs (0: no limit), and inverse masses, the w of positions, by place.
    void set_numbers(float step, int projections, float limit, std::span<const glm::vec4> positions);

    const StarSprings* stars() const { return stars_ ? &*stars_ : nullptr; }  // null but with Layout::stars
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

    void put_into_stars(std::vector<std::uint32_t>& spring_ends, std::uint32_t place_count);
    void find_hinges();
    void find_grid_plates();
    std::vector<std::pair<int, int>> grid_places() const;
    void find_grid_colours();
    std::uint32_t place(std::uint32_t vertex) const { return places_[vertex - sheet_.first_vertex]; }

    const ClothModel& model_;
    const Sheet& sheet_;
    std::vector<std::uint32_t> places_;
    std::vector<std::size_t> own_springs_;    // numbers of the model's, in the order of their constraints
    std::vector<std::size_t> least_colours_;  // of the model's springs, in a grid
    std::vector<Plate> plates_;
    std::vector<ChosenSpring> chosen_springs_;
    std::vector<ChosenPlate> chosen_plates_;
    std::optional<StarSprings> stars_;
    std::vector<std::size_t> in_springs_;  // of each chosen spring, its number in springs_, or Star::kNoSpring
    std::optional<ConstraintColours> springs_, plate_colours_;
    bool limited_ = false;
};

}  // namespace nuno
