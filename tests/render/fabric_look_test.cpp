// The look `cloth`: shadows on all that is drawn, light that comes through, sheen, threads, and nothing left behind for
// the other looks.
#include <glm/geometric.hpp>

#include "gl/gl_test.h"
#include "render/bent_sheet.h"
#include "render/fabric_block.h"
#include "render/picture_compare.h"
#include "render/scene_view.h"

namespace nuno {
namespace {

class FabricLookTest : public GlTest
{
  protected:
    FabricLookTest()
    {
        params.look = Look::cloth;
        params.width = 320;
        params.height = 180;
    }
    Picture draw(const BentSheet& sheet)
    {
        SceneView view(sheet.topology());
        return draw(view, sheet);
    }
    Picture draw(SceneView& view, const BentSheet& sheet)
    {
        Picture picture;
        view.draw_picture(params, view.upload_positions(sheet.positions), {bodies}, picture);
        return picture;
    }
    // Of a part of the picture.
    static float brightness(const Picture& picture, double x0, double y0, double x1, double y1)
    {
        const glm::vec3 colour = mean_colour(picture, x0, y0, x1, y1);
        return (colour.r + colour.g + colour.b) / 3;
    }
    static float cloth_brightness(const Picture& picture) { return brightness(picture, 0.42, 0.3, 0.58, 0.6); }

