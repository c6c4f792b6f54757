// OBJ files, good and bad.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "model/triangle_mesh.h"
#include "support/program_run.h"

namespace nuno {
namespace {

using testing::HasSubstr;

TriangleMesh load(const std::string& text)
{
    const TemporaryDirectory directory;
    return load_obj(directory.write("mesh.obj", text));
}

std::string refusal(const std::string& text)
{
    try {
        load(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjFile, a_quad_becomes_two_triangles)
{
    const TriangleMesh mesh = load(kSquare + "f 1 2 3 4\n");
    EXPECT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.faces.size(), 2u);
    EXPECT_FLOAT_EQ(face_area(mesh, mesh.faces[0]) + face_area(mesh, mesh.faces[1]), 1);
}

TEST(ObjFile, texture_coordinates_are_read_or_made)
{
    const TriangleMesh given = load(kSquare + "vt 0.5 0.25\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\n");
    EXPECT_EQ(given.uvs[2], glm::vec2(0.5f, 0.25f));
    const TriangleMesh made = load(kSquare + "f 1 2 3\nf 1 3 4\n");
    EXPECT_EQ(made.uvs[2], glm::vec2(1, 1));
}

TEST(ObjFile, comments_and_normals_are_passed_over)
{
    EXPECT_EQ(load(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1 # one\nf 1 3 4 # two\n").faces.size(), 2u);
}

TEST(ObjFile, negative_indices_count_from_the_end)
{
    EXPECT_EQ(load(kSquare + "f -4 -3 -2\nf -4 -2 -1\n").faces[0], glm::uvec3(0, 1, 2));
}

TEST(ObjFile, what_is_wrong_is_named_with_its_line)
{
    EXPECT_THAT(refusal(kSquare + "f 1 2 9\n"), HasSubstr(":5: '9' names no vertex"));
    EXPECT_THAT(refusal(kSquare + "f 1 2 0\n"), HasSubstr(":5: '0'"));
    EXPECT_THAT(refusal(kSquare + "f 1 2\n"), HasSubstr(":5: a face needs"));
    EXPECT_THAT(refusal("v 0 0 zero\n"), HasSubstr(":1: 'zero' is no finite number"));
    EXPECT_THAT(refusal("v 0 0\n"), HasSubstr(":1: 2 numbers are too few"));
    EXPECT_THAT(refusal("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr(":1: 'nan' is no finite number"));
    EXPECT_THAT(refusal(kSquare + "f 1 2 2.5\n"), HasSubstr(":5: '2.5' names no vertex"));
    EXPECT_THAT(refusal(kSquare + "f 1/1 2/2 3/3\n"), HasSubstr(":5: '1/1' names no texture coordinate; 0 were given"));
    EXPECT_THAT(refusal(kSquare + "vt 0 0\nf 1/1 2/99999999 3/1\n"), HasSubstr(":6: '2/99999999' names no texture"));
    EXPECT_THAT(refusal(kSquare + "vt nan 0\nf 1/1 2/1 3/1\n"), HasSubstr(":5: 'nan' is no finite number"));
    EXPECT_THAT(refusal(""), HasSubstr("no vertices"));
    EXPECT_THAT(refusal(kSquare), HasSubstr("no faces"));
    EXPECT_THAT(refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), HasSubstr("face 0"));
    EXPECT_THROW(load_obj("missing.obj"), Error);
}

}  // namespace
}  // namespace nuno
