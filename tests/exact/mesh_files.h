// Reads the meshes that the checking programs look at: PLY (ascii and binary) and OBJ, triangles only.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace nuno {

struct CheckedMesh
{
    std::vector<std::array<double, 3>> positions;     // as precise as the type that a PLY file names; of OBJ, float
    std::vector<std::array<std::uint32_t, 3>> faces;  // counted as in the file
};

// std::runtime_error naming the file, and line or element, where it is no such mesh, has no face, or a face names no
// vertex.
CheckedMesh read_mesh(const std::filesystem::path& path);

}  // namespace nuno
