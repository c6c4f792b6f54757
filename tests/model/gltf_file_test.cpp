// Binary glTF files, read back byte by byte as the specification says.
#include "model/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include <glm/geometric.hpp>

#include "core/files.h"
#include "model/smooth_normals.h"
#include "support/program_run.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Glb
{
    Json json;
    std::string bytes;
};

std::uint32_t word_at(const std::string& bytes, std::size_t offset)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

Glb read_glb(const fs::path& path)
{
    const std::string file = read_text(path);
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(word_at(file, 4), 2u);
    EXPECT_EQ(word_at(file, 8), file.size());
    const std::size_t json_length = word_at(file, 12);
    EXPECT_EQ(file.substr(16, 4), "JSON");
    EXPECT_EQ(json_length % 4, 0u);
    const std::size_t chunk = 20 + json_length;
    EXPECT_EQ(file.substr(chunk + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(chunk + 8 + word_at(file, chunk), file.size());
    return {Json::parse(file.substr(20, json_length)), file.substr(chunk + 8)};
}

// The numbers of an accessor, which lies inside its view, inside the buffer; its min and max are right.
template <class T>
std::vector<T> numbers_of(const Glb& glb, const Json& accessor)
{
    const std::size_t width = accessor["type"] == "VEC3" ? 3 : accessor["type"] == "VEC2" ? 2 : 1;
    const Json& view = glb.json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t offset = accessor["byteOffset"], view_offset = view["byteOffset"];
    std::vector<T> numbers(width * accessor["count"].get<std::size_t>());
    EXPECT_EQ((offset + view_offset) % 4, 0u);
    EXPECT_LE(offset + numbers.size() * sizeof(T), view["byteLength"].get<std::size_t>());
    EXPECT_LE(view_offset + view["byteLength"].get<std::size_t>(), glb.bytes.size());
    EXPECT_EQ(accessor["componentType"], (std::is_same_v<T, float> ? 5126 : 5125));
    std::memcpy(numbers.data(), glb.bytes.data() + view_offset + offset, numbers.size() * sizeof(T));
    for (std::size_t k = 0; accessor.contains("min") && k < width; ++k) {
        T low = numbers[k], high = numbers[k];
        for (std::size_t i = k; i < numbers.size(); i += width)
            low = std::min(low, numbers[i]), high = std::max(high, numbers[i]);
        EXPECT_EQ(accessor["min"][k].get<T>(), low);
        EXPECT_EQ(accessor["max"][k].get<T>(), high);
    }
    return numbers;
}

// Two sheets of 4 and 3 vertices.
GltfCloth two_sheets()
{
    GltfCloth cloth;
    cloth.parts = {{"towel", 0, 4, 0, 2, {}}, {"flag", 4, 3, 2, 1, std::vector<std::byte>(7, std::byte(5))}};
    cloth.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 0}, {0, 1}};
    cloth.faces = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}};
    cloth.repeats = 2;
    return cloth;
}

class GltfFileTest : public testing::Test
{
  protected:
    Glb write(int frame_count)
    {
        std::mt19937 random(7);
        std::normal_distribution<float> at(0, 1);
        GltfFile file(directory.path() / "c.glb", two_sheets());
        for (int k = 0; k < frame_count; ++k) {
            frames.emplace_back();
            for (int i = 0; i < 7; ++i) frames.back().emplace_back(at(random), at(random), at(random), 0);
            file.add(frames.back(), k / 60.0);
        }
        file.finish();
        return read_glb(directory.path() / "c.glb");
    }
    TemporaryDirectory directory;
    std::vector<std::vector<glm::vec4>> frames;
};

TEST_F(GltfFileTest, every_frame_decodes_to_its_positions)
{
    const Glb glb = write(4);
    EXPECT_EQ(glb.json["asset"]["version"], "2.0");
    EXPECT_EQ(glb.json["buffers"][0]["byteLength"], glb.bytes.size());
    const Json& accessors = glb.json["accessors"];
    for (std::size_t p = 0; p < 2; ++p) {
        const Json& primitive = glb.json["meshes"].at(p)["primitives"][0];
        const std::size_t first = p == 0 ? 0 : 4, count = p == 0 ? 4 : 3;
        const Json& start = accessors.at(primitive["attributes"]["POSITION"].get<std::size_t>());
        ASSERT_TRUE(start.contains("min"));
        const std::vector<float> base = numbers_of<float>(glb, start);
        ASSERT_EQ(base.size(), 3 * count);
        ASSERT_EQ(primitive["targets"].size(), 3u);
        for (std::size_t k = 0; k < 4; ++k) {
            std::vector<float> move(base.size());
            if (k > 0) {
                const Json& target = accessors.at(primitive["targets"][k - 1]["POSITION"].get<std::size_t>());
                ASSERT_TRUE(target.contains("max"));
                move = numbers_of<float>(glb, target);
            }
            ASSERT_EQ(move.size(), base.size());
            for (std::size_t i = 0; i < base.size(); ++i) {
                const float wanted = frames[k][first + i / 3][int(i % 3)];
                // Two roundings to 24 bits: of the move, and of the sum.
                EXPECT_NEAR(base[i] + move[i], wanted, 0x1p-23 * (std::abs(move[i]) + std::abs(wanted)));
            }
        }
    }
}

