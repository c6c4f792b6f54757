// Putting sheets together: masses, pins, starts, and meshes that are no cloth.
#include "model/cloth_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/error.h"
#include "model/cloth_state.h"
#include "support/sheets.h"

namespace nuno {
namespace {

using testing::HasSubstr;

std::string refusal(const SheetSource& source)
{
    try {
        build_cloth_model(std::span(&source, 1), MassLumping::area);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ClothModel, the_vertices_carry_the_whole_area_either_way)
{
    for (const MassLumping lumping : {MassLumping::area, MassLumping::equal}) {
        const ClothModel model = square_cloth(9, 2, {}, lumping);
        EXPECT_NEAR(std::accumulate(model.areas.begin(), model.areas.end(), 0.0), 4.0, 1e-5);
    }
    const ClothModel by_area = square_cloth(9, 2, {}, MassLumping::area);
    const float cell = 0.25f * 0.25f;
    EXPECT_NEAR(by_area.areas[4 * 9 + 4], cell, 1e-6f) << "an inner vertex carries one cell";
    EXPECT_NEAR(by_area.areas[0] + by_area.areas[8], cell / 2, 1e-6f)
        << "corners carry a third of their one or two faces";
}

TEST(ClothModel, several_sheets_keep_apart)
{
    std::vector<SheetSource> sources{square_sheet(5, 1, {0}), square_mesh(4, 1)};
    const ClothModel model = build_cloth_model(sources, MassLumping::area);
    ASSERT_EQ(model.sheets.size(), 2u);
    EXPECT_EQ(model.sheets[1].first_vertex, 25u);
    EXPECT_EQ(model.vertex_count(), 41u);
    for (const Spring& spring : model.springs) EXPECT_EQ(spring.a < 25, spring.b < 25);
    for (std::uint32_t f = model.sheets[1].first_face; f < model.faces.size(); ++f) EXPECT_GE(model.faces[f].x, 25u);
    EXPECT_EQ(std::accumulate(model.pinned.begin(), model.pinned.end(), 0), 1);
}

TEST(ClothModel, copies_at_the_seams_of_textures_count_on_from_the_vertices_of_all_sheets)
{
    SheetSource seamed = square_mesh(2, 1);
    ASSERT_EQ(seamed.mesh.faces.size(), 2u);
    const std::uint32_t corner = seamed.mesh.faces[1].z;
    seamed.mesh.seams = {{corner}, {{7, 7}}, seamed.mesh.faces};
    seamed.mesh.seams.faces[1].z = 4;
    const SheetSource plain = square_sheet(3, 1);
    EXPECT_TRUE(build_cloth_model(std::span(&plain, 1), MassLumping::area).seams.empty());
    const std::vector<SheetSource> sources{plain, seamed, seamed};
    const ClothModel model = build_cloth_model(sources, MassLumping::area);
    EXPECT_EQ(model.seams.vertices, (std::vector<std::uint32_t>{9 + corner, 13 + corner}));
    EXPECT_EQ(model.seams.uvs.size(), 2u);
    ASSERT_EQ(model.seams.faces.size(), model.faces.size());
    EXPECT_EQ(model.seams.faces[0], model.faces[0]);
    EXPECT_EQ(model.seams.faces[9].z, 17u);
    EXPECT_EQ(model.seams.faces[11].z, 18u);
    EXPECT_EQ(model.seams.faces[11].x, model.faces[11].x);
}

TEST(ClothModel, meshes_that_are_no_cloth_are_refused_with_the_element)
{
    SheetSource s = square_sheet(3, 1);
    s.mesh.positions[4].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(refusal(s), HasSubstr("vertex 4"));
    s = square_sheet(3, 1);
    s.mesh.faces[2].z = 99;
    EXPECT_THAT(refusal(s), HasSubstr("face 2 names vertex 99"));
    s = square_sheet(3, 1);
    s.mesh.faces[1] = {0, 1, 2};
    EXPECT_THAT(refusal(s), HasSubstr("face 1 (vertices 0 1 2, counted from 0) has no area"));
    s = square_sheet(3, 1);
    s.mesh.positions.emplace_back(5, 5, 5);
    EXPECT_THAT(refusal(s), HasSubstr("vertex 9 belongs to no face"));
    EXPECT_THAT(refusal(SheetSource{}), HasSubstr("no vertices"));
    s = square_sheet(3, 1, {9});
    EXPECT_THAT(refusal(s), HasSubstr("pin 9"));
    s = square_sheet(3, 1);
    s.start.resize(2);
    EXPECT_THAT(refusal(s), HasSubstr("start positions"));
}

TEST(ClothState, the_seed_shifts_free_vertices_by_no_more_than_the_jitter)
{
    const ClothModel model = square_cloth(6, 1, {0, 5});
    SimParams params;
    params.jitter = 0.001f;
    const ClothState exact = start_state(model, params);
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v)
        EXPECT_EQ(glm::vec3(exact.positions[v]), model.start_positions[v]);
    params.seed = 4;
    const ClothState shifted = start_state(model, params);
    EXPECT_EQ(state_hash(shifted), state_hash(start_state(model, params)));
    EXPECT_NE(state_hash(shifted), state_hash(exact));
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v)
        for (int c = 0; c < 3; ++c) {
            const float shift = shifted.positions[v][c] - exact.positions[v][c];
            EXPECT_LE(std::abs(shift), model.pinned[v] ? 0.0f : 0.00101f);
        }
}

TEST(ClothState, the_first_vertex_that_is_lost_is_found)
{
    std::vector<glm::vec4> values(10, glm::vec4(-999'999.0f));
    EXPECT_EQ(first_lost(values), std::nullopt);
    values[7].z = std::numeric_limits<float>::infinity();
    values[8].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(first_lost(values), 7u);
    values[5].y = -1e6f;
    EXPECT_EQ(first_lost(values), 5u);
}

}  // namespace
}  // namespace nuno