    ViewParams params;
    Bodies bodies;
};

TEST_F(FabricLookTest, matches_its_reference)
{
    bodies.spheres = {{{0.6f, -0.2f, 0.3f}, 0.3f}};
    bodies.planes = {{{0, 1, 0}, -0.5f}};
    expect_matches_reference(draw(bent_sheet(33, texture_path("weave.bmp"))), "cloth");
}

TEST_F(FabricLookTest, threads_of_a_near_cloth_match_their_reference)
{
    params.camera_distance = 0.35f;
    params.camera_target_y = 0.5f;
    params.light_elevation = 20;
    expect_matches_reference(draw(bent_sheet(33, texture_path("stripe.bmp"))), "cloth_threads");
}

TEST_F(FabricLookTest, a_body_in_the_light_darkens_the_cloth_behind_it)
{
    params.camera_azimuth = params.light_azimuth = 0;
    params.light_elevation = 10;
    params.camera_elevation = 40;
    const BentSheet sheet = bent_sheet(17, {});
    // Between lamp and cloth, but not between camera and cloth.
    bodies.spheres = {{{0, 0.7f, 1.6f}, 0.35f}};
    const float shadowed = brightness(draw(sheet), 0.45, 0.45, 0.55, 0.6);
    params.shadow = 0;
    EXPECT_GT(brightness(draw(sheet), 0.45, 0.45, 0.55, 0.6), shadowed + 20);
}

TEST_F(FabricLookTest, cloth_darkens_a_body_behind_it_and_nothing_gets_brighter)
{
    params.light_azimuth = 0;
    params.light_elevation = 35;
    params.camera_azimuth = 60;
    bodies.spheres = {{{0, 0.2f, -0.5f}, 0.3f}};
    const BentSheet sheet = bent_sheet(33, {});
    const Picture shadowed = draw(sheet);
    params.shadow = 0;
    const Picture bare = draw(sheet);
    EXPECT_GT(compare_pictures(shadowed, bare).changed_part, 0.02);
    for (std::size_t i = 0; i < bare.rgba.size(); ++i)
        ASSERT_LE(int(shadowed.rgba[i]), int(bare.rgba[i]) + 2) << "byte " << i;
}

TEST_F(FabricLookTest, a_sheet_alone_in_the_light_throws_no_shadow_on_itself)
{
    params.floor = 0;
    params.light_azimuth = 0;
    // Flat, so that no part of it can stand before another.
    BentSheet sheet = bent_sheet(33, {});
    for (glm::vec4& position : sheet.positions) position.z = 0;
    for (const float elevation : {5.0f, 35.0f, 70.0f}) {
        params.light_elevation = elevation;
        params.shadow = 1;
        const Picture with = draw(sheet);
        params.shadow = 0;
        EXPECT_LT(compare_pictures(with, draw(sheet)).mean, 0.02) << elevation;
    }
}

TEST_F(FabricLookTest, a_lamp_that_is_wider_throws_softer_shadows)
{
    params.light_elevation = 60;
    params.camera_elevation = 40;
    params.camera_target_y = -0.4f;
    params.floor_height = -1;
    bodies.spheres = {{{0, 0.5f, 0}, 0.3f}};
    const BentSheet sheet = bent_sheet(5, {});
    const auto half_lit = [&](float degrees) {
        params.light_size = degrees;
        params.shadow = 1;
        const Picture with = draw(sheet);
        params.shadow = 0;
        const Picture bare = draw(sheet);
        int count = 0;
        for (std::size_t i = 0; i < with.rgba.size(); i += 4) {
            const int taken = bare.rgba[i] - with.rgba[i];
            count += taken > 8 && taken < 60;
        }
        return count;
    };
    const int narrow = half_lit(0.5f), wide = half_lit(20);
    EXPECT_GT(narrow, 0);
    EXPECT_GT(wide, 2 * narrow);
}

TEST_F(FabricLookTest, light_from_behind_comes_through)
{
    const BentSheet sheet = bent_sheet(17, {});
    params.light_azimuth = params.camera_azimuth + 150;
    const float through = cloth_brightness(draw(sheet));
    params.translucency = 0;
    EXPECT_GT(through, cloth_brightness(draw(sheet)) + 8);
}

TEST_F(FabricLookTest, more_sheen_is_brighter_against_the_light)
{
    params.camera_azimuth = 0;
    params.light_azimuth = 105;
    params.light_elevation = 10;
    params.translucency = 0;
    params.sheen = 0;
    const BentSheet sheet = bent_sheet(33, texture_path("print.bmp"));
    const float bare = cloth_brightness(draw(sheet));
    params.sheen = 1;
    EXPECT_GT(cloth_brightness(draw(sheet)), bare + 3);
}

TEST_F(FabricLookTest, threads_are_seen_from_near_and_gone_from_afar)
{
    const BentSheet sheet = bent_sheet(17, {});
    const auto change_by_weave = [&] {
        params.weave = 1;
        const Picture with = draw(sheet);
        params.weave = 0;
        return compare_pictures(with, draw(sheet)).changed_part;
    };
    params.camera_distance = 0.4f;
    EXPECT_GT(change_by_weave(), 0.1);
    params.thread_spacing = 0.0004f;
    params.camera_distance = 2.6f;
    EXPECT_LT(change_by_weave(), 0.001);
}

TEST_F(FabricLookTest, a_look_is_the_same_after_the_others_were_shown)
{
    const BentSheet sheet = bent_sheet(17, texture_path("print.bmp"));
    SceneView view(sheet.topology());
    for (const Look look : {Look::gouraud, Look::cloth, Look::phong, Look::cloth, Look::gouraud}) {
        params.look = look;
        EXPECT_EQ(draw(view, sheet).rgba, draw(sheet).rgba) << static_cast<int>(look);
    }
}

// Each field of Fabric lies where the struct that is copied into it has it.
TEST_F(FabricLookTest, the_fabric_block_is_laid_out_as_its_struct)
{
    const LookPrograms programs = make_look_programs(Look::cloth);
    const GLuint program = programs.cloth.id();
    const auto offset_of = [&](const char* name) {
        GLuint index = 0;
        GLint offset = -1;
        glGetUniformIndices(program, 1, &name, &index);
        if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &offset);
        return offset;
    };
    EXPECT_EQ(offset_of("to_key_map"), GLint(offsetof(FabricBlock, to_key_map)));
    EXPECT_EQ(offset_of("key_map"), GLint(offsetof(FabricBlock, key_map)));
    EXPECT_EQ(offset_of("fabric"), GLint(offsetof(FabricBlock, fabric)));
    EXPECT_EQ(offset_of("sheen_fit"), GLint(offsetof(FabricBlock, sheen_fit)));
}

}  // namespace
}  // namespace nuno
