// What a picture costs in each look: 1280 x 720 pixels of a shipped scene, drawn and read back. `least_ms` and
// `least_cpu_ms` are the smallest of 60 pictures, by the clock and summed over all threads.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <string>

#include "core/stopwatch.h"
#include "gl/egl_context.h"
#include "render/scene_view.h"
#include "sim/simulation.h"

namespace nuno {
namespace {

ViewParams view_of(const Scene& scene)
{
    ViewParams view;
    for (const ViewSetting& setting : scene.view)
        set_param_text(*find_param(view_param_table(), setting.name), &view, setting.text, setting.where);
    return view;
}

std::vector<DrawnSheet> sheets_of(const Simulation& simulation)
{
    std::vector<DrawnSheet> sheets;
    for (std::size_t i = 0; i < simulation.model().sheets.size(); ++i) {
        const Sheet& sheet = simulation.model().sheets[i];
        sheets.push_back({sheet.first_face, sheet.face_count, simulation.scene().sheets[i].texture});
    }
    return sheets;
}

void draw(benchmark::State& state, const std::string& name, Look look)
{
    static const std::unique_ptr<Context> context = make_headless_context();
    const Scene scene = load_scene(name);
    Simulation simulation(scene, scene.params);
    while (simulation.time_s() < 1.5) simulation.advance_frame();
    const ClothModel& model = simulation.model();
    SceneView view({model.vertex_count(), model.faces, model.uvs, sheets_of(simulation), model.rest_positions});
    ViewParams params = view_of(scene);
    params.look = look;
    Picture picture;
    double least_ms = 1e30, least_cpu_ms = 1e30;
    for (auto _ : state) {
        const Stopwatch watch;
        const std::clock_t cpu_start = std::clock();
        const GLuint positions = view.upload_positions(simulation.state().positions);
        view.draw_picture(params, positions, {scene.bodies, simulation.time_s()}, picture);
        least_ms = std::min(least_ms, watch.elapsed_ms());
        least_cpu_ms = std::min(least_cpu_ms, 1e3 * double(std::clock() - cpu_start) / CLOCKS_PER_SEC);
    }
    state.counters["least_ms"] = least_ms;
    state.counters["least_cpu_ms"] = least_cpu_ms;
}

void register_all()
{
    for (const char* scene : {"seed", "flag", "drape", "mannequin", "curtain", "table"})
        for (const Look look : {Look::gouraud, Look::phong, Look::cloth}) {
            const std::string look_name(choice_names(look)[static_cast<std::size_t>(look)]);
            benchmark::RegisterBenchmark((std::string(scene) + "/" + look_name).c_str(), draw, scene, look)
                ->Iterations(60)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace
}  // namespace nuno

int main(int argc, char** argv)
{
    nuno::register_all();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
