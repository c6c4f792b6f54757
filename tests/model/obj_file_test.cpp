// OBJ files, good and bad.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

// Two squares side by side; the texture has a seam along the side between them, vertices 1 and 2.
const std::string kSeam = kSquare +
                          "v 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                          "f 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 3/4\n";

TEST(ObjFile, a_seam_of_the_texture_gives_each_side_its_own_coordinates)
{
    const TriangleMesh mesh = load(kSeam);
    EXPECT_EQ(mesh.positions.size(), 6u) << "a vertex is one, however many texture coordinates it has";
    EXPECT_EQ(mesh.uvs[1], glm::vec2(0, 0)) << "the last is its own";
    EXPECT_EQ(mesh.uvs[2], glm::vec2(0, 1));
    EXPECT_THAT(mesh.seams.vertices, testing::UnorderedElementsAre(1u, 2u));
    ASSERT_EQ(mesh.seams.faces.size(), 4u);
    const std::vector<glm::vec3> positions = with_copies(std::span<const glm::vec3>(mesh.positions), mesh.seams);
    std::vector<glm::vec2> uvs = mesh.uvs;
    uvs.insert(uvs.end(), mesh.seams.uvs.begin(), mesh.seams.uvs.end());
    for (std::size_t f = 0; f < 4; ++f)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t corner = mesh.seams.faces[f][k];
            ASSERT_LT(corner, 8u);
            const glm::vec3 place = positions[corner];
            EXPECT_EQ(place, mesh.positions[mesh.faces[f][k]]);
            EXPECT_EQ(uvs[corner], glm::vec2(place.x - (f < 2 ? 0 : 1), place.y)) << "face " << f;
        }
}

TEST(ObjFile, texture_coordinates_that_agree_are_no_seam)
{
    const TriangleMesh same = load(kSquare + "vt 0 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2\n");
    EXPECT_TRUE(same.seams.empty());
    EXPECT_TRUE(same.seams.vertices.empty());
    const TriangleMesh half = load(kSquare + "vt 0.5 0.25\nf 1/1 2/1 3/1\nf 1 3 4\n");
    EXPECT_TRUE(half.seams.empty()) << "a corner without any has its vertex's";
    EXPECT_EQ(half.uvs[3], glm::vec2(0, 1));
}

TEST(ObjFile, comments_and_normals_are_passed_over)
{
    EXPECT_EQ(load(kSquare + "vn 0 0 1\nf 1//1 2//1 3//1 # one\nf 1 3 4 # two\n").faces.size(), 2u);
}

// Sum of the areas of the faces, each less than 0 where it does not look along +z.
float area_towards_z(const TriangleMesh& mesh)
{
    float sum = 0;
    for (const glm::uvec3& face : mesh.faces) {
        const glm::vec3 a = mesh.positions[face[0]], u = mesh.positions[face[1]] - a, v = mesh.positions[face[2]] - a;
        sum += std::copysign(face_area(mesh, face), u.x * v.y - u.y * v.x);
        EXPECT_GT(u.x * v.y - u.y * v.x, 0);
    }
    return sum;
}

TEST(ObjFile, a_concave_polygon_is_cut_inside)
{
    // A square with a notch: 4 less a triangle of 2 x 1.5 / 2.
    const TriangleMesh notched = load("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n");
    EXPECT_EQ(notched.faces.size(), 3u);
    EXPECT_FLOAT_EQ(area_towards_z(notched), 2.5f);
    // A dart whose shorter diagonal lies outside.
    const TriangleMesh dart = load("v -1 0 0\nv 0 2 0\nv 1 0 0\nv 0 10 0\nf 1 2 3 4\n");
    EXPECT_EQ(dart.faces.size(), 2u);
    EXPECT_FLOAT_EQ(area_towards_z(dart), 8);
    // A comb of 40 teeth, and a corner of 180 degrees.
    std::string comb = "v 40 -1 0\nv 20 -1 0\nv 0 -1 0\n", face = "f 3 2 1";
    for (int i = 0; i < 81; ++i) comb += fmt::format("v {} {} 0\n", i * 0.5, i % 2 == 0 ? 0 : 3);
    for (int i = 80; i >= 0; --i) face += fmt::format(" {}", i + 4);
    const TriangleMesh teeth = load(comb + face + "\n");
    EXPECT_EQ(teeth.faces.size(), 82u);
    EXPECT_FLOAT_EQ(area_towards_z(teeth), 40 + 40 * 1.5f);
}

TEST(ObjFile, a_polygon_that_cannot_be_cut_is_named_with_its_line)
{
    EXPECT_THAT(refusal(kSquare + "f 1 3 2 4\n"), HasSubstr(":5: this polygon crosses"));
    EXPECT_THAT(refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n"), HasSubstr(":5: this polygon"));
    std::string corners;
    for (int i = 0; i < 300; ++i) corners += " 1";
    EXPECT_THAT(refusal(kSquare + "f" + corners + "\n"), HasSubstr(":5: a face of 300 vertices"));
}

TEST(ObjFile, objects_and_groups_are_lists_of_vertices)
{
    const TriangleMesh mesh = load("o towel\n" + kSquare + "g hem rim\nf 1 2 3\ng\nf 1 3 4\n");
    EXPECT_EQ(mesh.groups, (std::map<std::string, std::vector<std::uint32_t>>{
                               {"towel", {0, 1, 2, 3}}, {"hem", {0, 1, 2}}, {"rim", {0, 1, 2}}}));
}

TEST(ObjFile, pieces_that_do_not_hang_together_are_one_mesh)
{
    EXPECT_EQ(load(kSquare + "v 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3 4\nf 5 6 7\n").faces.size(), 3u);
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
    EXPECT_THAT(refusal("v 0 0 -inf\n"), HasSubstr(":1: '-inf' is no finite number"));
    EXPECT_THAT(refusal("v 0 0 1e39\n"), HasSubstr(":1: '1e39' is no finite number"));
    EXPECT_THAT(refusal(kSquare + "f -1 -2 -5\n"), HasSubstr(":5: '-5' names no vertex; 4 were given"));
    EXPECT_THAT(refusal(kSquare + "f 1 2 3 4\nf 3 1 2\nf 1 2 3\n"), HasSubstr("has the same vertices as face"));
    EXPECT_THAT(refusal(""), HasSubstr("no vertices"));
    EXPECT_THAT(refusal(kSquare), HasSubstr("no faces"));
    EXPECT_THAT(refusal("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), HasSubstr("face 0"));
    EXPECT_THROW(load_obj("missing.obj"), Error);
}

}  // namespace
}  // namespace nuno
