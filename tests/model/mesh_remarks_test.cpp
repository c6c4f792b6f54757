// Meshes that cloth can live with, and what is said of them.
#include "model/mesh_remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/sheets.h"

namespace nuno {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ClothModel cloth(std::vector<glm::uvec3> faces)
{
    SheetSource sheet;
    sheet.name = "pocket";
    sheet.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    sheet.mesh.uvs.resize(5);
    sheet.mesh.faces = std::move(faces);
    // A first sheet, so that numbers of the model are not those of the sheet.
    const std::vector<SheetSource> sheets{square_sheet(3, 1), sheet};
    return build_cloth_model(sheets, MassLumping::equal);
}

TEST(MeshRemarks, an_edge_of_three_faces_is_told_with_its_vertices_and_faces)
{
    EXPECT_THAT(mesh_remarks(cloth({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})),
                ElementsAre(AllOf(HasSubstr("sheet pocket"), HasSubstr("at 1 of its edges"),
                                  HasSubstr("vertices 0 and 1 (faces 0, 1, 2)"))));
}

TEST(MeshRemarks, faces_that_turn_opposite_sides_up_are_told)
{
    EXPECT_THAT(mesh_remarks(cloth({{0, 1, 2}, {0, 1, 3}, {2, 1, 4}})),
                ElementsAre(AllOf(HasSubstr("opposite sides up at 1 of"), HasSubstr("vertices 0 and 1 (faces 0, 1)"))));
}

TEST(MeshRemarks, nothing_is_said_of_a_mesh_whose_faces_agree)
{
    EXPECT_THAT(mesh_remarks(cloth({{0, 1, 2}, {1, 0, 3}, {2, 1, 4}})), IsEmpty());
}

}  // namespace
}  // namespace nuno