TEST_F(GltfFileTest, the_smooth_normals_of_every_frame_come_back)
{
    const Glb glb = write(3);
    const auto vectors = [&](const Json& index) {
        const std::vector<float> numbers = numbers_of<float>(glb, glb.json["accessors"].at(index.get<std::size_t>()));
        std::vector<glm::vec3> result;
        for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
            result.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
        return result;
    };
    for (std::size_t p = 0; p < 2; ++p) {
        const Json& primitive = glb.json["meshes"].at(p)["primitives"][0];
        const std::size_t first = p == 0 ? 0 : 4, count = p == 0 ? 4 : 3;
        const std::vector<glm::vec3> base = vectors(primitive["attributes"]["NORMAL"]);
        ASSERT_EQ(base.size(), count);
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<glm::vec3> turn(count, glm::vec3(0));
            if (k > 0) turn = vectors(primitive["targets"].at(k - 1)["NORMAL"]);
            ASSERT_EQ(turn.size(), count);
            const std::vector<glm::vec3> wanted = smooth_normals(frames[k], two_sheets().faces);
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_NEAR(glm::length(base[i] + turn[i]), 1, 1e-6);
                EXPECT_LT(glm::distance(base[i] + turn[i], wanted[first + i]), 1e-6);
            }
        }
    }
}

TEST_F(GltfFileTest, a_view_that_several_vertex_attributes_use_names_its_stride)
{
    const Glb glb = write(3);
    std::map<std::size_t, int> use_count;
    const auto use = [&](const Json& attributes) {
        for (const auto& [name, index] : attributes.items()) {
            const Json& accessor = glb.json["accessors"].at(index.get<std::size_t>());
            const Json& view = glb.json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
            EXPECT_EQ(view["byteStride"], accessor["type"] == "VEC3" ? 12 : 8) << name;
            EXPECT_EQ(view["target"], 34962);
            ++use_count[accessor["bufferView"]];
        }
    };
    for (const Json& mesh : glb.json["meshes"]) {
        const Json& primitive = mesh["primitives"][0];
        use(primitive["attributes"]);
        for (const Json& target : primitive["targets"]) use(target);
        const Json& corners = glb.json["accessors"].at(primitive["indices"].get<std::size_t>());
        EXPECT_FALSE(glb.json["bufferViews"].at(corners["bufferView"].get<std::size_t>()).contains("byteStride"));
    }
    // Two sheets: the mesh and two targets with positions and normals each, and the texture coordinates.
    EXPECT_THAT(use_count, testing::UnorderedElementsAre(testing::Pair(0, 4), testing::Pair(1, 2),
                                                         testing::Pair(testing::_, 4), testing::Pair(testing::_, 4)));
}

