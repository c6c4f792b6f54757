// Writes the mesh of one frame: OBJ files with their material files, and PLY files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/cloth_model.h"

namespace nuno {

// The faces of a sheet: a group and a material of an OBJ file.
struct MeshPart
{
    std::string name;  // without spaces, and no other part's
    std::uint32_t first_face, face_count;
    std::string texture;  // its path from the material file; empty: plain cloth
};

// The parts that the sheets are; their textures stay empty.
std::vector<MeshPart> mesh_parts(const ClothModel& model);

// What a mesh file shows; positions are xyz [m], written with 9 significant digits, which give back the same floats.
struct MeshView
{
    std::span<const glm::vec4> positions;
    std::span<const glm::vec2> uvs;
    std::span<const glm::uvec3> faces;
    std::span<const MeshPart> parts = {};  // in order of their faces, which are all; none: no groups
    std::string_view material_file = {};   // its path from the OBJ file; empty: no materials
    const TextureSeams* seams = nullptr;   // of the texture coordinates; nullptr: none
};

std::string obj_text(const MeshView& mesh);
std::string ply_text(const MeshView& mesh);

// The material file of the parts; `repeats`: of a texture along a sheet.
std::string mtl_text(std::span<const MeshPart> parts, float repeats);

}  // namespace nuno
