// Draws the spheres of a scene, all at once.
#pragma once

#include <span>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/vertex_array.h"
#include "model/collider.h"

namespace nuno {

class SphereRenderer
{
  public:
    SphereRenderer();

    // These spheres are drawn from now on.
    void set_spheres(std::span<const Sphere> spheres);

    // Draws with the uniform block View bound.
    void draw() const;

    // Draws the faces alone, for a program that is already in use and takes ATTRIBUTE_SPHERE.
    void draw_faces() const;

  private:
    Program program_;
    Buffer unit_sphere_, indices_, spheres_;
    VertexArray vertices_;
    GLsizei index_count_ = 0, sphere_count_ = 0;
};

}  // namespace nuno
