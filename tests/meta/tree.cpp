// Reads the source tree for the meta tests.
#include "meta/tree.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace nuno::meta {

namespace fs = std::filesystem;

std::string root() { return NUNO_ROOT_DIR; }

std::vector<std::string> files_under(std::string_view folder, std::initializer_list<std::string_view> endings)
{
    std::vector<std::string> found;
    const fs::path top = fs::path(root()) / folder;
    if (!fs::is_directory(top)) return found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top)) {
        const std::string name = entry.path().generic_string();
        const auto matches = [&](std::string_view ending) { return name.ends_with(ending); };
        if (entry.is_regular_file() && std::any_of(endings.begin(), endings.end(), matches))
            found.push_back(fs::relative(entry.path(), root()).generic_string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<std::vector<std::string>> tracked_files()
{
    const CommandResult listed =
        run_command("git -c safe.directory='*' ls-files --cached --others --exclude-standard 2>/dev/null");
    if (listed.exit_code != 0) return std::nullopt;
    std::vector<std::string> files = lines_of(listed.output);
    std::erase_if(files, [](const std::string& path) { return !fs::is_regular_file(fs::path(root()) / path); });
    return files;
}

std::string read_file(std::string_view path)
{
    std::ifstream in(fs::path(root()) / path, std::ios::binary);
    if (!in) throw std::runtime_error(std::string(path) + ": cannot be read");
    return std::string(std::istreambuf_iterator<char>(in), {});
}

std::vector<std::string> lines_of(std::string_view text)
{
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

CommandResult run_command(const std::string& command)
{
    FILE* pipe = popen(("cd '" + root() + "' && { " + command + "\n} 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot start: " + command);
    CommandResult result{};
    char block[4096];
    for (std::size_t count; (count = fread(block, 1, sizeof block, pipe)) > 0;) result.output.append(block, count);
    const int status = pclose(pipe);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

}  // namespace nuno::meta
