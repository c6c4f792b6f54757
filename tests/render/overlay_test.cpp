// Overlays in a picture: marks where they are asked for, in front of cloth or seen through it, and cloth in the colours
// of numbers.
#include "render/overlay.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "gl/gl_test.h"
#include "render/bent_sheet.h"
#include "render/camera.h"
#include "render/colour_map.h"
#include "render/picture_compare.h"
#include "render/scene_view.h"

namespace nuno {
namespace {

constexpr glm::vec4 kRed{1, 0, 0, 1};

Mark dot(glm::vec3 place, float width = 12) { return {place, width, place, width, kRed}; }

class OverlayTest : public GlTest
{
  protected:
    OverlayTest() : view_(sheet_.topology()), positions_(view_.upload_positions(sheet_.positions))
    {
        params_.width = 320;
        params_.height = 180;
        params_.camera_azimuth = params_.camera_elevation = 0;
    }
    Picture draw(const Overlay* overlay)
    {
        view_.set_overlay(overlay);
        Picture picture;
        view_.draw_picture(params_, positions_, {bodies_}, picture);
        return picture;
    }
    glm::ivec2 pixel_of(glm::vec3 place) const
    {
        const glm::vec4 clip = make_camera(params_, 320.0f / 180.0f).view_projection * glm::vec4(place, 1);
        return {std::lround(160 * (1 + clip.x / clip.w) - 0.5f), std::lround(90 * (1 - clip.y / clip.w) - 0.5f)};
    }
    static glm::vec3 at(const Picture& picture, glm::ivec2 pixel)
    {
        const std::uint8_t* p = &picture.rgba[4 * static_cast<std::size_t>(pixel.y * picture.width + pixel.x)];
        return {p[0], p[1], p[2]};
    }
    static bool is_red(glm::vec3 c) { return c.r > 240 && c.g < 20 && c.b < 20; }
    static int red_pixels(const Picture& picture)
    {
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) count += is_red(at(picture, {x, y}));
        return count;
    }

    BentSheet sheet_ = bent_sheet(17, {});
    Bodies bodies_;
    SceneView view_;
    GLuint positions_;
    ViewParams params_;
};

TEST_F(OverlayTest, a_dot_lies_where_its_place_is_seen)
{
    const glm::vec3 place(0.8f, 0.3f, 0.4f);
    const Overlay overlay{{dot(place)}, {}, {}};
    for (const int samples : {1, 4}) {
        params_.samples = samples;
        const Picture bare = draw(nullptr), marked = draw(&overlay);
        EXPECT_TRUE(is_red(at(marked, pixel_of(place)))) << samples;
        // Of 12 pixels of a picture 720 high, in one of 180: 0.6 of that, as no mark is drawn finer.
        EXPECT_NEAR(red_pixels(marked), 3.14159 / 4 * 7.2 * 7.2, 18) << samples;
        EXPECT_EQ(bare.rgba, draw(nullptr).rgba) << "what is taken away leaves something";
        EXPECT_LT(compare_pictures(bare, marked).changed_part, 0.002);
    }
}

TEST_F(OverlayTest, a_stroke_covers_the_way_between_its_ends_and_thins_to_a_tip)
{
    const glm::vec3 from(-0.9f, 0.9f, 0.2f), to(0.9f, 0.9f, 0.2f);
    const Overlay overlay{{{from, 20, to, 0, kRed}}, {}, {}};
    const Picture picture = draw(&overlay);
    const auto height_at = [&](float part) {
        const int x = pixel_of(from + part * (to - from)).x;
        int count = 0;
        for (int y = 0; y < picture.height; ++y) count += is_red(at(picture, {x, y}));
        return count;
    };
    EXPECT_NEAR(height_at(0.02f), 12, 2);
    EXPECT_NEAR(height_at(0.5f), 6, 2);
    EXPECT_LE(height_at(0.95f), 2);
}

TEST_F(OverlayTest, cloth_hides_marks_behind_it_or_lets_them_shine_through)
{
    const glm::vec3 behind(0, 0.5f, -0.8f);
    const Overlay hidden{{dot(behind)}, {}, {}}, through{{}, {dot(behind)}, {}};
    for (const int samples : {1, 4}) {
        params_.samples = samples;
        const glm::ivec2 pixel = pixel_of(behind);
        const Picture bare = draw(nullptr);
        EXPECT_EQ(bare.rgba, draw(&hidden).rgba);
        const glm::vec3 cloth = at(bare, pixel), seen = at(draw(&through), pixel);
        EXPECT_NEAR(glm::distance(seen, glm::mix(cloth, glm::vec3(255, 0, 0), 0.3f)), 0, 6) << samples;
    }
}

TEST_F(OverlayTest, marks_in_the_surface_of_the_cloth_are_not_half_hidden)
{
    Overlay overlay;
    for (const glm::uvec3& face : sheet_.faces)
        overlay.on_cloth.push_back(
            {glm::vec3(sheet_.positions[face.x]), 3, glm::vec3(sheet_.positions[face.y]), 3, kRed});
    const Picture picture = draw(&overlay);
    int seen = 0, all = 0;
    for (const Mark& mark : overlay.on_cloth) {
        seen += at(picture, pixel_of(0.5f * (mark.from + mark.to))).g < 120;
        ++all;
    }
    EXPECT_GT(seen, 0.9 * all);
}

TEST_F(OverlayTest, a_stroke_that_passes_the_eye_is_cut_there)
{
    const glm::vec3 eye = make_camera(params_, 16.0f / 9).eye;
    const Overlay beside{{{glm::vec3(0.9f, 0.2f, 0), 6, eye + glm::vec3(0.5f, -0.3f, 2), 6, kRed}}, {}, {}};
    const Overlay behind{
        {dot(eye + glm::vec3(0, 0, 1)), {eye + glm::vec3(0, 0, 1), 9, eye + glm::vec3(1, 0, 2), 9, kRed}}, {}, {}};
    const int count = red_pixels(draw(&beside));
    EXPECT_GT(count, 20);
    EXPECT_LT(count, 2500);
    EXPECT_EQ(red_pixels(draw(&behind)), 0);
}

TEST_F(OverlayTest, numbers_of_vertices_and_of_faces_colour_the_cloth_where_they_are)
{
    // The upper half of the sheet is 1, the lower 0.
    ClothHeat of_vertices, of_faces{{}, true};
    for (std::size_t v = 0; v < sheet_.positions.size(); ++v) of_vertices.values.push_back(v < 9 * 17 ? 1.0f : 0.0f);
    for (std::size_t f = 0; f < sheet_.faces.size(); ++f) of_faces.values.push_back(f < 8 * 16 * 2 ? 1.0f : 0.0f);
    const glm::vec3 upper(0.1f, 0.8f, 0.05f), lower(0.1f, 0.25f, 0.1f);
    for (const ClothHeat& heat : {of_vertices, of_faces})
        for (const int samples : {1, 4}) {
            params_.samples = samples;
            const Overlay overlay{{}, {}, heat};
            const Picture picture = draw(&overlay);
            // Light only darkens: what is compared is the colour for its brightness.
            const auto hue = [](glm::vec3 colour) { return colour / glm::length(colour); };
            EXPECT_LT(glm::distance(hue(at(picture, pixel_of(upper))), hue(viridis(1))), 0.05) << samples;
            EXPECT_LT(glm::distance(hue(at(picture, pixel_of(lower))), hue(viridis(0))), 0.05) << samples;
        }
}

}  // namespace
}  // namespace nuno
