// What a run is made of and what collision found, as marks over the picture. Each function appends to the overlay and
// says in the legend what it drew.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "app/overlay_legend.h"
#include "collision/tree_picture.h"
#include "render/overlay.h"
#include "sim/simulation.h"

namespace nuno {

// Where marks go.
struct MarkSheet
{
    Overlay& overlay;
    OverlayLegend& legend;
};

// Each edge of the faces once.
std::vector<glm::uvec2> edges_of(std::span<const glm::uvec3> faces);

void mark_wireframe(std::span<const glm::uvec2> edges, std::span<const glm::vec4> positions, const MarkSheet& sheet);

// Springs that act in this run, by group: threads, shear, bend.
void mark_springs(const ClothModel& model, const SimParams& params, std::span<const glm::vec4> positions,
                  const MarkSheet& sheet);

void mark_pins(const ClothModel& model, std::span<const glm::vec4> positions, const MarkSheet& sheet);

// Contacts and impacts of the last pass where the cloth is now, each with its normal, as long as the cloth is thick or
// a little more.
void mark_contacts(const Simulation& simulation, std::span<const glm::vec4> positions, const MarkSheet& sheet);

// Boxes of the tree so many levels below its root, or the lowest.
void mark_boxes(TreePicture& tree, int depth, const SimParams& params, std::span<const glm::vec4> positions,
                const MarkSheet& sheet);

// Arrows on a lattice around the cloth: velocity of the air, or the pressure of the seed's wind.
void mark_wind(const SimParams& params, double time_s, std::span<const glm::vec4> positions, const MarkSheet& sheet);

}  // namespace nuno
