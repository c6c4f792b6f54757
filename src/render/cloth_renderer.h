// Draws sheets of cloth from a buffer of positions, wherever those come from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "render/vertex_normals.h"
#include "render/view_params.h"

namespace nuno {

// Faces that wear one texture.
struct DrawnSheet
{
    std::uint32_t first_face = 0, face_count = 0;
    std::filesystem::path texture;  // empty: plain off-white cloth
};

// What does not change while the cloth moves; read only while a renderer is made.
struct ClothTopology
{
    std::uint32_t vertex_count = 0;
    std::span<const glm::uvec3> faces;  // vertex indices, counter-clockwise seen from the front
    std::span<const glm::vec2> uvs;     // one a vertex; (0, 0) is the lower left corner of the texture
    std::span<const DrawnSheet> sheets;
};

class ClothRenderer
{
  public:
    // Error where a texture cannot be read.
    explicit ClothRenderer(const ClothTopology& cloth);

    // Copies positions from the CPU into the renderer's own buffer and returns its name, for set_positions.
    GLuint upload_positions(std::span<const glm::vec4> positions);

    // The cloth is drawn from this buffer (vec4 a vertex, xyz [m] used) from now on; computes its normals.
    void set_positions(GLuint positions);

    // Draws with the uniform block View bound.
    void draw(Look look, float texture_scale) const;

    // Draws the faces alone, for a program that is already in use.
    void draw_faces() const;

  private:
    struct Part
    {
        GLsizei first_index, index_count;
        std::size_t texture;  // of textures_
    };

    VertexNormals normals_;
    Program gouraud_, phong_;
    Buffer indices_, uvs_, uploaded_;
    VertexArray vertices_;
    std::vector<Texture> textures_;
    std::vector<Part> parts_;
    GLsizei index_count_;
};

}  // namespace nuno
