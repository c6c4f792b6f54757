// What does not change while a cloth moves: mesh, springs, vertex areas and pins, for all sheets of a scene together.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/sim_params.h"
#include "model/spring_table.h"
#include "model/triangle_mesh.h"

namespace nuno {

// A pinned vertex that a handle (Bodies::handles) carries along.
struct HandlePin
{
    std::uint32_t vertex, handle;
    bool operator==(const HandlePin&) const = default;
};

// One sheet as a scene asks for it.
struct SheetSource
{
    std::string name;
    TriangleMesh mesh;                      // the rest shape, in place
    std::vector<glm::vec3> start;           // start positions; empty: the rest shape
    std::vector<std::uint32_t> pins;        // vertices that do not move
    std::vector<HandlePin> handle_pins;     // vertices that move with a handle; one is enough for a vertex
    int columns = 0, rows = 0;              // of a grid sheet; 0, 0: any mesh
    std::vector<std::uint32_t> grid_order;  // vertex (column i, row j) is number j columns + i of it; empty: in order
};

// Where a sheet lies in the arrays of the model.
struct Sheet
{
    std::string name;
    std::uint32_t first_vertex, vertex_count;
    std::uint32_t first_face, face_count;
    int columns, rows;                      // 0, 0: no grid
    std::vector<std::uint32_t> grid_order;  // of a grid whose vertices are not in rows, as in SheetSource

    bool is_grid() const { return columns > 0; }
    // Vertex of the model at column i, row j of a grid.
    std::uint32_t grid_vertex(int i, int j) const
    {
        const auto place = static_cast<std::uint32_t>(j * columns + i);
        return first_vertex + (grid_order.empty() ? place : grid_order[place]);
    }
};

struct ClothModel
{
    std::vector<glm::vec3> rest_positions, start_positions;  // [m], one a vertex
    std::vector<glm::vec2> uvs;
    TextureSeams seams;  // of all sheets together; for pictures and files alone
    std::vector<glm::uvec3> faces;
    std::vector<glm::vec3> face_warps;   // unit direction of the warp in each face at rest
    std::vector<float> areas;            // [m2] of cloth that a vertex carries
    std::vector<std::uint8_t> pinned;    // to its place or to a handle
    std::vector<HandlePin> handle_pins;  // in order of their vertices
    std::vector<Spring> springs;
    SpringTable spring_table;
    std::vector<Sheet> sheets;

    std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(rest_positions.size()); }
};

// Error naming the sheet where its mesh, pins or start positions do not fit.
ClothModel build_cloth_model(std::span<const SheetSource> sheets, MassLumping lumping);

// A flat grid of columns x rows vertices, the corner (column 0, row 0) at `origin`, columns along `across` and rows
// along `down` (whole sides, [m]); two triangles a cell, both cut along the same diagonal.
TriangleMesh grid_mesh(int columns, int rows, glm::vec3 origin, glm::vec3 across, glm::vec3 down);

}  // namespace nuno
