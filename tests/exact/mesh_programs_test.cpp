// The programs that check exported meshes, on meshes whose answer is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "support/program_run.h"

namespace nuno {
namespace {

struct Vertex
{
    float x, y, z;
};
using Corners = std::vector<std::vector<int>>;

std::string ply_of(const std::vector<Vertex>& vertices, const Corners& faces)
{
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        vertices.size(), faces.size());
    for (const Vertex& v : vertices) text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
    for (const auto& f : faces) text += fmt::format("{} {}\n", f.size(), fmt::join(f, " "));
    return text;
}

template <class T>
void put(std::string& bytes, T value, bool big_endian)
{
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_endian) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

std::string binary_ply_of(const std::vector<Vertex>& vertices, const Corners& faces, bool big_endian)
{
    std::string bytes = fmt::format(
        "ply\nformat binary_{}_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "property uchar red\nelement face {}\nproperty list uchar uint vertex_index\nend_header\n",
        big_endian ? "big" : "little", vertices.size(), faces.size());
    for (const Vertex& v : vertices) {
        for (const float a : {v.x, v.y, v.z}) put(bytes, double(a), big_endian);
        put(bytes, std::uint8_t{7}, big_endian);
    }
    for (const auto& f : faces) {
        put(bytes, std::uint8_t(f.size()), big_endian);
        for (const int v : f) put(bytes, std::uint32_t(v), big_endian);
    }
    return bytes;
}

const std::vector<Vertex> kFloor{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

// The floor and a face whose edge from (0.2, 0.2, height) on goes down to depth below it.
std::vector<Vertex> with_face_above(float height, float depth)
{
    std::vector<Vertex> vertices = kFloor;
    vertices.insert(vertices.end(), {{0.2f, 0.2f, height}, {0.3f, 0.2f, depth}, {0.2f, 0.3f, 2}});
    return vertices;
}

class MeshPrograms : public testing::Test
{
  protected:
    ProgramResult intersections(const std::string& text, const std::string& name = "a.ply")
    {
        return run_words({NUNO_MESH_INTERSECTIONS, directory_.write(name, text).string()});
    }
    ProgramResult ccd(const std::string& t0, const std::string& t1)
    {
        return run_words(
            {NUNO_MESH_CCD, directory_.write("t0.ply", t0).string(), directory_.write("t1.ply", t1).string()});
    }

    TemporaryDirectory directory_;
};

TEST_F(MeshPrograms, faces_apart_do_not_intersect)
{
    const ProgramResult result = intersections(ply_of(with_face_above(1, 1e-30f), {{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find(": 0\n"), std::string::npos);
}

TEST_F(MeshPrograms, a_vertex_by_the_least_float_below_a_face_intersects_it)
{
    const ProgramResult result = intersections(ply_of(with_face_above(1, -1e-30f), {{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find(": 1\n"), std::string::npos) << result.out << result.err;
}

TEST_F(MeshPrograms, neighbours_intersect_only_where_they_fold_onto_or_go_through_each_other)
{
    const std::vector<Vertex> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(intersections(ply_of(flat, {{0, 1, 2}, {2, 1, 3}})).exit_code, 0);
    std::vector<Vertex> folded = flat;
    folded[3] = {0.1f, 0.1f, 0};
    EXPECT_EQ(intersections(ply_of(folded, {{0, 1, 2}, {2, 1, 3}})).exit_code, 1);
    // Vertex 0 in common; the edge 3 4 goes through the face.
    const std::vector<Vertex> crossing{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3f, 0.3f, -1}, {0.3f, 0.3f, 1}};
    EXPECT_EQ(intersections(ply_of(crossing, {{0, 1, 2}, {0, 3, 4}})).exit_code, 1);
    std::vector<Vertex> beside = crossing;
    beside[3].x = beside[4].x = -0.3f;
    EXPECT_EQ(intersections(ply_of(beside, {{0, 1, 2}, {0, 3, 4}})).exit_code, 0);
}

TEST_F(MeshPrograms, every_form_of_file_gives_the_same_answer)
{
    const std::vector<Vertex> vertices = with_face_above(1, -0.5f);
    const Corners faces{{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(intersections(binary_ply_of(vertices, faces, false)).exit_code, 1);
    EXPECT_EQ(intersections(binary_ply_of(vertices, faces, true)).exit_code, 1);
    std::string obj;
    for (const Vertex& v : vertices) obj += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
    EXPECT_EQ(intersections(obj + "f 1 2 3\nf 4/1 5/2 6/3\n", "a.obj").exit_code, 1);
    EXPECT_EQ(intersections(obj + "f 1 2 3\nf -3 -2 -1\n", "a.obj").exit_code, 1);
}

TEST_F(MeshPrograms, what_is_no_mesh_is_refused_by_name)
{
    for (const std::string& text :
         {ply_of({{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}}, {{0, 1, 2}}), ply_of(kFloor, {{0, 1, 3}}),
          ply_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), ply_of(kFloor, {{0, 1, 2, 0}}),
          std::string("plank\n"), ply_of({}, {}), ply_of(kFloor, {}),
          std::string("ply\nformat ascii 1.0\nelement vertex abc\nend_header\n"),
          std::string("ply\nformat ascii 1.0\nelement foo -5\nend_header\n"), ply_of(kFloor, {{0, 1, -1}}),
          ply_of(kFloor, {{0, 1, 2}}).substr(0, 150)})
    {
        const ProgramResult result = intersections(text);
        EXPECT_EQ(result.exit_code, 2) << text;
        EXPECT_NE(result.err.find("a.ply: "), std::string::npos) << result.err;
    }
}

TEST_F(MeshPrograms, an_obj_that_is_none_is_refused_by_name)
{
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const std::string& text : {vertices + "f 1 2 x\n", vertices + "f 4294967297 2 3\n", vertices + "f 1.5 2 3\n",
                                    vertices + "f 0 1 2\n", std::string("hello\n")})
    {
        const ProgramResult result = intersections(text, "a.obj");
        EXPECT_EQ(result.exit_code, 2) << text;
        EXPECT_NE(result.err.find("a.obj: "), std::string::npos) << result.err;
    }
    EXPECT_EQ(intersections(vertices + "f 1 2 3\n", "a.txt").exit_code, 2);
}

// 0.1 and the float next to it are apart, but not as nine digits in double.
TEST_F(MeshPrograms, positions_are_the_floats_that_were_written)
{
    const std::string text = intersections(ply_of({{0, 0, 0.1f}, {1, 0, 0.1f}, {0, 1, 0.1f}}, {{0, 1, 2}})).out;
    EXPECT_NE(text.find(": 0\n"), std::string::npos);
    const std::vector<Vertex> above{{0.2f, 0.2f, std::nextafterf(0.1f, 1)}, {0.3f, 0.2f, 1}, {0.2f, 0.3f, 2}};
    std::vector<Vertex> vertices{{0, 0, 0.1f}, {1, 0, 0.1f}, {0, 1, 0.1f}};
    vertices.insert(vertices.end(), above.begin(), above.end());
    const ProgramResult result = intersections(ply_of(vertices, {{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(MeshPrograms, a_vertex_through_a_face_and_the_edges_that_it_takes_along_collide)
{
    const Corners faces{{0, 1, 2}, {3, 4, 5}};
    const ProgramResult result =
        ccd(ply_of(with_face_above(1, 0.5f), faces), binary_ply_of(with_face_above(1, -0.5f), faces, false));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "vf,4,0\n");
    EXPECT_NE(result.err.find("1 collide"), std::string::npos) << result.err;
}

TEST_F(MeshPrograms, crossing_edges_collide)
{
    std::vector<Vertex> t0{{-1, 0, 0}, {1, 0, 0}, {0, -5, 0}, {0, -1, 1}, {0, 1, 1}, {0, 0, 5}};
    std::vector<Vertex> t1 = t0;
    for (int v : {3, 4}) t1[std::size_t(v)].z = -1;
    const Corners faces{{0, 1, 2}, {3, 4, 5}};
    const ProgramResult result = ccd(ply_of(t0, faces), ply_of(t1, faces));
    EXPECT_NE(result.out.find("ee,0,1,3,4\n"), std::string::npos) << result.out;
}

TEST_F(MeshPrograms, frames_of_two_meshes_are_refused)
{
    const ProgramResult result =
        ccd(ply_of(with_face_above(1, 1), {{0, 1, 2}, {3, 4, 5}}), ply_of(with_face_above(1, 1), {{0, 1, 2}}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("t1.ply: not the same mesh"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace nuno
