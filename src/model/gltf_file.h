// Binary glTF 2.0 files of cloth in motion: one file that other programs play.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/whole_file.h"
#include "model/texture_seams.h"

namespace nuno {

// A sheet: a mesh with a material of its own.
struct GltfPart
{
    std::string name;
    std::uint32_t first_vertex, vertex_count;
    std::uint32_t first_face, face_count;
    std::vector<std::byte> png;  // the texture; empty: plain cloth
};

// What stays while the cloth moves.
struct GltfCloth
{
    std::vector<GltfPart> parts;  // in order of their vertices and faces, which are all
    std::vector<glm::vec2> uvs;   // one a vertex, (0, 0) the lower left corner of a texture
    std::vector<glm::uvec3> faces;
    float repeats = 1;                         // of a texture along a sheet
    std::vector<std::uint32_t> vertices = {};  // of the simulation, one for each above; none: the same
};

// Adds to each part the copies of its vertices that the seams of its texture need.
void split_at_seams(GltfCloth& cloth, const TextureSeams& seams);

struct GltfBox
{
    glm::vec3 low, high;
};

// The first frame is the mesh; each later one a morph target that holds the way of every vertex from there, and that of
// its smooth normal, and an animation goes from target to target. Frames go to a second temporary file as they come.
class GltfFile
{
  public:
    // Error naming the path where it cannot be written, here as in the calls below.
    GltfFile(const std::filesystem::path& path, GltfCloth cloth);
    // One frame, xyz [m] of every vertex of the simulation, at a time [s] later than the last. Error beyond the 4 GiB of the format.
    void add(std::span<const glm::vec4> positions, double time_s);
    // The file is there from now on, with the frames so far; without frames it is not, as without this call.
    void finish();

  private:
    std::size_t target_count() const { return times_.size() - 1; }  // after a first frame
    void add_cloth(nlohmann::ordered_json& json, std::vector<std::byte>& bytes) const;
    void add_targets(nlohmann::ordered_json& json, std::size_t start) const;
    void add_animation(nlohmann::ordered_json& json, std::vector<std::byte>& bytes) const;

    GltfCloth cloth_;
    std::vector<glm::uvec3> simulated_faces_;  // by vertices of the simulation
    WholeFile file_, moves_;                   // moves_ is never committed
    std::vector<glm::vec3> first_;  // positions of the first frame, then its normals; so is a frame of moves_
    std::vector<float> times_;
    std::vector<GltfBox> boxes_;  // of what frames hold, part by part, frame by frame
};

}  // namespace nuno
