// Writes meshes as text.
#include "model/mesh_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace nuno {
namespace {

using Text = std::back_insert_iterator<fmt::memory_buffer>;

void write_faces(Text out, const MeshView& mesh, std::uint32_t first_face, std::uint32_t face_count)
{
    const bool has_seams = mesh.seams != nullptr && !mesh.seams->empty();
    for (std::uint32_t number = first_face; number < first_face + face_count; ++number) {
        const glm::uvec3 f = mesh.faces[number], t = has_seams ? mesh.seams->faces[number] : f;
        if (mesh.uvs.empty())
            fmt::format_to(out, "f {} {} {}\n", f.x + 1, f.y + 1, f.z + 1);
        else
            fmt::format_to(out, "f {}/{} {}/{} {}/{}\n", f.x + 1, t.x + 1, f.y + 1, t.y + 1, f.z + 1, t.z + 1);
    }
}

}  // namespace

std::vector<MeshPart> mesh_parts(const ClothModel& model)
{
    std::vector<MeshPart> parts;
    for (const Sheet& sheet : model.sheets) {
        std::string name = sheet.name.empty() ? "cloth" : sheet.name;
        std::replace_if(
            name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) || c == '#'; }, '_');
        const auto taken = [&](const std::string& wanted) {
            return std::any_of(parts.begin(), parts.end(), [&](const MeshPart& part) { return part.name == wanted; });
        };
        std::string unique = name;
        for (int number = 2; taken(unique); ++number) unique = fmt::format("{}_{}", name, number);
        parts.push_back({unique, sheet.first_face, sheet.face_count, {}});
    }
    return parts;
}

std::string obj_text(const MeshView& mesh)
{
    fmt::memory_buffer text;
    const Text out = std::back_inserter(text);
    fmt::format_to(out, "# nuno\n");
    if (!mesh.material_file.empty()) fmt::format_to(out, "mtllib {}\n", mesh.material_file);
    for (const glm::vec4& p : mesh.positions) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    for (const glm::vec2& uv : mesh.uvs) fmt::format_to(out, "vt {:.9g} {:.9g}\n", uv.x, uv.y);
    if (mesh.seams != nullptr)
        for (const glm::vec2& uv : mesh.seams->uvs) fmt::format_to(out, "vt {:.9g} {:.9g}\n", uv.x, uv.y);
    for (const MeshPart& part : mesh.parts) {
        fmt::format_to(out, "g {}\n", part.name);
        if (!mesh.material_file.empty()) fmt::format_to(out, "usemtl {}\n", part.name);
        write_faces(out, mesh, part.first_face, part.face_count);
    }
    if (mesh.parts.empty()) write_faces(out, mesh, 0, static_cast<std::uint32_t>(mesh.faces.size()));
    return fmt::to_string(text);
}

std::string ply_text(const MeshView& mesh)
{
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "ply\nformat ascii 1.0\ncomment nuno\nelement vertex {}\nproperty float x\nproperty float y\n"
                   "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
                   mesh.positions.size(), mesh.faces.size());
    for (const glm::vec4& p : mesh.positions) fmt::format_to(out, "{:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    for (const glm::uvec3& f : mesh.faces) fmt::format_to(out, "3 {} {} {}\n", f.x, f.y, f.z);
    return fmt::to_string(text);
}

std::string mtl_text(std::span<const MeshPart> parts, float repeats)
{
    std::string text = "# nuno\n";
    for (const MeshPart& part : parts) {
        text += fmt::format("newmtl {}\nKa 0 0 0\nKs 0 0 0\n", part.name);
        text += part.texture.empty()
                    ? "Kd 0.87 0.85 0.8\n"
                    : fmt::format("Kd 1 1 1\nmap_Kd -s {0:.9g} {0:.9g} 1 {1}\n", repeats, part.texture);
    }
    return text;
}

}  // namespace nuno
