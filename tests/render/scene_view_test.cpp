// What a picture shows: cloth lit on both sides in either look, its texture, spheres, floor, shadow and background.
#include "render/scene_view.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "gl/gl_test.h"
#include "render/bent_sheet.h"
#include "render/picture_compare.h"

namespace nuno {
namespace {

class SceneViewTest : public GlTest
{
  protected:
    SceneViewTest()
    {
        params.width = 320;
        params.height = 180;
    }
    Picture draw(const BentSheet& sheet)
    {
        SceneView view(sheet.topology());
        Picture picture;
        view.draw_picture(params, view.upload_positions(sheet.positions), {bodies}, picture);
        return picture;
    }
    // The middle of the cloth as the parameters place it.
    static glm::vec3 cloth_colour(const Picture& picture) { return mean_colour(picture, 0.42, 0.3, 0.58, 0.6); }
    static float brightness(glm::vec3 colour) { return (colour.r + colour.g + colour.b) / 3; }

    ViewParams params;
    Bodies bodies;
};

TEST_F(SceneViewTest, gouraud_look_matches_its_reference)
{
    expect_matches_reference(draw(bent_sheet(33, texture_path("weave.bmp"))), "gouraud");
}

TEST_F(SceneViewTest, phong_look_with_a_sphere_matches_its_reference)
{
    params.look = Look::phong;
    params.background = Background::daylight;
    params.texture_scale = 1.5f;
    bodies.spheres = {{{0.6f, -0.2f, 0.3f}, 0.3f}};
    bodies.planes = {{{0, 1, 0}, -0.5f}};
    expect_matches_reference(draw(bent_sheet(33, texture_path("print.bmp"))), "phong");
}

TEST_F(SceneViewTest, the_looks_differ_but_little)
{
    const BentSheet sheet = bent_sheet(17, texture_path("stripe.bmp"));
    const Picture gouraud = draw(sheet);
    params.look = Look::phong;
    const PictureDifference difference = compare_pictures(gouraud, draw(sheet));
    EXPECT_GT(difference.mean, 0.05);
    EXPECT_LT(difference.mean, 5.0);
}

TEST_F(SceneViewTest, cloth_is_lit_on_both_sides_in_both_looks)
{
    for (const Look look : {Look::gouraud, Look::phong})
        for (const float azimuth : {0.0f, 180.0f}) {
            params.look = look;
            params.camera_azimuth = azimuth;
            EXPECT_GT(brightness(cloth_colour(draw(bent_sheet(17, {})))), 90) << "seen from " << azimuth;
        }
}

TEST_F(SceneViewTest, the_side_that_is_turned_to_the_light_is_brighter)
{
    const BentSheet sheet = bent_sheet(17, {});
    params.camera_azimuth = 0;
    params.light_azimuth = 0;
    const float towards = brightness(cloth_colour(draw(sheet)));
    params.light_azimuth = 180;
    EXPECT_GT(towards, brightness(cloth_colour(draw(sheet))) + 20);
}

TEST_F(SceneViewTest, cloth_without_translucency_is_dark_against_the_light)
{
    const BentSheet sheet = bent_sheet(17, {});
    params.light_azimuth = params.camera_azimuth + 150;
    const float shining_through = brightness(cloth_colour(draw(sheet)));
    params.translucency = 0;
    EXPECT_GT(shining_through, brightness(cloth_colour(draw(sheet))) + 5);
}

TEST_F(SceneViewTest, the_texture_colours_the_cloth_and_repeats_as_asked)
{
    const Picture stripes = draw(bent_sheet(17, texture_path("stripe.bmp")));
    const Picture plain = draw(bent_sheet(17, {}));
    EXPECT_GT(glm::distance(cloth_colour(stripes), cloth_colour(plain)), 10);
    params.texture_scale = 1;
    EXPECT_GT(compare_pictures(stripes, draw(bent_sheet(17, texture_path("stripe.bmp")))).changed_part, 0.02);
}

// The copies of the seam against vertices that are really two, on a flat sheet, where both have the same light.
TEST_F(SceneViewTest, a_seam_of_the_texture_shows_each_side_as_its_own)
{
    BentSheet sheet = bent_sheet(17, texture_path("print.bmp"));
    for (glm::vec4& position : sheet.positions) position.z = 0;
    BentSheet twice = sheet;
    TextureSeams seams{{}, {}, sheet.faces};
    for (std::size_t f = 0; f < sheet.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = sheet.faces[f][k];
            // Of the faces of the right half, those that begin at column 8.
            if (vertex % 17 != 8 ||
                std::max({sheet.faces[f].x % 17, sheet.faces[f].y % 17, sheet.faces[f].z % 17}) == 8)
                continue;
            const auto copy = static_cast<std::uint32_t>(sheet.positions.size() + seams.vertices.size());
            seams.vertices.push_back(vertex);
            seams.uvs.emplace_back(0, sheet.uvs[vertex].y);
            seams.faces[f][k] = copy;
            twice.positions.push_back(sheet.positions[vertex]);
            twice.uvs.push_back(seams.uvs.back());
            twice.faces[f][k] = copy;
        }
    ASSERT_GT(seams.vertices.size(), 16u);
    ClothTopology cloth = sheet.topology();
    cloth.seams = &seams;
    for (const Look look : {Look::gouraud, Look::phong, Look::cloth}) {
        params.look = look;
        SceneView view(cloth);
        Picture picture;
        view.draw_picture(params, view.upload_positions(sheet.positions), {bodies}, picture);
        EXPECT_LT(compare_pictures(picture, draw(twice)).mean, 0.01);
        EXPECT_GT(compare_pictures(picture, draw(sheet)).mean, 0.05) << "the seam is seen";
    }
}

TEST_F(SceneViewTest, two_sheets_wear_their_own_textures)
{
    params.camera_azimuth = 0;
    BentSheet sheet = bent_sheet(17, {});
    const std::uint32_t half = static_cast<std::uint32_t>(sheet.faces.size() / 2);
    sheet.sheets = {{0, half, texture_path("print.bmp")}, {half, half, {}}};
    const Picture both = draw(sheet);
    sheet.sheets = {{0, 2 * half, {}}};
    const Picture plain = draw(sheet);
    EXPECT_GT(glm::distance(mean_colour(both, 0.45, 0.2, 0.55, 0.3), mean_colour(plain, 0.45, 0.2, 0.55, 0.3)), 40);
    EXPECT_EQ(mean_colour(both, 0.45, 0.6, 0.55, 0.7), mean_colour(plain, 0.45, 0.6, 0.55, 0.7));
}

TEST_F(SceneViewTest, cloth_follows_the_buffer_it_is_drawn_from)
{
    const BentSheet sheet = bent_sheet(17, {});
    SceneView view(sheet.topology());
    std::vector<glm::vec4> away = sheet.positions;
    for (glm::vec4& position : away) position.x += 100;
    const Buffer here = make_buffer(sheet.positions, GL_STATIC_DRAW);
    const Buffer there = make_buffer(away, GL_STATIC_DRAW);
    Picture with, without, again;
    view.draw_picture(params, here.id(), {bodies}, with);
    view.draw_picture(params, there.id(), {bodies}, without);
    view.draw_picture(params, here.id(), {bodies}, again);
    EXPECT_GT(compare_pictures(with, without).changed_part, 0.08);
    EXPECT_EQ(with.rgba, again.rgba);
}

// Of positions that were uploaded it is known where they are, and only there samples are drawn; of others it is not.
TEST_F(SceneViewTest, uploaded_positions_are_drawn_as_those_of_any_buffer)
{
    const BentSheet sheet = bent_sheet(17, texture_path("print.bmp"));
    SceneView view(sheet.topology());
    const Buffer buffer = make_buffer(sheet.positions, GL_STATIC_DRAW);
    bodies.spheres = {{{0.9f, 0.3f, 0.2f}, 0.2f}};
    bodies.capsules = {{{-0.9f, -0.3f, 0}, {-0.7f, 0.9f, 0.3f}, 0.1f}};
    bodies.boxes.resize(1);
    bodies.boxes[0].centre = {0, -0.4f, 0.5f};
    bodies.boxes[0].size = {1, 0.2f, 0.2f};
    for (const float distance : {0.3f, 1.0f, 2.6f, 12.0f})
        for (const float azimuth : {10.0f, 130.0f, -100.0f}) {
            params.camera_distance = distance;
            params.camera_azimuth = azimuth;
            Picture everywhere, within;
            view.draw_picture(params, buffer.id(), {bodies}, everywhere);
            view.draw_picture(params, view.upload_positions(sheet.positions), {bodies}, within);
            EXPECT_EQ(everywhere.rgba, within.rgba) << distance << " m, " << azimuth << " degrees";
        }
}

TEST_F(SceneViewTest, samples_smooth_the_edge_of_a_body)
{
    params.floor = 0;
    params.translucency = params.fill_light = params.key_light = params.ambient = 0;
    bodies.spheres = {{{0, 0.4f, 0.8f}, 0.5f}};
    const BentSheet sheet = bent_sheet(5, {});
    // The ball and the cloth are black, the background is bright: what is neither lies on an edge.
    const auto grey_pixels = [&](int samples) {
        params.samples = samples;
        const Picture picture = draw(sheet);
        int count = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) count += picture.rgba[i] > 8 && picture.rgba[i] < 120;
        return count;
    };
    EXPECT_EQ(grey_pixels(1), 0);
    EXPECT_GT(grey_pixels(4), 100);
}

TEST_F(SceneViewTest, a_sphere_hides_the_cloth_behind_it)
{
    const BentSheet sheet = bent_sheet(17, texture_path("print.bmp"));
    params.camera_azimuth = 0;
    const glm::vec3 cloth = cloth_colour(draw(sheet));
    bodies.spheres = {{{0, 0.4f, 0.8f}, 0.3f}};
    const glm::vec3 ball = cloth_colour(draw(sheet));
    EXPECT_GT(glm::distance(cloth, ball), 20);
    EXPECT_GT(ball.r, ball.b) << "spheres are of clay";
}

TEST_F(SceneViewTest, cloth_darkens_the_floor_under_it)
{
    params.light_elevation = 90;
    params.camera_elevation = 40;
    params.camera_target_y = -0.4f;
    const BentSheet sheet = bent_sheet(17, {});
    const Picture shadowed = draw(sheet);
    params.shadow = 0;
    const Picture bare = draw(sheet);
    EXPECT_GT(compare_pictures(shadowed, bare).changed_part, 0.01);
    double brighter = 0;
    for (std::size_t i = 0; i < bare.rgba.size(); ++i) brighter += shadowed.rgba[i] > bare.rgba[i] + 2;
    EXPECT_EQ(brighter, 0);
}

TEST_F(SceneViewTest, the_floor_hides_nothing_from_below)
{
    const BentSheet sheet = bent_sheet(17, texture_path("print.bmp"));
    params.camera_elevation = -40;
    params.camera_distance = 4;
    const Picture with_floor = draw(sheet);
    params.floor = 0;
    EXPECT_EQ(with_floor.rgba, draw(sheet).rgba);
}

TEST_F(SceneViewTest, a_plane_of_the_scene_is_shown_in_place_of_the_floor)
{
    const BentSheet sheet = bent_sheet(17, {});
    params.floor_height = -1;
    const Picture low = draw(sheet);
    bodies.planes = {{{0, 1, 0}, -1.0f}};
    EXPECT_EQ(low.rgba, draw(sheet).rgba);
    bodies.planes = {{{0.6f, 0.8f, 0}, -0.5f}};
    EXPECT_GT(compare_pictures(low, draw(sheet)).changed_part, 0.02);
}

TEST_F(SceneViewTest, a_missing_texture_is_an_error_that_names_it)
{
    try {
        draw(bent_sheet(5, "nowhere/cloth.bmp"));
        FAIL() << "the texture was accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("nowhere/cloth.bmp"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace nuno
