// The comparison as a picture.
#include "study/compare_plot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "core/files.h"

extern char** environ;

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

// For a text in single quotes.
std::string quoted(std::string text)
{
    for (std::size_t at = 0; (at = text.find('\'', at)) != text.npos; at += 2) text.insert(at, 1, '\'');
    return text;
}

std::string script_text(const std::vector<std::string>& scenes, bool software_gl)
{
    std::string plot = "plot ";
    for (std::size_t i = 0; i < scenes.size(); ++i)
        plot += fmt::format(
            "{0}'compare.dat' index {1} using 1:2 with linespoints lc {2} pt 7 dt 1 title '{3}, CPU', \\\n"
            "     'compare.dat' index {1} using 1:3 with linespoints lc {2} pt 4 dt 2 title '{3}, GPU'",
            i ? ", \\\n     " : "", i, i + 1, quoted(scenes[i]));
    return fmt::format(
        "set logscale xy\nset grid\nset key outside right noenhanced\nset xlabel 'particles'\n"
        "set ylabel 'ns a particle and substep'\nset title 'nuno: CPU threads against compute shaders{0}'\n"
        "set terminal svg size 1000,600 background 'white'\nset output 'compare.svg.part'\n{1}\n"
        "set terminal pngcairo size 1000,600\nset output 'compare.png.part'\nreplot\n",
        software_gl ? " (software OpenGL: times of a CPU)" : "", plot);
}

bool run_gnuplot(const fs::path& directory)
{
    const char* arguments[] = {"gnuplot", "compare.gp", nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, const_cast<char**>(arguments), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 1;
    return !failed && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool plot_comparison(const std::vector<ComparePoint>& points, bool software_gl, const fs::path& directory)
{
    if (points.empty()) return false;
    std::vector<std::string> scenes;
    write_whole(directory / "compare.dat", data_text(points, scenes));
    write_whole(directory / "compare.gp", script_text(scenes, software_gl));
    std::error_code status;
    const bool drawn = run_gnuplot(directory);
    for (const char* name : {"compare.svg", "compare.png"}) {
        const fs::path part = directory / (std::string(name) + ".part");
        if (drawn)
            fs::rename(part, directory / name, status);
        else
            fs::remove(part, status);
    }
    return drawn && !status;
}

}  // namespace nuno
