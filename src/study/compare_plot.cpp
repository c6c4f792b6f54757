// The comparison as a picture.
#include "study/compare_plot.h"

#include <fmt/format.h>

#include <string>

#include "core/files.h"
#include "study/gnuplot.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

// One block of lines (particles, ns on the CPU, ns on the GPU) for each scene, as gnuplot's `index` finds them.
std::string data_text(const std::vector<ComparePoint>& points, std::vector<std::string>& scenes)
{
    std::string text = "# particles  cpu_ns_per_particle_and_substep  gpu_ns_per_particle_and_substep\n";
    for (const ComparePoint& p : points) {
        if (scenes.empty() || scenes.back() != p.scene) {
            if (!scenes.empty()) text += "\n\n";
            scenes.push_back(p.scene);
        }
        text += fmt::format("{} {} {}\n", p.particles, p.cpu.ns_per_particle_and_substep,
                            p.gpu.ns_per_particle_and_substep);
    }
    return text;
}

std::string script_text(const std::vector<std::string>& scenes, bool software_gl)
{
    std::string plot = "plot ";
    for (std::size_t i = 0; i < scenes.size(); ++i)
        plot += fmt::format(
            "{0}'compare.dat' index {1} using 1:2 with linespoints lc {2} pt 7 dt 1 title '{3}, CPU', \\\n"
            "     'compare.dat' index {1} using 1:3 with linespoints lc {2} pt 4 dt 2 title '{3}, GPU'",
            i ? ", \\\n     " : "", i, i + 1, gnuplot_quoted(scenes[i]));
    return fmt::format(
        "set logscale xy\nset grid\nset key outside right noenhanced\nset xlabel 'particles'\n"
        "set ylabel 'ns a particle and substep'\nset title 'nuno: CPU threads against compute shaders{0}'\n"
        "{1}",
        software_gl ? " (software OpenGL: times of a CPU)" : "", plot);
}

}  // namespace

bool plot_comparison(const std::vector<ComparePoint>& points, bool software_gl, const fs::path& directory)
{
    if (points.empty()) return false;
    std::vector<std::string> scenes;
    write_whole(directory / "compare.dat", data_text(points, scenes));
    return draw_with_gnuplot(directory, "compare", script_text(scenes, software_gl));
}

}  // namespace nuno
