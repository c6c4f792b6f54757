// Where the meshes of a headless run go: OBJ and PLY files, a point cache, a glTF file.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "model/gltf_file.h"
#include "model/mesh_writer.h"
#include "model/point_cache.h"
#include "sim/simulation.h"

namespace nuno {

enum class MeshFormat
{
    none,
    obj,
    ply
};

struct MeshPlan
{
    std::filesystem::path directory;  // of mesh_00000.obj, ...
    MeshFormat format = MeshFormat::none;
    std::filesystem::path pc2, gltf;  // empty: none
};

class MeshOutput
{
  public:
    // `repeats`: of textures along a sheet. Error where a texture that goes into the glTF file cannot be read, and where
    // a file that nuno did not write would be replaced by one that the user did not name.
    MeshOutput(const MeshPlan& plan, const Simulation& simulation, float repeats);

    // Writes what the plan says of the present frame.
    void write(Simulation& simulation);
    // Gives the files of many frames their names.
    void finish_cache();
    void finish_gltf();

  private:
    void write_obj(Simulation& simulation, const std::filesystem::path& path, const std::filesystem::path& materials);
    void write_materials(const Simulation& simulation, const std::filesystem::path& path) const;

    MeshPlan plan_;
    bool is_first_ = true;  // frame to be written, with which the files go that stand beside
    float repeats_;
    std::vector<MeshPart> parts_;
    std::optional<PointCache> cache_;
    std::optional<GltfFile> gltf_;
};

}  // namespace nuno
