// The vertices that bodies are drawn from.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/triangle_mesh.h"

namespace nuno {

// Placed at radius normal + half_size corner, in the body's own axes.
struct BodyVertex
{
    glm::vec3 corner, normal;
};

struct BodyGeometry
{
    std::vector<BodyVertex> vertices;
    std::vector<std::uint32_t> indices;
};

// A ball whose eight parts can be moved apart: with a radius alone it is a ball, with a half length along y a capsule,
// with half sides and no radius a box.
void append_rounded_box(BodyGeometry& geometry);

// A mesh, its corners those of the faces; edges flatter than about 40 degrees are smooth.
void append_mesh(BodyGeometry& geometry, const TriangleMesh& mesh);

}  // namespace nuno
