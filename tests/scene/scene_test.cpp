// Scene files, good and bad.
#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kSheet = "[[sheet]]\ncolumns = 5\n";

Scene load(const std::string& text)
{
    const TemporaryDirectory directory;
    return load_scene(directory.write("test.toml", text).string());
}

std::string refusal(const std::string& text)
{
    try {
        const Scene scene = load(text);
        make_sheets(scene, scene.params);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "accepted";
}

TEST(Scene, every_scene_of_the_library_loads_has_a_title_and_ends_with_a_check)
{
    const std::vector<std::string> names = scene_names();
    EXPECT_THAT(names, testing::IsSupersetOf({"seed", "hang", "flag", "curtain", "drape", "gale"}));
    for (const std::string& name : names) {
        const Scene scene = load_scene(name);
        EXPECT_FALSE(scene.title.empty()) << name;
        EXPECT_FALSE(scene.check.bounds.empty()) << name;
        EXPECT_FALSE(make_sheets(scene, scene.params).empty()) << name;
    }
}

TEST(Scene, the_seed_is_17_by_17_in_the_x_y_plane)
{
    const Scene scene = load_scene("seed");
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    EXPECT_EQ(sheet.columns, 17);
    EXPECT_EQ(sheet.rows, 17);
    EXPECT_EQ(sheet.mesh.faces.size(), 2u * 16 * 16);
    for (const glm::vec3& p : sheet.mesh.positions) EXPECT_EQ(p.z, 0);
    EXPECT_EQ(scene.params.mass_lumping, MassLumping::equal);
}

TEST(Scene, keys_reach_the_parameters_the_sheets_and_the_bodies)
{
    const Scene scene = load(
        "title = \"t\"\n[params]\nwind_strength = 3\nmethod = \"explicit_euler\"\ncount_pass_through = true\n"
        "[view]\nlook = \"phong\"\n" +
        kSheet +
        "pins = [\"top\", \"left@0.5\", 24]\n"
        "[[sphere]]\nradius = 0.5\n[[plane]]\nnormal = [0, 2, 0]\noffset = -1.5\n"
        "[check]\nframes = 10\ncontacts = [1, inf]\n");
    EXPECT_EQ(scene.params.wind_strength, 3);
    EXPECT_EQ(scene.params.method, Method::explicit_euler);
    EXPECT_EQ(scene.params.count_pass_through, 1);
    ASSERT_EQ(scene.view.size(), 1u);
    EXPECT_EQ(scene.view[0].text, "phong");
    EXPECT_EQ(scene.colliders.spheres.at(0).radius, 0.5f);
    EXPECT_EQ(scene.colliders.planes.at(0).normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.check.frames, 10);
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    EXPECT_THAT(sheet.pins, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 10, 24));
}

TEST(Scene, resolution_sets_the_longer_side_and_keeps_the_cells)
{
    Scene scene = load("[[sheet]]\ncolumns = 9\nrows = 5\nacross = [2, 0, 0]\npins = [\"top_right\"]\n");
    scene.params.resolution = 33;
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    EXPECT_EQ(sheet.columns, 33);
    EXPECT_EQ(sheet.rows, 17);
    EXPECT_THAT(sheet.pins, testing::ElementsAre(32));
}

TEST(Scene, pleats_fold_the_start_without_stretching_a_thread)
{
    const Scene scene = load("[[sheet]]\ncolumns = 33\nrows = 3\nacross = [2, 0, 0]\npleats = 8\npleat_angle = 60\n");
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    ASSERT_EQ(sheet.start.size(), sheet.mesh.positions.size());
    for (std::size_t i = 0; i + 1 < 33; ++i)
        EXPECT_NEAR(glm::distance(sheet.start[i], sheet.start[i + 1]), 2.0 / 32, 1e-6) << i;
    EXPECT_NEAR(sheet.start[32].x - sheet.start[0].x, 2 * 0.5, 1e-5);
}

