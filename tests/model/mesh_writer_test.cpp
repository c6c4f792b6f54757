// Meshes written are read back as the same floats.
#include "model/mesh_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "model/triangle_mesh.h"
#include "support/program_run.h"
#include "support/sheets.h"

namespace nuno {
namespace {

TEST(MeshWriter, obj_and_ply_give_back_the_same_floats)
{
    const SheetSource sheet = square_mesh(5, 1.234567f, 25);
    std::mt19937 random(5);
    std::normal_distribution<float> at(0, 1);
    std::vector<glm::vec4> positions;
    for (std::size_t i = 0; i < sheet.mesh.positions.size(); ++i)
        positions.emplace_back(at(random), at(random), at(random), 0);
    const MeshView view{positions, sheet.mesh.uvs, sheet.mesh.faces, {}, {}};
    const TemporaryDirectory directory;
    const TriangleMesh back = load_obj(directory.write("a.obj", obj_text(view)));
    ASSERT_EQ(back.positions.size(), positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(back.positions[i], glm::vec3(positions[i]));
    EXPECT_EQ(back.faces, sheet.mesh.faces);
    EXPECT_EQ(back.uvs, sheet.mesh.uvs);

    std::istringstream ply(ply_text(view));
    std::string line;
    while (std::getline(ply, line) && line != "end_header") {
    }
    for (const glm::vec4& p : positions) {
        glm::vec3 q;
        ply >> q.x >> q.y >> q.z;
        EXPECT_EQ(q, glm::vec3(p));
    }
}

TEST(MeshWriter, an_obj_with_a_seam_of_the_texture_comes_back_as_it_was)
{
    const TemporaryDirectory directory;
    const TriangleMesh mesh = load_obj(
        directory.write("a.obj",
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                        "f 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 3/4\n"));
    std::vector<glm::vec4> positions;
    for (const glm::vec3& p : mesh.positions) positions.emplace_back(p, 0);
    const std::string text = obj_text({positions, mesh.uvs, mesh.faces, {}, {}, &mesh.seams});
    const TriangleMesh back = load_obj(directory.write("b.obj", text));
    EXPECT_EQ(back.positions, mesh.positions);
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_EQ(back.uvs, mesh.uvs);
    ASSERT_EQ(mesh.seams.vertices.size(), 2u);
    EXPECT_EQ(back.seams.vertices, mesh.seams.vertices);
    EXPECT_EQ(back.seams.uvs, mesh.seams.uvs);
    EXPECT_EQ(back.seams.faces, mesh.seams.faces);
}

TEST(MeshWriter, sheets_are_groups_with_materials_of_their_own)
{
    SheetSource first = square_sheet(2, 1), second = square_sheet(3, 1);
    first.name = "shirt front";
    second.name = "shirt front";
    const std::vector<SheetSource> sheets{first, second};
    const ClothModel model = build_cloth_model(sheets, MassLumping::equal);
    std::vector<MeshPart> parts = mesh_parts(model);
    const std::vector<glm::vec4> positions(model.vertex_count());
    const std::string text = obj_text({positions, model.uvs, model.faces, parts, "a.mtl"});
    EXPECT_EQ(text.find("# nuno\nmtllib a.mtl\nv "), 0u);
    const std::size_t front =
        text.find("g shirt_front\nusemtl shirt_front\nf 1/1 3/3 4/4\nf 1/1 4/4 2/2\ng shirt_front_2");
    EXPECT_NE(front, std::string::npos) << text;
    EXPECT_NE(text.find("usemtl shirt_front_2\nf 5/5 "), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '/'), 3 * (2 + 8));

    parts[1].texture = "../textures/print.bmp";
    const std::string materials = mtl_text(parts, 2.5f);
    EXPECT_NE(materials.find("newmtl shirt_front_2\nKa 0 0 0\nKs 0 0 0\nKd 1 1 1\nmap_Kd -s 2.5 2.5 1 "
                             "../textures/print.bmp\n"),
              std::string::npos)
        << materials;
    EXPECT_NE(materials.find("newmtl shirt_front\n"), std::string::npos);
}

}  // namespace
}  // namespace nuno
