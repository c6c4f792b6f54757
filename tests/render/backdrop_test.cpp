// Floor and background that are kept from one picture to the next: no pixel may tell.
#include "render/backdrop.h"

#include <functional>

#include "gl/gl_test.h"
#include "render/bent_sheet.h"
#include "render/picture_compare.h"
#include "render/scene_view.h"

namespace nuno {
namespace {

class BackdropTest : public GlTest
{
  protected:
    BackdropTest()
    {
        params_.width = 320;
        params_.height = 180;
        params_.camera_elevation = 25;
        params_.camera_distance = 5;
        bodies_.spheres = {{{0.9f, 0.3f, 0.2f}, 0.2f}};
    }
    Picture draw(SceneView& view, glm::vec3 moved) const
    {
        std::vector<glm::vec4> positions = sheet_.positions;
        for (glm::vec4& position : positions) position += glm::vec4(moved, 0);
        Picture picture;
        view.draw_picture(params_, view.upload_positions(positions), {bodies_}, picture);
        return picture;
    }
    Picture draw_anew(glm::vec3 moved) const
    {
        SceneView view(sheet_.topology());
        return draw(view, moved);
    }
    // Cloth that moves before a camera that rests.
    void expect_that_nothing_tells(SceneView& view) const
    {
        for (const glm::vec3 moved :
             {glm::vec3(0), glm::vec3(0.3f, 0, 0), glm::vec3(-3, 0, 2), glm::vec3(0, 2.5f, 0), glm::vec3(0, -0.5f, 9)})
            EXPECT_EQ(draw(view, moved).rgba, draw_anew(moved).rgba) << moved.x << " " << moved.y << " " << moved.z;
    }

    ViewParams params_;
    Bodies bodies_;
    BentSheet sheet_ = bent_sheet(17, texture_path("print.bmp"));
};

TEST_F(BackdropTest, pictures_are_those_of_a_view_that_kept_nothing)
{
    SceneView view(sheet_.topology());
    for (const Look look : {Look::gouraud, Look::phong, Look::cloth})
        for (const float elevation : {12.0f, 35.0f, 90.0f}) {
            SCOPED_TRACE(testing::Message() << "look " << int(look) << ", light at " << elevation);
            params_.look = look;
            params_.light_elevation = elevation;
            expect_that_nothing_tells(view);
        }
}

TEST_F(BackdropTest, a_shadow_that_moves_is_seen_to)
{
    for (const Look look : {Look::gouraud, Look::cloth}) {
        params_.look = look;
        SceneView view(sheet_.topology());
        const glm::vec3 aside(0.6f, 0, 0), up(0, 30, 0);
        for (int i = 0; i < 3; ++i) draw(view, aside);
        const Picture there = draw(view, aside), gone = draw(view, up);
        EXPECT_GT(compare_pictures(there, gone).changed_part, 0.02);
        params_.shadow = 0;
        const Picture bare = draw(view, aside);
        EXPECT_GT(compare_pictures(there, bare).mean, 0.1);
        params_.shadow = 1;
    }
}

TEST_F(BackdropTest, all_that_it_shows_is_drawn_anew_where_it_has_changed)
{
    SceneView view(sheet_.topology());
    const std::vector<std::function<void()>> changes{[&] { params_.camera_azimuth += 40; },
                                                     [&] { params_.background = Background::night; },
                                                     [&] { params_.floor = 0; },
                                                     [&] { params_.floor = 1; },
                                                     [&] { params_.light_size = 40; },
                                                     [&] { params_.key_light *= 0.5f; },
                                                     [&] { params_.width = 200; },
                                                     [&] {
                                                         bodies_.planes = {{{0.6f, 0.8f, 0}, -0.5f}};
                                                     },
                                                     [&] { params_.camera_elevation = -20; }};
    for (const auto& change : changes) {
        change();
        for (int i = 0; i < 3; ++i) EXPECT_EQ(draw(view, {}).rgba, draw_anew({}).rgba);
    }
}

TEST_F(BackdropTest, only_the_pixels_near_the_shadow_are_drawn_each_time)
{
    params_.light_elevation = 60;
    const ViewBlock block = make_view_block(params_, make_camera(params_, 16.0f / 9), {{0, 1, 0}, -0.5f, {}});
    const Bounds small{{-0.1f, 0, -0.1f}, {0.1f, 0.2f, 0.1f}};
    const PixelBox box = floor_shadow_pixels(block, {&small, 1}, 0.05f, {320, 180});
    EXPECT_LT(box.low.x, box.high.x);
    EXPECT_LT((box.high.x - box.low.x) * (box.high.y - box.low.y), 320 * 180 / 20);
    const Bounds away{{1000, 0, 0}, {1001, 1, 1}};
    const PixelBox none = floor_shadow_pixels(block, {&away, 1}, 0.05f, {320, 180});
    EXPECT_EQ(none.low, none.high);
}

}  // namespace
}  // namespace nuno
