// Temporary names, and writes that a full disk cuts short.
#include "core/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.h"

namespace nuno {

namespace fs = std::filesystem;

WholeFile::WholeFile(fs::path path) : path_(std::move(path))
{
    std::error_code status;
    // A link stays a link to what is written; a device or a pipe takes the bytes itself.
    target_ = fs::is_symlink(path_, status) ? fs::weakly_canonical(path_, status) : path_;
    const bool direct = fs::exists(target_, status) && !fs::is_regular_file(target_, status);
    temporary_ = direct ? target_ : fs::path(target_.string() + ".part" + std::to_string(getpid()));
    const int access = direct ? O_WRONLY : O_RDWR;
    file_ = ::open(temporary_.c_str(), access | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file_ < 0) fail("created");
}

WholeFile::~WholeFile()
{
    if (file_ >= 0) ::close(file_);
    if (file_ >= 0 && temporary_ != target_) ::unlink(temporary_.c_str());
}

void WholeFile::append(std::span<const std::byte> bytes)
{
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file_, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            const int reason = errno;
            if (::ftruncate(file_, static_cast<off_t>(size_)) == 0) ::lseek(file_, static_cast<off_t>(size_), SEEK_SET);
            errno = reason;
            fail("written");
        }
        done += static_cast<std::size_t>(written);
    }
    size_ += bytes.size();
}

void WholeFile::append_all_of(const WholeFile& other)
{
    std::vector<std::byte> piece(1 << 20);
    for (std::size_t at = 0; at < other.size_;) {
        const ssize_t count = ::pread(other.file_, piece.data(), piece.size(), static_cast<off_t>(at));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) other.fail("read back");
        append(std::span(piece).first(static_cast<std::size_t>(count)));
        at += static_cast<std::size_t>(count);
    }
}

void WholeFile::rewrite(std::size_t offset, std::span<const std::byte> bytes)
{
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written =
            ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail("written");
        done += static_cast<std::size_t>(written);
    }
}

void WholeFile::commit()
{
    const int file = file_;
    file_ = -1;
    const bool closed = ::close(file) == 0;
    if (closed && (temporary_ == target_ || ::rename(temporary_.c_str(), target_.c_str()) == 0)) return;
    const int reason = errno;
    if (temporary_ != target_) ::unlink(temporary_.c_str());
    errno = reason;
    fail("written");
}

void WholeFile::fail(const char* action) const
{
    throw Error(path_.string() + ": cannot be " + action + " (" + std::strerror(errno) +
                "); choose a place that exists, is writable and has room");
}

}  // namespace nuno
