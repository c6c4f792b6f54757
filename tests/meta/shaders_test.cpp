// Every shader file is used by the program, and compiles as it uses it.
#include <map>
#include <memory>

#include "core/error.h"
#include "core/thread_pool.h"
#include "gl/gl_test.h"
#include "gl/shader_folder.h"
#include "meta/tree.h"
#include "model/cloth_model.h"
#include "render/overlay_renderer.h"
#include "render/scene_view.h"
#include "solver/method_table.h"
#include "support/bodies.h"

namespace nuno::meta {
namespace {

// One grid, with the springs that a grid has and those that a mesh has.
ClothModel small_cloth(bool as_mesh, bool on_handle)
{
    SheetSource sheet;
    sheet.name = "cloth";
    sheet.mesh = grid_mesh(4, 4, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
    if (!as_mesh) sheet.columns = sheet.rows = 4;
    if (on_handle) sheet.handle_pins = {{0, 0}};
    return build_cloth_model(std::span(&sheet, 1), MassLumping::area);
}

// Compiles all that the program compiles: the kernels of every method, and what draws a picture.
void compile_everything(const Bodies& bodies, bool as_mesh)
{
    const ClothModel model = small_cloth(as_mesh, true), on_no_handle = small_cloth(as_mesh, false);
    ThreadPool pool(1);
    for (const MethodInfo& method : method_table()) {
        if (!method.on(Backend::gpu)) continue;
        SimParams params;
        params.method = method.method;
        params.backend = Backend::gpu;
        for (const Sweep sweep : {Sweep::jacobi, Sweep::coloured}) {
            params.sweep = sweep;
            make_solver(model, bodies, params, pool);
        }
        // Here small cloths are not taken in one dispatch, or are.
        SimParams bending = params;
        bending.bending_warp = bending.bending_weft = bending.bending_bias = 1e-4f;
        make_solver(model, bodies, bending, pool);
        const auto solver = make_solver(on_no_handle, bodies, params, pool);
        solver->set_contacts(std::vector<LayerContact>(1), on_no_handle.vertex_count(), ContactOrder::steady);
        if (!method.takes_continuum) continue;
        params.internal_model = InternalModel::continuum;
        params.wind_model = WindModel::aero;
        params.gust_speed = 1;
        make_solver(model, bodies, params, pool);
    }
    const TextureSeams seams{{0}, {{0, 0}}, model.faces};
    SceneView view({model.vertex_count(), model.faces, model.uvs, {}, {}, &seams});
    for (std::size_t look = 0; look < choice_names(Look{}).size(); ++look) view.prepare(static_cast<Look>(look));
    const OverlayRenderer overlays;
}

// The shaders of the source tree by their path under shaders/, the formulas that C++ shares included.
std::map<std::string, std::string> shader_texts()
{
    const std::string_view folder = "shaders/";
    std::map<std::string, std::string> texts;
    for (const std::string& file :
         files_under(folder, {".h", ".glsl", ".comp", ".vert", ".frag", ".geom", ".tesc", ".tese"}))
        texts[file.substr(folder.size())] = read_file(file);
    return texts;
}

std::string error_of_compiling()
{
    try {
        Bodies with_handle;
        with_handle.handles.resize(1);
        compile_everything(with_handle, false);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

using ShadersTest = GlTest;

TEST_F(ShadersTest, compile_for_grids_and_meshes_with_bodies_and_without)
{
    Bodies handle_alone;
    handle_alone.handles.resize(1);
    Bodies bodies = one_of_each_shape();
    bodies.handles.resize(1);
    for (const bool as_mesh : {false, true}) {
        compile_everything(handle_alone, as_mesh);
        compile_everything(bodies, as_mesh);
    }
}

// A file that nobody compiles could be spoiled without a trace: so each is spoiled, and must be complained of by name.
TEST_F(ShadersTest, that_have_a_main_or_are_for_glsl_alone_are_all_used)
{
    const std::map<std::string, std::string> texts = shader_texts();
    int count = 0;
    for (const auto& [spoiled, sound_text] : texts) {
        if (spoiled.ends_with(".h")) continue;
        ++count;
        const ShaderFolder folder;
        for (const auto& [file, text] : texts) folder.write(file, file == spoiled ? text + "\n#error spoiled\n" : text);
        const std::string error = error_of_compiling();
        EXPECT_NE(error.find("shaders/" + spoiled), std::string::npos) << spoiled << ": " << error;
        EXPECT_NE(error.find("spoiled"), std::string::npos) << spoiled << ": " << error;
    }
    EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace nuno::meta
