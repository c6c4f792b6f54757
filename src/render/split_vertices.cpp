// The list of the vertices that are drawn, and the kernel that gathers by it.
#include "render/split_vertices.h"

#include <numeric>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/barriers.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {

SplitVertices::SplitVertices(std::span<const std::uint32_t> copies, std::uint32_t vertex_count)
    : program_(compute_program("render/split_vertices.comp")),
      vertex_count_(vertex_count),
      drawn_count_(vertex_count + static_cast<std::uint32_t>(copies.size())),
      positions_(drawn_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY),
      normals_(drawn_count_ * sizeof(glm::vec4), nullptr, GL_DYNAMIC_COPY),
      sources_view_(GL_R32UI),
      positions_view_(GL_RGBA32F),
      normals_view_(GL_RGBA32F)
{
    std::vector<std::uint32_t> sources(vertex_count);
    std::iota(sources.begin(), sources.end(), 0u);
    sources.insert(sources.end(), copies.begin(), copies.end());
    sources_ = make_buffer(sources, GL_STATIC_DRAW);
    sources_view_.view(sources_.id(), sources_.size_bytes());
    program_.set(LOCATION_SPLIT_COUNT, drawn_count_);
}

void SplitVertices::update(GLuint positions, GLuint normals)
{
    const std::size_t bytes = vertex_count_ * sizeof(glm::vec4);
    positions_view_.view(positions, bytes);
    positions_view_.bind(UNIT_SPLIT_POSITIONS);
    normals_view_.view(normals, bytes);
    normals_view_.bind(UNIT_SPLIT_NORMALS);
    sources_view_.bind(UNIT_SPLIT_SOURCES);
    positions_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_SPLIT_POSITIONS);
    normals_.bind_block(GL_SHADER_STORAGE_BUFFER, BLOCK_SPLIT_NORMALS);
    program_.use();
    barrier_compute_to_compute();
    barrier_draw_to_compute();
    glDispatchCompute((drawn_count_ + NORMAL_GROUP_SIZE - 1) / NORMAL_GROUP_SIZE, 1, 1);
}

}  // namespace nuno
