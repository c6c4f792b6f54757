// Files that are never left half-written.
#include "core/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.h"
#include "core/whole_file.h"

namespace nuno {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path)
{
    std::error_code status;
    if (fs::is_directory(path, status)) throw Error(path.string() + ": is a directory; name a file");
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw Error(path.string() + ": cannot be read (" + std::strerror(errno) +
                    "); give the path of an existing file");
    std::ostringstream text;
    text << in.rdbuf();
    if (in.bad()) throw Error(path.string() + ": reading failed (" + std::strerror(errno) + ")");
    return text.str();
}

void write_whole(const fs::path& path, std::span<const std::byte> bytes)
{
    WholeFile file(path);
    file.append(bytes);
    file.commit();
}

void write_whole(const fs::path& path, std::string_view text) { write_whole(path, std::as_bytes(std::span(text))); }

void make_writable_directory(const fs::path& directory)
{
    std::error_code status;
    fs::create_directories(directory, status);
    if (status || !fs::is_directory(directory))
        throw Error(directory.string() + ": cannot be made a directory (" +
                    (status ? status.message() : "a file of that name is in the way") + "); choose another place");
    if (::access(directory.c_str(), W_OK | X_OK) != 0)
        throw Error(directory.string() + ": cannot be written (" + std::strerror(errno) +
                    "); choose another directory");
}

void check_can_write(const fs::path& path)
{
    std::error_code status;
    const fs::path directory = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (fs::is_directory(path, status)) throw Error(path.string() + ": is a directory; name a file");
    if (!fs::is_directory(directory, status) || ::access(directory.c_str(), W_OK | X_OK) != 0)
        throw Error(path.string() + ": cannot be written, since " + directory.string() +
                    " is no directory that can be written to; choose another place");
}

fs::path root_directory()
{
    const char* chosen = std::getenv("NUNO_ROOT");
    if (chosen && *chosen) return chosen;
    std::error_code status;
    const fs::path program = fs::read_symlink("/proc/self/exe", status);
    const fs::path installed = program.parent_path().parent_path() / "share" / "nuno";
    return fs::is_directory(installed / "assets", status) ? installed : fs::path(NUNO_ROOT_DIR);
}

}  // namespace nuno
