// A triangle mesh as it comes from a file or a grid.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/texture_seams.h"

namespace nuno {

struct TriangleMesh
{
    std::vector<glm::vec3> positions;                          // [m]
    std::vector<glm::vec2> uvs;                                // one a vertex
    TextureSeams seams;                                        // where faces wear others
    std::vector<glm::uvec3> faces;                             // vertex indices, counter-clockwise seen from the front
    std::map<std::string, std::vector<std::uint32_t>> groups;  // vertices, in order, of each named part of a file
};

// Area of a face [m2].
float face_area(const TriangleMesh& mesh, const glm::uvec3& face);

// A Wavefront OBJ file, every polygon cut into triangles; its objects (`o`) and groups (`g`) are the groups. Of several
// texture coordinates of a vertex the last is its own, the others are of seams; one without any gets its place in the
// bounding box. Error (path, and
// line or element) where it cannot be read or check_mesh refuses it.
TriangleMesh load_obj(const std::filesystem::path& path);

// Error, prefixed by `where`, for a mesh that is no cloth: no vertices or faces, a position that is not finite, an
// index out of range, a face of zero area or given twice, or a vertex in no face.
void check_mesh(const TriangleMesh& mesh, std::string_view where);

}  // namespace nuno
