// Draws the bodies of a scene: all balls, capsules and boxes at once, and each mesh.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "model/body.h"
#include "render/pixel_box.h"

namespace nuno {

class BodyRenderer
{
  public:
    BodyRenderer();

    // These bodies are drawn from now on, where they are at `time_s`. Planes are not drawn here: the first is the floor.
    void set_bodies(const Bodies& bodies, double time_s);

    // Of each body where it is now.
    std::span<const Bounds> bounds() const { return bounds_; }

    // Draws the faces, for a program that is already in use and includes render/placed_body.glsl.
    void draw_faces() const;

  private:
    // Faces of one mesh of the vertex buffer, drawn as a run of instances.
    struct Part
    {
        std::size_t first_index;
        GLsizei index_count, instance_count;
        GLuint first_instance;
        Bounds corners;  // of its vertices, in the body's own axes
    };
    void build_geometry(const Bodies& bodies);

    Buffer geometry_, indices_, instances_;
    VertexArray vertices_;
    std::vector<Bounds> bounds_;
    std::vector<Part> parts_;                                 // the rounded box first, then each mesh
    std::vector<std::shared_ptr<const DistanceGrid>> built_;  // of the meshes in the vertex buffer
};

}  // namespace nuno
