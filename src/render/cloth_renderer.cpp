// Sheets of cloth on the device.
#include "render/cloth_renderer.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <map>

#include "gl/barriers.h"
#include "render/texture_file.h"
#include "render/uv_scale.h"
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

bool has_seams(const ClothTopology& cloth) { return cloth.seams != nullptr && !cloth.seams->empty(); }

std::vector<glm::uvec3> drawn_faces(const ClothTopology& cloth)
{
    std::vector<glm::uvec3> faces(cloth.faces.begin(), cloth.faces.end());
    if (has_seams(cloth)) faces.insert(faces.end(), cloth.seams->faces.begin(), cloth.seams->faces.end());
    return faces;
}

std::vector<glm::vec2> drawn_uvs(const ClothTopology& cloth)
{
    std::vector<glm::vec2> uvs(cloth.uvs.begin(), cloth.uvs.end());
    if (has_seams(cloth)) uvs.insert(uvs.end(), cloth.seams->uvs.begin(), cloth.seams->uvs.end());
    return uvs;
}

// Metres along u and v of the texture of a sheet.
glm::vec2 metres_of(const ClothTopology& cloth, const DrawnSheet& sheet)
{
    if (cloth.rest.empty()) return glm::vec2(1);
    if (!has_seams(cloth))
        return metres_of_uv(cloth.faces.subspan(sheet.first_face, sheet.face_count), cloth.rest, cloth.uvs);
    const std::span<const glm::uvec3> faces(cloth.seams->faces);
    return metres_of_uv(faces.subspan(sheet.first_face, sheet.face_count), with_copies(cloth.rest, *cloth.seams),
                        drawn_uvs(cloth));
}

}  // namespace

ClothRenderer::ClothRenderer(const ClothTopology& cloth)
    : normals_(cloth.faces, cloth.vertex_count),
      indices_(make_buffer(drawn_faces(cloth), GL_STATIC_DRAW)),
      uvs_(make_buffer(drawn_uvs(cloth), GL_STATIC_DRAW)),
      index_count_(static_cast<GLsizei>(3 * cloth.faces.size()))
{
    assert(cloth.uvs.size() == cloth.vertex_count);
    std::map<std::filesystem::path, std::size_t> known;
    for (const DrawnSheet& sheet : cloth.sheets) {
        assert(sheet.first_face + sheet.face_count <= cloth.faces.size());
        const auto [texture, is_new] = known.try_emplace(sheet.texture, textures_.size());
        if (is_new) textures_.push_back(load_texture(sheet.texture));
        const std::size_t first_face = sheet.first_face + (has_seams(cloth) ? cloth.faces.size() : 0);
        parts_.push_back({static_cast<GLsizei>(3 * first_face), static_cast<GLsizei>(3 * sheet.face_count),
                          texture->second, metres_of(cloth, sheet)});
    }
    if (has_seams(cloth)) split_.emplace(cloth.seams->vertices, cloth.vertex_count);
    vertices_.attribute(ATTRIBUTE_POSITION, slot_positions, 3);
    vertices_.attribute(ATTRIBUTE_NORMAL, slot_normals, 4);
    vertices_.attribute(ATTRIBUTE_UV, slot_uvs, 2);
    vertices_.vertices(slot_normals, split_ ? split_->normals() : normals_.buffer().id(), sizeof(glm::vec4));
    vertices_.vertices(slot_uvs, uvs_.id(), sizeof(glm::vec2));
    vertices_.indices(indices_.id());
}

GLuint ClothRenderer::upload_positions(std::span<const glm::vec4> positions)
{
    if (uploaded_.size_bytes() != positions.size_bytes())
        uploaded_ = Buffer(positions.size_bytes(), nullptr, GL_STREAM_DRAW);
    uploaded_.update(0, std::as_bytes(positions));
    uploaded_bounds_ = bounds_of(positions);
    return uploaded_.id();
}

std::optional<Bounds> ClothRenderer::bounds() const
{
    if (positions_ == 0 || positions_ != uploaded_.id()) return std::nullopt;
    return uploaded_bounds_;
}

void ClothRenderer::set_positions(GLuint positions, NormalKind kind)
{
    positions_ = positions;
    normals_.update(positions, kind);
    if (split_) split_->update(positions, normals_.buffer().id());
    vertices_.vertices(slot_positions, split_ ? split_->positions() : positions, sizeof(glm::vec4));
    barrier_compute_to_draw();
}

void ClothRenderer::draw(const Program& program, const TextureScale& scale) const
{
    program.set(LOCATION_TEXTURE_SCALE, scale.repeats);
    program.use();
    vertices_.bind();
    for (const Part& part : parts_) {
        textures_[part.texture].bind(UNIT_CLOTH_TEXTURE);
        if (scale.thread_spacing)
            program.set(LOCATION_WEAVE_SCALE, part.metres / (*scale.thread_spacing * WEAVE_THREADS));
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
