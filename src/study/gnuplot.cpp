// Runs gnuplot on a script.
#include "study/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/files.h"

extern char** environ;

namespace nuno {
namespace {

namespace fs = std::filesystem;

bool run_gnuplot(const fs::path& directory, const std::string& script)
{
    const char* arguments[] = {"gnuplot", script.c_str(), nullptr};
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

std::string gnuplot_quoted(std::string text)
{
    for (std::size_t at = 0; (at = text.find('\'', at)) != text.npos; at += 2) text.insert(at, 1, '\'');
    return text;
}

bool draw_with_gnuplot(const fs::path& directory, const std::string& name, const std::string& script, int width,
                       int height)
{
    const std::string whole = fmt::format(
        "set terminal svg size {1},{2} background 'white'\nset output '{0}.svg.part'\n{3}\n"
        "set terminal pngcairo size {1},{2}\nset output '{0}.png.part'\n{3}\n",
        name, width, height, script);
    write_whole(directory / (name + ".gp"), whole);
    const bool drawn = run_gnuplot(directory, name + ".gp");
    std::error_code status;
    for (const std::string& picture : {name + ".svg", name + ".png"}) {
        const fs::path part = directory / (picture + ".part");
        if (drawn)
            fs::rename(part, directory / picture, status);
        else
            fs::remove(part, status);
    }
    return drawn && !status;
}

}  // namespace nuno
