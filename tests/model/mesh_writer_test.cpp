// Meshes written are read back as the same floats.
#include "model/mesh_writer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <sstream>

#include "core/files.h"
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
    const MeshView view{positions, sheet.mesh.uvs, sheet.mesh.faces};
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

TEST(MeshWriter, a_point_cache_is_a_header_and_all_samples)
{
    PointCache cache(2);
    const std::vector<glm::vec4> a{{1, 2, 3, 9}, {4, 5, 6, 9}}, b{{7, 8, 9, 9}, {10, 11, 12, 9}};
    cache.add(a);
    cache.add(b);
    const TemporaryDirectory directory;
    cache.write(directory.path() / "c.pc2");
    const std::string bytes = read_text(directory.path() / "c.pc2");
    ASSERT_EQ(bytes.size(), 32u + 2 * 2 * 12);
    EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    std::int32_t numbers[5];
    std::memcpy(numbers, bytes.data() + 12, sizeof numbers);
    EXPECT_EQ(numbers[0], 1);
    EXPECT_EQ(numbers[1], 2);
    EXPECT_EQ(numbers[4], 2);
    float last;
    std::memcpy(&last, bytes.data() + bytes.size() - 4, 4);
    EXPECT_EQ(last, 12);
}

}  // namespace
}  // namespace nuno
