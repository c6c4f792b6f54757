// The memory of `nuno auto`.
#include "app/auto_memory.h"

#include <fmt/format.h>

#include <cstdlib>

#include "core/files.h"
#include "core/hash.h"
#include "core/version.h"
#include "sim/run_recorder.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string hash_of_text(const std::string& text)
{
    Fnv1a hash;
    hash.add(text.data(), text.size());
    return fmt::format("{:016x}", hash.value());
}

template <class Value>
void add(Fnv1a& hash, const std::vector<Value>& values)
{
    hash.add(values.data(), values.size() * sizeof(Value));
}

// Of all vertices and faces, of sheets and of bodies: a scene names the files, and they change.
std::string hash_of_meshes(const Scene& scene, const SimParams& params)
{
    const ClothModel model = build_cloth_model(make_sheets(scene, params), params.mass_lumping);
    Fnv1a hash;
    add(hash, model.rest_positions);
    add(hash, model.faces);
    for (const MeshBody& body : scene.bodies.meshes) {
        add(hash, body.mesh.positions);
        add(hash, body.mesh.faces);
    }
    return fmt::format("{:016x}", hash.value());
}

std::string scene_text(const SceneStudy& study) { return read_text(study.scene().path); }
Json study_params(const SceneStudy& study) { return params_json(sim_param_table(), &study.asked_params()); }

// Two builds of a tree with changes have one version.
std::string program_text()
{
    std::error_code status;
    const fs::path program = fs::read_symlink("/proc/self/exe", status);
    return fmt::format("{} ({}), build {}", kVersion, kCommit,
                       status ? "unknown" : hash_of_text(read_text("/proc/self/exe")));
}

}  // namespace

Json memory_header(const SceneStudy& study)
{
    const int threads = ThreadPool(study.asked_params().threads).thread_count();
    return {{"study", "auto"},
            {"version", program_text()},
            {"machine", {{"cpu", cpu_name()}, {"threads", threads}}},
            {"scene", scene_text(study)},
            {"meshes", hash_of_meshes(study.scene(), study.asked_params())},
            {"params", study_params(study)}};
}

fs::path memory_directory(const SceneStudy& study)
{
    const std::string name = hash_of_text(Json(scene_text(study)).dump() + study_params(study).dump());
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != 0) return fs::path(cache) / "nuno/auto" / name;
    const char* home = std::getenv("HOME");
    return (home != nullptr && *home != 0 ? fs::path(home) : fs::temp_directory_path()) / ".cache/nuno/auto" / name;
}

}  // namespace nuno
