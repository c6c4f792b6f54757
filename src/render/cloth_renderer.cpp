// Sheets of cloth on the device.
#include "render/cloth_renderer.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <map>

#include "gl/barriers.h"
#include "render/texture_file.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

enum VertexSlot : GLuint
{
    slot_positions,
    slot_normals,
    slot_uvs
};

Texture load_texture(const std::filesystem::path& path)
{
    if (path.empty()) return Texture(1, 1, std::vector<std::uint8_t>{222, 216, 205, 255});
    const Picture picture = load_picture(path, max_texture_size());
    // A texture's first row is its lowest.
    const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
    std::vector<std::uint8_t> bottom_up(picture.rgba.size());
    for (std::size_t at = 0; at < bottom_up.size(); at += row)
        std::memcpy(bottom_up.data() + bottom_up.size() - row - at, picture.rgba.data() + at, row);
    return Texture(picture.width, picture.height, bottom_up);
}

}  // namespace

ClothRenderer::ClothRenderer(const ClothTopology& cloth)
    : normals_(cloth.faces, cloth.vertex_count),
      gouraud_(draw_program("render/cloth_gouraud.vert", "render/cloth_gouraud.frag")),
      phong_(draw_program("render/cloth_phong.vert", "render/cloth_phong.frag")),
      indices_(make_buffer(cloth.faces, GL_STATIC_DRAW)),
      uvs_(make_buffer(cloth.uvs, GL_STATIC_DRAW)),
      index_count_(static_cast<GLsizei>(3 * cloth.faces.size()))
{
    assert(cloth.uvs.size() == cloth.vertex_count);
    std::map<std::filesystem::path, std::size_t> known;
    for (const DrawnSheet& sheet : cloth.sheets) {
        assert(sheet.first_face + sheet.face_count <= cloth.faces.size());
        const auto [texture, is_new] = known.try_emplace(sheet.texture, textures_.size());
        if (is_new) textures_.push_back(load_texture(sheet.texture));
        parts_.push_back(
            {static_cast<GLsizei>(3 * sheet.first_face), static_cast<GLsizei>(3 * sheet.face_count), texture->second});
    }
    vertices_.attribute(ATTRIBUTE_POSITION, slot_positions, 3);
    vertices_.attribute(ATTRIBUTE_NORMAL, slot_normals, 3);
    vertices_.attribute(ATTRIBUTE_UV, slot_uvs, 2);
    vertices_.vertices(slot_normals, normals_.buffer().id(), sizeof(glm::vec4));
    vertices_.vertices(slot_uvs, uvs_.id(), sizeof(glm::vec2));
    vertices_.indices(indices_.id());
}

GLuint ClothRenderer::upload_positions(std::span<const glm::vec4> positions)
{
    if (uploaded_.size_bytes() != positions.size_bytes())
        uploaded_ = Buffer(positions.size_bytes(), nullptr, GL_STREAM_DRAW);
    uploaded_.update(0, std::as_bytes(positions));
    return uploaded_.id();
}

void ClothRenderer::set_positions(GLuint positions)
{
    normals_.update(positions);
    vertices_.vertices(slot_positions, positions, sizeof(glm::vec4));
    barrier_compute_to_draw();
}

void ClothRenderer::draw(Look look, float texture_scale) const
{
    const Program& program = look == Look::gouraud ? gouraud_ : phong_;
    program.set(LOCATION_TEXTURE_SCALE, texture_scale);
    program.use();
    vertices_.bind();
    for (const Part& part : parts_) {
        textures_[part.texture].bind(UNIT_CLOTH_TEXTURE);
        // OpenGL takes an offset in the index buffer as a pointer.
        const auto offset = static_cast<std::uintptr_t>(part.first_index) * sizeof(GLuint);
        const void* first = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
        glDrawElements(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, first);
    }
}

void ClothRenderer::draw_faces() const
{
    vertices_.bind();
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace nuno
