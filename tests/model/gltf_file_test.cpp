// Binary glTF files, read back byte by byte as the specification says.
#include "model/gltf_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "core/files.h"
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
