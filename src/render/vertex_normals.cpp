// The table of each vertex's faces, and the kernel that reads it.
#include "render/vertex_normals.h"

#include "gl/barriers.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

// The faces of each vertex: those of vertex v are corners[starts[v]] .. corners[starts[v + 1]], each the two other
// vertices.
struct CornerTable
{
    std::vector<std::uint32_t> starts;
    std::vector<glm::uvec2> corners;
};

CornerTable corner_table(std::span<const glm::uvec3> faces, std::uint32_t vertex_count)
{
    CornerTable table;
    table.starts.assign(vertex_count + 1, 0);
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k) ++table.starts[face[k] + 1];
    for (std::uint32_t v = 0; v < vertex_count; ++v) table.starts[v + 1] += table.starts[v];
    table.corners.resize(3 * faces.size());
    std::vector<std::uint32_t> next(table.starts.begin(), table.starts.end() - 1);
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k) table.corners[next[face[k]]++] = {face[(k + 1) % 3], face[(k + 2) % 3]};
    return table;
}

}  // namespace

VertexNormals::VertexNormals(std::span<const glm::uvec3> faces, std::uint32_t vertex_count)
    : vertex_count_(vertex_count),
      normals_(vertex_count * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY),
      positions_view_(GL_RGBA32F),
      starts_view_(GL_R32UI),
      corners_view_(GL_RG32UI)
{
    const CornerTable table = corner_table(faces, vertex_count);
    starts_ = make_buffer(table.starts, GL_STATIC_DRAW);
    corners_ = make_buffer(table.corners, GL_STATIC_DRAW);
    starts_view_.view(starts_.id(), starts_.size_bytes());
    corners_view_.view(corners_.id(), corners_.size_bytes());
}

void VertexNormals::prepare(NormalKind kind)
{
    std::optional<Program>& program = programs_[static_cast<std::size_t>(kind)];
    if (program) return;
    std::vector<Define> defines;
    if (kind == NormalKind::with_folds) defines = {{"FOLDS", "1"}};
    program = compute_program("render/normals.comp", defines);
    program->set(LOCATION_NORMAL_COUNT, vertex_count_);
}

void VertexNormals::update(GLuint positions, NormalKind kind)
{
    // Attached anew each time: the name of a deleted buffer may have come back as another one.
    positions_view_.view(positions, vertex_count_ * sizeof(glm::vec4));
    positions_view_.bind(UNIT_NORMAL_POSITIONS);
    starts_view_.bind(UNIT_CORNER_STARTS);
    corners_view_.bind(UNIT_CORNERS);
    normals_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_NORMALS);
    prepare(kind);
    programs_[static_cast<std::size_t>(kind)]->use();
    barrier_compute_to_compute();
    barrier_draw_to_compute();
    glDispatchCompute((vertex_count_ + NORMAL_GROUP_SIZE - 1) / NORMAL_GROUP_SIZE, 1, 1);
}

}  // namespace nuno
