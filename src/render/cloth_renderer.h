// Draws sheets of cloth from a buffer of positions, wherever those come from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "model/texture_seams.h"
#include "render/pixel_box.h"
#include "render/split_vertices.h"
#include "render/vertex_normals.h"

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
    std::span<const glm::vec3> rest;      // positions [m], one a vertex, which tell how large a texture is; empty: 1 m
    const TextureSeams* seams = nullptr;  // of the uvs; nullptr: none
};

// How often textures repeat.
struct TextureScale
{
    float repeats = 1;                    // of the texture along a sheet
    std::optional<float> thread_spacing;  // [m], for programs that show threads
};

class ClothRenderer
{
  public:
    // Error where a texture cannot be read.
    explicit ClothRenderer(const ClothTopology& cloth);

    // Copies positions from the CPU into the renderer's own buffer and returns its name, for set_positions.
    GLuint upload_positions(std::span<const glm::vec4> positions);

    // Of the positions that were uploaded; nothing where those that are drawn are another buffer's.
    std::optional<Bounds> bounds() const;

    // Makes the kernel of its normals, unless it is there.
    void prepare(NormalKind kind) { normals_.prepare(kind); }

    // The cloth is drawn from this buffer (vec4 a vertex, xyz [m] used) from now on; computes its normals, and
    // folds where `kind` asks for them.
    void set_positions(GLuint positions, NormalKind kind);

    // Draws with a look's program and the uniform block View bound.
    void draw(const Program& program, const TextureScale& scale) const;

    // Draws the faces alone, for a program that is already in use.
    void draw_faces() const;

  private:
    struct Part
    {
        GLsizei first_index, index_count;
        std::size_t texture;  // of textures_
        glm::vec2 metres;     // of a sheet along u and v
    };

    VertexNormals normals_;
    std::optional<SplitVertices> split_;  // where textures have seams
    Buffer indices_, uvs_, uploaded_;
    VertexArray vertices_;
    std::vector<Texture> textures_;
    std::vector<Part> parts_;
    GLsizei index_count_;       // of all faces; after their indices come, where there are seams, those with copies
    GLuint positions_ = 0;      // drawn from
    Bounds uploaded_bounds_{};  // of uploaded_
};

}  // namespace nuno
