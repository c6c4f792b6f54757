// Finds a plane for a part of a mesh, and all that has to hold for a proof over it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "collision/tree/chart_window.h"
#include "collision/tree/convex_polygon.h"
#include "collision/tree/mesh_sides.h"

namespace nuno {

class ChartBuilder
{
  public:
    // Rest positions [m] and faces, which must last as long as this does.
    ChartBuilder(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces);

    // A window that holds these faces and more around them; nothing where they do not all face one way, or where the
    // mesh does not cover the convex hull of their places once: a hole, a notch, two layers.
    std::optional<ChartWindow> window_of(std::span<const std::uint32_t> held);

  private:
    struct Plane
    {
        glm::dvec3 origin, normal, u, v;
    };
    // Sides of the rim from one corner of the hull to the next.
    struct Pocket
    {
        glm::dvec2 along;
        double slope = 0;
        std::vector<std::uint32_t> chain;  // vertices of the window, corners included
    };
    struct RimSide
    {
        std::uint32_t from, to;
    };

    void clear();
    bool choose_plane(std::span<const std::uint32_t> held);
    std::uint32_t place_vertex(std::uint32_t vertex);
    bool take(std::uint32_t face);
    bool spread();
    bool find_pockets();
    std::optional<Pocket> pocket_below(std::uint32_t from, std::uint32_t to) const;
    bool is_covered_once() const;
    ChartWindow finished() const;
    void cut_in_parts(ChartWindow& window) const;
    void choose_samples(ChartWindow& window) const;

    std::span<const glm::vec3> rest_;
    std::span<const glm::uvec3> mesh_faces_;
    MeshSides sides_;
    std::vector<std::uint32_t> number_of_;  // in the window, of each vertex of the mesh
    std::vector<bool> is_taken_;            // of each face of the mesh

    Plane plane_;
    std::vector<std::uint32_t> vertices_, faces_;  // of the window, by their numbers in the mesh
    std::vector<glm::vec2> places_;                // of vertices_ [m]
    std::vector<RimSide> open_rim_;                // sides of the rim inside the hull, by numbers in the window
    std::vector<Pocket> pockets_;
    ConvexPolygon hull_;
    double least_height_ = 0, longest_ = 0, stretch_ = 0;
};

}  // namespace nuno
