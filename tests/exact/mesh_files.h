// Reads the meshes that the checking programs look at: PLY (ascii and binary) and OBJ, triangles only, positions in double.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace nuno {

struct CheckedMesh
{
    std::vector<std::array<double, 3>> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;  // counted as in the file
};

// std::runtime_error naming the file, and line or element, where it is no such mesh or a face names no vertex.
CheckedMesh read_mesh(const std::filesystem::path& path);

}  // namespace nuno
