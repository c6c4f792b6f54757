// The threads of the look `cloth`, and how large they are on a sheet.
#include "render/weave_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "model/cloth_model.h"
#include "render/uv_scale.h"
#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

TEST(WeaveMap, has_no_slope_on_the_whole_and_the_stated_brightness)
{
    const std::vector<std::uint8_t> texels = weave_texels();
    ASSERT_EQ(texels.size(), 4u * kWeaveSide * kWeaveSide);
    std::array<double, 3> mean{};
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (i % 4 < 3) mean[i % 4] += texels[i] / double(kWeaveSide) / kWeaveSide;
    // So from afar, where only the mean is left, the cloth is smooth and has its own colour.
    EXPECT_NEAR(mean[0], 128, 0.6);
    EXPECT_NEAR(mean[1], 128, 0.6);
    EXPECT_NEAR(mean[2] / 255 * double(WEAVE_BRIGHTEST), 1, 0.01);
}

TEST(WeaveMap, rises_and_falls_with_every_thread)
{
    const std::vector<std::uint8_t> texels = weave_texels();
    // Along a row through the middle of threads the slope changes its sign twice a thread.
    const std::size_t row = 4 * std::size_t(kWeaveSide) * (kWeaveSide / WEAVE_THREADS / 2);
    int changes = 0;
    for (int x = 0; x < kWeaveSide; ++x) {
        const int here = texels[row + 4 * std::size_t(x)] - 128;
        const int next = texels[row + 4 * std::size_t((x + 1) % kWeaveSide)] - 128;
        changes += (here < 0) != (next < 0);
    }
    EXPECT_GE(changes, 2 * WEAVE_THREADS - 8);
    EXPECT_LE(changes, 2 * WEAVE_THREADS + 8);
}

TEST(UvScale, is_the_size_of_a_grid_and_one_metre_without_a_texture)
{
    const TriangleMesh mesh = grid_mesh(5, 4, {1, 2, 3}, {1.5f, 0, 0}, {0, -0.8f, 0});
    const glm::vec2 metres = metres_of_uv(mesh.faces, mesh.positions, mesh.uvs);
    EXPECT_NEAR(metres.x, 1.5f, 1e-4f);
    EXPECT_NEAR(metres.y, 0.8f, 1e-4f);
    const std::vector<glm::vec2> none(mesh.positions.size(), glm::vec2(0));
    EXPECT_EQ(metres_of_uv(mesh.faces, mesh.positions, none), glm::vec2(1));
}

}  // namespace
}  // namespace nuno