TEST_F(GltfFileTest, parts_have_their_own_faces_and_textures)
{
    const Glb glb = write(2);
    const auto primitive = [&](std::size_t p) { return glb.json["meshes"].at(p)["primitives"][0]; };
    const auto accessor = [&](const Json& index) { return glb.json["accessors"].at(index.get<std::size_t>()); };
    EXPECT_EQ(numbers_of<std::uint32_t>(glb, accessor(primitive(0)["indices"])),
              (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(numbers_of<std::uint32_t>(glb, accessor(primitive(1)["indices"])), (std::vector<std::uint32_t>{0, 1, 2}));
    // Twice along a sheet, downwards.
    EXPECT_EQ(numbers_of<float>(glb, accessor(primitive(1)["attributes"]["TEXCOORD_0"])),
              (std::vector<float>{0, 1, 2, 1, 0, -1}));
    const Json& materials = glb.json["materials"];
    EXPECT_EQ(materials[0]["name"], "towel");
    EXPECT_TRUE(materials[0]["pbrMetallicRoughness"].contains("baseColorFactor"));
    EXPECT_EQ(materials[1]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
    const Json& view = glb.json["bufferViews"].at(glb.json["images"][0]["bufferView"].get<std::size_t>());
    EXPECT_EQ(glb.bytes.substr(view["byteOffset"], view["byteLength"]), std::string(7, '\5'));
}

TEST_F(GltfFileTest, the_weight_of_a_frame_is_1_at_its_time_and_0_at_those_of_others)
{
    const Glb glb = write(3);
    const Json& animation = glb.json["animations"][0];
    ASSERT_EQ(animation["channels"].size(), 2u);
    EXPECT_EQ(animation["channels"][1]["target"], (Json{{"node", 1}, {"path", "weights"}}));
    const Json& sampler = animation["samplers"][0];
    const Json& accessors = glb.json["accessors"];
    EXPECT_EQ(numbers_of<float>(glb, accessors.at(sampler["input"].get<std::size_t>())),
              (std::vector<float>{0, float(1 / 60.0), float(2 / 60.0)}));
    EXPECT_EQ(numbers_of<float>(glb, accessors.at(sampler["output"].get<std::size_t>())),
              (std::vector<float>{0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(glb.json["meshes"][0]["weights"], (Json{0, 0}));
}

TEST_F(GltfFileTest, a_seam_of_the_texture_splits_vertices_and_not_the_light)
{
    // Two squares that meet at a right angle along vertices 1 and 2, and a triangle in a part of its own.
    const std::vector<glm::vec4> positions = {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 1, 0},
                                              {1, 1, 1, 0}, {5, 0, 0, 0}, {6, 0, 0, 0}, {5, 1, 0, 0}};
    GltfCloth cloth;
    cloth.faces = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {6, 7, 8}};
    cloth.parts = {{"corner", 0, 6, 0, 4, {}}, {"rest", 6, 3, 4, 1, {}}};
    cloth.uvs.resize(9, {0.25f, 0});
    split_at_seams(cloth,
                   {{2, 8, 1}, {{1, 1}, {0.5f, 0}, {1, 0}}, {{0, 11, 9}, {0, 9, 3}, {1, 4, 5}, {1, 5, 2}, {6, 7, 10}}});
    GltfFile file(directory.path() / "c.glb", cloth);
    file.add(positions, 0);
    file.add(positions, 1);
    file.finish();
    const Glb glb = read_glb(directory.path() / "c.glb");
    const auto numbers = [&](const Json& index) {
        return numbers_of<float>(glb, glb.json["accessors"].at(index.get<std::size_t>()));
    };
    const Json& corner = glb.json["meshes"][0]["primitives"][0];
    const auto faces = numbers_of<std::uint32_t>(glb, glb.json["accessors"].at(corner["indices"].get<std::size_t>()));
    EXPECT_EQ(faces, (std::vector<std::uint32_t>{0, 7, 6, 0, 6, 3, 1, 4, 5, 1, 5, 2}));
    const auto place = numbers(corner["attributes"]["POSITION"]), light = numbers(corner["attributes"]["NORMAL"]);
    const auto uvs = numbers(corner["attributes"]["TEXCOORD_0"]);
    ASSERT_EQ(place.size(), 3u * 8);
    EXPECT_EQ(numbers(corner["targets"][0]["NORMAL"]).size(), 3u * 8);
    for (const auto& [copy, vertex] : {std::pair{6u, 2u}, {7u, 1u}}) {
        for (unsigned k = 0; k < 3; ++k) {
            EXPECT_EQ(place[3 * copy + k], positions[vertex][int(k)]);
            EXPECT_EQ(light[3 * copy + k], light[3 * vertex + k]);
        }
        EXPECT_NE(light[3 * vertex], 0) << "of both squares";
        EXPECT_NE(light[3 * vertex + 2], 0);
        EXPECT_EQ(uvs[2 * copy], 1);
        EXPECT_EQ(uvs[2 * vertex], 0.25f);
    }
    const Json& rest = glb.json["meshes"][1]["primitives"][0];
    EXPECT_EQ(numbers(rest["attributes"]["POSITION"]), (std::vector<float>{5, 0, 0, 6, 0, 0, 5, 1, 0, 5, 1, 0}));
}

TEST_F(GltfFileTest, one_frame_is_a_mesh_at_rest_and_none_is_no_file)
{
    const Glb glb = write(1);
    EXPECT_FALSE(glb.json.contains("animations"));
    EXPECT_FALSE(glb.json["meshes"][0].contains("weights"));
    fs::remove(directory.path() / "c.glb");
    {
        GltfFile none(directory.path() / "c.glb", two_sheets());
        none.finish();
    }
    EXPECT_TRUE(fs::is_empty(directory.path()));
}

}  // namespace
}  // namespace nuno
