// The kernel's normals against the CPU's, and the layout of the block that the drawing programs share.
#include "render/vertex_normals.h"

#include <glm/geometric.hpp>
#include <random>

#include "gl/barriers.h"
#include "gl/gl_test.h"
#include "model/smooth_normals.h"
#include "render/bent_sheet.h"
#include "render/view_block.h"

namespace nuno {
namespace {

using VertexNormalsTest = GlTest;

std::vector<glm::vec4> kernel_normals(VertexNormals& normals, std::span<const glm::vec4> positions,
                                      NormalKind kind = NormalKind::plain)
{
    const Buffer buffer = make_buffer(positions, GL_STATIC_DRAW);
    normals.update(buffer.id(), kind);
    barrier_compute_to_readback();
    std::vector<glm::vec4> result(positions.size());
    normals.buffer().read(0, std::span(result));
    return result;
}

TEST_F(VertexNormalsTest, agree_with_the_cpu)
{
    BentSheet sheet = bent_sheet(40, {});
    std::mt19937 random(7);
    std::uniform_real_distribution<float> shift(-0.01f, 0.01f);
    for (glm::vec4& position : sheet.positions) position += glm::vec4(shift(random), shift(random), shift(random), 0);
    VertexNormals normals(sheet.faces, static_cast<std::uint32_t>(sheet.positions.size()));
    const std::vector<glm::vec4> kernel = kernel_normals(normals, sheet.positions);
    const std::vector<glm::vec3> reference = smooth_normals(sheet.positions, sheet.faces);
    for (std::size_t v = 0; v < reference.size(); ++v)
        ASSERT_LT(glm::distance(glm::vec3(kernel[v]), reference[v]), 1e-5f) << "vertex " << v;
}

TEST_F(VertexNormalsTest, follow_positions_from_one_buffer_to_the_next)
{
    const std::vector<glm::uvec3> faces = {{0, 1, 2}};
    VertexNormals normals(faces, 3);
    const std::vector<glm::vec4> flat = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
    const std::vector<glm::vec4> turned = {{0, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    EXPECT_EQ(kernel_normals(normals, flat)[0], glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(kernel_normals(normals, turned)[2], glm::vec4(1, 0, 0, 0));
}

TEST_F(VertexNormalsTest, faces_without_area_give_unit_normals)
{
    const std::vector<glm::uvec3> faces = {{0, 1, 2}, {1, 1, 3}};
    const std::vector<glm::vec4> positions = {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {5, 5, 5, 1}, {9, 9, 9, 1}};
    VertexNormals normals(faces, 5);
    for (const glm::vec4& normal : kernel_normals(normals, positions)) EXPECT_EQ(glm::length(normal), 1.0f);
    for (const glm::vec3& normal : smooth_normals(positions, faces)) EXPECT_EQ(glm::length(normal), 1.0f);
}

// A cylinder of radius r bends by 1 / r one way and not at all the other: 1 / (2 r) on the mean.
TEST_F(VertexNormalsTest, folds_are_the_mean_curvature_towards_the_normal)
{
    const float radius = 0.2f;
    BentSheet sheet = bent_sheet(41, {});
    for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
        const glm::vec2 at = sheet.uvs[v] * 0.4f;
        sheet.positions[v] = {radius * std::sin(at.x / radius), at.y, -radius * std::cos(at.x / radius), 1};
    }
    VertexNormals normals(sheet.faces, static_cast<std::uint32_t>(sheet.positions.size()));
    const std::size_t middle = 20 * 41 + 20;
    // The front looks towards +z, into the hollow.
    EXPECT_NEAR(kernel_normals(normals, sheet.positions, NormalKind::with_folds)[middle].w, 0.5f / radius, 0.1f);
    EXPECT_EQ(kernel_normals(normals, sheet.positions)[middle].w, 0.0f);
    for (glm::vec4& position : sheet.positions) position.z = -position.z;
    EXPECT_NEAR(kernel_normals(normals, sheet.positions, NormalKind::with_folds)[middle].w, -0.5f / radius, 0.1f);
}

// Each field of View lies where the struct that is copied into it has it.
TEST_F(VertexNormalsTest, the_view_block_is_laid_out_as_its_struct)
{
    const Program program = draw_program("render/floor.vert", "render/floor.frag");
    const auto offset_of = [&](const char* name) {
        GLuint index = 0;
        GLint offset = -1;
        glGetUniformIndices(program.id(), 1, &name, &index);
        if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
        return offset;
    };
    EXPECT_EQ(offset_of("view_projection"), GLint(offsetof(ViewBlock, view_projection)));
    EXPECT_EQ(offset_of("eye"), GLint(offsetof(ViewBlock, eye)));
    EXPECT_EQ(offset_of("key_light"), GLint(offsetof(ViewBlock, key_light)));
    EXPECT_EQ(offset_of("ground_light"), GLint(offsetof(ViewBlock, ground_light)));
    EXPECT_EQ(offset_of("horizon_colour"), GLint(offsetof(ViewBlock, horizon_colour)));
    EXPECT_EQ(offset_of("tile_dark"), GLint(offsetof(ViewBlock, tile_dark)));
    EXPECT_EQ(offset_of("floor_centre"), GLint(offsetof(ViewBlock, floor_centre)));
    EXPECT_EQ(offset_of("shadow_centre"), GLint(offsetof(ViewBlock, shadow_centre)));
    GLint bytes = 0;
    glGetActiveUniformBlockiv(program.id(), glGetUniformBlockIndex(program.id(), "View"), GL_UNIFORM_BLOCK_DATA_SIZE,
                              &bytes);
    EXPECT_EQ(bytes, GLint(sizeof(ViewBlock)));
}

}  // namespace
}  // namespace nuno
