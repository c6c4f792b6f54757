// Names and companions of mesh files.
#include "app/mesh_output.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/files.h"
#include "render/png_file.h"
#include "render/texture_file.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOwn = "# nuno\n";  // what OBJ and MTL files of nuno begin with

// A file that goes beside the one that the user named.
void check_may_replace(const fs::path& path)
{
    if (fs::exists(path) && !read_text(path).starts_with(kOwn))
        throw Error(fmt::format("{}: would be replaced, and was not written by nuno; move it, or choose another name",
                                path.string()));
}

fs::path beside(const fs::path& path, const char* ending) { return fs::path(path).replace_extension(ending); }

GltfCloth gltf_cloth(const Simulation& simulation, std::span<const MeshPart> parts, float repeats)
{
    const ClothModel& model = simulation.model();
    GltfCloth cloth{{}, model.uvs, model.faces, repeats, {}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Sheet& sheet = model.sheets[i];
        const fs::path& texture = simulation.scene().sheets[i].texture;
        std::vector<std::byte> png;
        if (!texture.empty()) png = encode_png(load_picture(texture, std::numeric_limits<int>::max()));
        cloth.parts.push_back({parts[i].name, sheet.first_vertex, sheet.vertex_count, sheet.first_face,
                               sheet.face_count, std::move(png)});
    }
    split_at_seams(cloth, model.seams);
    return cloth;
}

}  // namespace

MeshOutput::MeshOutput(const MeshPlan& plan, const Simulation& simulation, float repeats)
    : plan_(plan), repeats_(repeats), parts_(mesh_parts(simulation.model()))
{
    if (plan_.format == MeshFormat::obj) check_may_replace(plan_.directory / "mesh.mtl");
    if (!plan_.pc2.empty()) {
        for (const char* ending : {".obj", ".mtl"}) check_may_replace(beside(plan_.pc2, ending));
        cache_.emplace(plan_.pc2, simulation.model().vertex_count());
    }
    if (!plan_.gltf.empty()) gltf_.emplace(plan_.gltf, gltf_cloth(simulation, parts_, repeats_));
}

void MeshOutput::write(Simulation& simulation)
{
    const auto name = [&](const char* ending) { return fmt::format("mesh_{:05}.{}", simulation.frame(), ending); };
    const bool is_first = std::exchange(is_first_, false);
    if (plan_.format == MeshFormat::obj) {
        if (is_first) write_materials(simulation, plan_.directory / "mesh.mtl");
        write_obj(simulation, plan_.directory / name("obj"), "mesh.mtl");
    }
    if (plan_.format == MeshFormat::ply) {
        const MeshView mesh{simulation.state().positions, {}, simulation.model().faces, {}, {}};
        write_whole(plan_.directory / name("ply"), ply_text(mesh));
    }
    if (cache_ && is_first) {
        const fs::path materials = beside(plan_.pc2, ".mtl");
        write_materials(simulation, materials);
        write_obj(simulation, beside(plan_.pc2, ".obj"), materials.filename());
    }
    if (cache_) cache_->add(simulation.state().positions);
    if (gltf_) gltf_->add(simulation.state().positions, simulation.time_s());
}

void MeshOutput::write_obj(Simulation& simulation, const fs::path& path, const fs::path& materials)
{
    const ClothModel& model = simulation.model();
    const std::string material_file = materials.string();
    write_whole(path,
                obj_text({simulation.state().positions, model.uvs, model.faces, parts_, material_file, &model.seams}));
}

void MeshOutput::write_materials(const Simulation& simulation, const fs::path& path) const
{
    std::vector<MeshPart> parts = parts_;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const fs::path& texture = simulation.scene().sheets[i].texture;
        if (texture.empty()) continue;
        std::error_code status;
        const fs::path way = fs::proximate(texture, fs::absolute(path).parent_path(), status);
        parts[i].texture = (status ? texture : way).generic_string();
    }
    write_whole(path, mtl_text(parts, repeats_));
}

void MeshOutput::finish_cache()
{
    if (cache_) cache_->finish();
}

void MeshOutput::finish_gltf()
{
    if (gltf_) gltf_->finish();
}

}  // namespace nuno
