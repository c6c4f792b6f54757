// Files that are never left half-written.
#include "core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.h"

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
    std::error_code status;
    // A link stays a link to what is written; a device or a pipe takes the bytes itself.
    const fs::path target = fs::is_symlink(path, status) ? fs::weakly_canonical(path, status) : path;
    const bool direct = fs::exists(target, status) && !fs::is_regular_file(target, status);
    const fs::path temporary = direct ? target : fs::path(target.string() + ".part" + std::to_string(getpid()));
    const auto fail = [&](const char* action) {
        const int reason = errno;
        if (!direct) ::unlink(temporary.c_str());
        throw Error(path.string() + ": cannot be " + action + " (" + std::strerror(reason) +
                    "); choose a place that exists, is writable and has room");
    };
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) fail("created");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            const int reason = errno;
            ::close(file);
            errno = reason;
            fail("written");
        }
        done += static_cast<std::size_t>(written);
    }
    if (::close(file) != 0) fail("written");
    if (!direct && ::rename(temporary.c_str(), target.c_str()) != 0) fail("written");
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
