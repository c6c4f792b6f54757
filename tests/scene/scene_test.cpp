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
    EXPECT_THAT(
        names, testing::IsSupersetOf({"seed", "hang", "flag", "curtain", "drape", "gale", "table", "mannequin", "twist",
                                      "stack", "swing", "fold", "roll", "squeeze", "bag", "fast_collider"}));
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
        "pins = [\"top\", \"left@0.5\", \"centre\", 24]\n"
        "[[sphere]]\nradius = 0.5\n[[plane]]\nnormal = [0, 2, 0]\noffset = -1.5\n"
        "[check]\nframes = 10\ncontacts = [1, inf]\n");
    EXPECT_EQ(scene.params.wind_strength, 3);
    EXPECT_EQ(scene.params.method, Method::explicit_euler);
    EXPECT_EQ(scene.params.count_pass_through, 1);
    ASSERT_EQ(scene.view.size(), 1u);
    EXPECT_EQ(scene.view[0].text, "phong");
    EXPECT_EQ(scene.bodies.spheres.at(0).radius, 0.5f);
    EXPECT_EQ(scene.bodies.planes.at(0).normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.check.frames, 10);
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    EXPECT_THAT(sheet.pins, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 10, 12, 24));
}

TEST(Scene, a_mesh_is_pinned_by_its_groups_a_list_in_a_file_and_numbers)
{
    const TemporaryDirectory directory;
    directory.write("towel.obj",
                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\ng hem\nf 1 2 3\ng rest\nf 1 3 4\nf 3 5 4\n");
    directory.write("pins.txt", "# numbers from 0\n3, 2\n2\n");
    const auto pins = [&](const std::string& keys) {
        const auto path =
            directory.write("t.toml", "[[handle]]\nname = \"bar\"\n[[sheet]]\nmesh = \"towel.obj\"\n" + keys);
        const Scene scene = load_scene(path.string());
        return make_sheets(scene, scene.params).front();
    };
    EXPECT_THAT(pins("pins = [\"hem\"]\n").pins, testing::UnorderedElementsAre(0, 1, 2));
    EXPECT_THAT(pins("pin_file = \"pins.txt\"\npins = [4]\n").pins, testing::IsSupersetOf({2, 3, 4}));
    const SheetSource carried = pins("handles = [{ name = \"bar\", pin_file = \"pins.txt\" }]\n");
    EXPECT_EQ(carried.handle_pins.front().vertex, 3u);
    const auto told = [&](const std::string& keys) {
        try {
            pins(keys);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(told("pins = [\"hen\"]\n"),
                AllOf(HasSubstr("t.toml:5"), HasSubstr("towel.obj; the nearest is hem; there are hem or rest")));
    EXPECT_THAT(told("pin_file = \"none.txt\"\n"), HasSubstr("none.txt: cannot be read"));
    directory.write("pins.txt", "1\n2 x\n");
    EXPECT_THAT(told("pin_file = \"pins.txt\"\n"), HasSubstr("pins.txt:2: 'x' is no vertex number"));
    directory.write("pins.txt", "# none\n");
    EXPECT_THAT(told("pin_file = \"pins.txt\"\n"), HasSubstr("pins.txt: names no vertex"));
}

TEST(Scene, a_format_that_is_newer_is_refused_before_its_keys_are)
{
    EXPECT_EQ(load("format = 1\n" + kSheet).sheets.size(), 1u);
    EXPECT_THAT(refusal("title = \"t\"\nformat = 2\nnovelty = 3\n" + kSheet),
                AllOf(HasSubstr("test.toml:2: the scene has format 2"), HasSubstr("newer nuno")));
    EXPECT_THAT(refusal("format = 0\n" + kSheet), HasSubstr("test.toml:1: format = 0 must be 1"));
    EXPECT_THAT(refusal("format = \"1\"\n" + kSheet), HasSubstr("test.toml:1"));
}

TEST(Scene, resolution_sets_the_longer_side_and_keeps_the_cells)
{
    Scene scene = load("[[sheet]]\ncolumns = 9\nrows = 5\nacross = [2, 0, 0]\npins = [\"top_right\", \"centre\"]\n");
    scene.params.resolution = 33;
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    EXPECT_EQ(sheet.columns, 33);
    EXPECT_EQ(sheet.rows, 17);
    EXPECT_THAT(sheet.pins, testing::ElementsAre(32, 280));
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
    EXPECT_THAT(refusal("[params]\nmethod = 1\n" + kSheet), HasSubstr("explicit_euler, symplectic_euler"));
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
    EXPECT_THAT(refusal("[[sheet]]\ncolumns = 5\npins = [\"centre@0.5\"]\n"), HasSubstr("no parts"));
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

TEST(Scene, bodies_of_every_shape_are_read_with_their_keyframes)
{
    const Scene scene =
        load(kSheet +
             "[[capsule]]\nfrom = [0, 1, 0]\nto = [1, 1, 0]\nradius = 0.2\n"
             "[[box]]\ncentre = [0, 1, 0]\nsize = [1, 2, 3]\naxis = [0, 0, 2]\nangle = 90\n"
             "keyframes = [{ time = 1, move = [1, 0, 0] }, { time = 2, angle = 180, axis = [1, 0, 0] }]\n"
             "easing = \"linear\"\npivot = [0, 0, 1]\n"
             "[[sphere]]\nkeyframes = [{ time = 0, quaternion = [0, 0, 2, 2] }]\n");
    const Capsule& capsule = scene.bodies.capsules.at(0);
    EXPECT_EQ(capsule.to, glm::vec3(1, 1, 0));
    EXPECT_FALSE(capsule.motion.moves());
    const Box& box = scene.bodies.boxes.at(0);
    EXPECT_LE(glm::distance(box.rotation * glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)), 1e-6f);
    ASSERT_EQ(box.motion.keyframes.size(), 2u);
    EXPECT_EQ(box.motion.keyframes[0].move, glm::dvec3(1, 0, 0));
    EXPECT_NEAR(box.motion.keyframes[1].angle, 3.14159265, 1e-7);
    EXPECT_EQ(box.motion.easing, Easing::linear);
    EXPECT_EQ(box.motion.pivot, glm::dvec3(0, 0, 1));
    const Keyframe turned = scene.bodies.spheres.at(0).motion.keyframes.at(0);
    EXPECT_EQ(turned.axis, glm::dvec3(0, 0, 1));
    EXPECT_NEAR(turned.angle, 1.57079633, 1e-7);
}

TEST(Scene, pins_on_handles_are_read)
{
    const Scene scene = load(
        "[[sheet]]\ncolumns = 5\npins = [12]\n"
        "handles = [{ name = \"b\", pins = [\"left\"] }, { name = \"a\", pins = [4] }]\n"
        "[[handle]]\nname = \"a\"\n[[handle]]\nname = \"b\"\n");
    const SheetSource sheet = make_sheets(scene, scene.params).front();
    EXPECT_THAT(sheet.pins, testing::ElementsAre(12));
    ASSERT_EQ(sheet.handle_pins.size(), 6u);
    EXPECT_EQ(sheet.handle_pins[0].handle, 1u);
    EXPECT_EQ(sheet.handle_pins[5].handle, 0u);
    EXPECT_EQ(sheet.handle_pins[5].vertex, 4u);
}

TEST(Scene, bodies_that_cannot_be_are_named_with_their_line)
{
    const auto box = [](const std::string& text) { return refusal(kSheet + "[[box]]\n" + text + "\n"); };
    EXPECT_THAT(box("size = [1, -1, 1]"), AllOf(HasSubstr("test.toml:4"), HasSubstr("above 0")));
    EXPECT_THAT(box("axis = [0, 0, 0]"), AllOf(HasSubstr("test.toml:4"), HasSubstr("not all zero")));
    EXPECT_THAT(box("quaternion = [0, 0, 0, 0]"), HasSubstr("not all zero, [x, y, z, w]"));
    EXPECT_THAT(box("quaternion = [1, 0, 0]"), HasSubstr("[x, y, z, w]"));
    EXPECT_THAT(box("angle = 3\nquaternion = [0, 0, 0, 1]"), HasSubstr("left out where angle is given"));
    EXPECT_THAT(box("thickness = 1"), AllOf(HasSubstr("test.toml:4"), HasSubstr("nearest is")));
    EXPECT_THAT(refusal(kSheet + "[[capsule]]\nradius = -0.1\n"),
                AllOf(HasSubstr("test.toml:4"), HasSubstr("above 0")));
    EXPECT_THAT(refusal(kSheet + "[[body_mesh]]\n"), HasSubstr("OBJ file"));
    EXPECT_THAT(refusal(kSheet + "[[body_mesh]]\nmesh = \"m.obj\"\n"), HasSubstr("m.obj"));
    EXPECT_THAT(refusal(kSheet + "[box]\n"), HasSubstr("[[box]]"));
}

TEST(Scene, keyframes_that_make_no_motion_are_named_with_their_line)
{
    const auto keyframes = [](const std::string& text) {
        return refusal(kSheet + "[[box]]\nkeyframes = " + text + "\n");
    };
    EXPECT_THAT(keyframes("[{ time = 1 }, { time = 0.5 }]"),
                AllOf(HasSubstr("test.toml:4"), HasSubstr("later than"), HasSubstr("1 s")));
    EXPECT_THAT(keyframes("[{ time = 1 }, { time = 1 }]"), HasSubstr("later than"));
    EXPECT_THAT(keyframes("[{ move = [1, 0, 0] }]"), HasSubstr("in every keyframe"));
    EXPECT_THAT(keyframes("[{ time = inf }]"), HasSubstr("finite number of seconds"));
    EXPECT_THAT(keyframes("[{ time = 1, turn = 3 }]"), AllOf(HasSubstr("test.toml:4"), HasSubstr("unknown key turn")));
    EXPECT_THAT(keyframes("[]"), HasSubstr("at least one keyframe"));
    EXPECT_THAT(keyframes("[3]"), HasSubstr("{time"));
    EXPECT_THAT(keyframes("[{ time = 1 }]\neasing = \"cubic\""), HasSubstr("smooth or linear"));
    EXPECT_THAT(keyframes("[{ time = 1 }]\nrepeat = true"), HasSubstr("two keyframes"));
    EXPECT_THAT(keyframes("[{ time = 1 }, { time = 2, angle = 90 }]\nrepeat = true"), HasSubstr("where the first is"));
    EXPECT_EQ(keyframes("[{ time = 1 }, { time = 2, angle = 360 }]\nrepeat = true"), "accepted");
}

TEST(Scene, handles_that_do_not_fit_are_named_with_their_line)
{
    const std::string handle = "[[handle]]\nname = \"left\"\n";
    const auto sheet = [](const std::string& text) { return "[[sheet]]\ncolumns = 5\n" + text + "\n"; };
    EXPECT_THAT(refusal(sheet("handles = [{ name = \"lift\", pins = [0] }]") + handle),
                AllOf(HasSubstr("test.toml:3"), HasSubstr("nearest is left")));
    EXPECT_THAT(refusal(sheet("handles = [{ name = \"left\", pins = [0] }]")), HasSubstr("add one named left"));
    EXPECT_THAT(refusal(sheet("handles = [{ name = \"left\" }]") + handle), HasSubstr("that the handle carries"));
    EXPECT_THAT(refusal(sheet("pins = [0]\nhandles = [{ name = \"left\", pins = [\"top\"] }]") + handle),
                AllOf(HasSubstr("test.toml:4"), HasSubstr("vertex 0"), HasSubstr("test.toml:3")));
    EXPECT_THAT(refusal(sheet("") + handle + handle), HasSubstr("no other handle"));
    EXPECT_THAT(refusal(sheet("") + "[[handle]]\n"), HasSubstr("name"));
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