TEST(Scene, what_is_wrong_is_named_with_file_and_line)
{
    EXPECT_THAT(refusal("[params]\nwind_strenght = 1\n" + kSheet),
                AllOf(HasSubstr("test.toml:2"), HasSubstr("wind_strength")));
    EXPECT_THAT(refusal("[params]\ndamping = \"much\"\n" + kSheet),
                AllOf(HasSubstr("test.toml:2"), HasSubstr("0 to 1000")));
    EXPECT_THAT(refusal("[params]\ndamping = -1\n" + kSheet), HasSubstr("test.toml:2"));
    EXPECT_THAT(refusal("[params]\ndamping = inf\n" + kSheet), HasSubstr("test.toml:2"));
    EXPECT_THAT(refusal("[params]\ndamping = nan\n" + kSheet), HasSubstr("test.toml:2"));
    EXPECT_THAT(refusal("[params]\nsubsteps = 1.5\n" + kSheet), HasSubstr("test.toml:2"));
    EXPECT_THAT(refusal("[params]\nmethod = 1\n" + kSheet), HasSubstr("explicit_euler or symplectic_euler"));
    EXPECT_THAT(refusal("[params]\ndamping = [1]\n" + kSheet), HasSubstr("test.toml:2"));
    EXPECT_THAT(refusal("titel = \"x\"\n" + kSheet), AllOf(HasSubstr("test.toml:1"), HasSubstr("nearest is title")));
    EXPECT_THAT(refusal("title = 3\n" + kSheet), HasSubstr("test.toml:1"));
    EXPECT_THAT(refusal("not toml"), HasSubstr("test.toml:1"));
    EXPECT_THAT(refusal("title = \"no sheet\"\n"), HasSubstr("[[sheet]]"));
    EXPECT_THAT(refusal(""), HasSubstr("[[sheet]]"));
}

TEST(Scene, sheets_that_cannot_be_made_are_named_with_their_line)
{
    EXPECT_THAT(refusal("[[sheet]]\nname = \"a\"\n"), HasSubstr("test.toml:1"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 1\n"), HasSubstr("2 to 2048"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 100000\n"), HasSubstr("2 to 2048"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\nacross = [0, 0, 0]\n"), HasSubstr("no area"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\nacross = [1, 2]\n"), HasSubstr("three"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\nacross = [1, inf, 0]\n"), HasSubstr("three finite"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\npins = [\"topp\"]\n"), HasSubstr("nearest is top"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\npins = [\"top@2\"]\n"), HasSubstr("0 to 1"));
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\npins = [-3]\n"), HasSubstr("pins"));
    EXPECT_THAT(refusal("[[sheet]]\nmesh = \"missing.obj\"\n"), HasSubstr("missing.obj"));
    EXPECT_THAT(refusal("sheet = 3\n"), HasSubstr("test.toml:1"));
}

TEST(Scene, bodies_and_checks_that_make_no_sense_are_named)
{
    EXPECT_THAT(refusal(kSheet + "[[sphere]]\nradius = 0\n"), HasSubstr("radius"));
    EXPECT_THAT(refusal(kSheet + "[[sphere]]\nradios = 1\n"), HasSubstr("nearest is radius"));
    EXPECT_THAT(refusal(kSheet + "[[plane]]\nnormal = [0, 0, 0]\n"), HasSubstr("normal"));
    EXPECT_THAT(refusal(kSheet + "[check]\ncontacts = [1, 2]\n"), HasSubstr("frames"));
    EXPECT_THAT(refusal(kSheet + "[check]\nframes = 5\ncontacts = [2, 1]\n"), HasSubstr("[least, most]"));
    EXPECT_THAT(refusal(kSheet + "[check]\nframes = 5\ncontact = [1, 2]\n"), HasSubstr("nearest is contacts"));
}

TEST(Scene, an_unknown_name_lists_those_there_are)
{
    try {
        load_scene("curtains");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("nearest is curtain"), HasSubstr("seed"), HasSubstr(".toml")));
    }
    EXPECT_THROW(load_scene("missing.toml"), Error);
}

}  // namespace
}  // namespace nuno
