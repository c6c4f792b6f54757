// A video of the frames, encoded by ffmpeg.
#include "app/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "core/error.h"

extern char** environ;

namespace nuno {
namespace {

namespace fs = std::filesystem;

// Starts `words` with `input` as its standard input; -1 where the program is not there.
pid_t start(const std::vector<std::string>& words, int input)
{
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    // A group of its own: Ctrl-C on the terminal is for nuno, which then closes the pipe and lets the video be
    // finished.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    pid_t child = -1;
    const int failed = posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    errno = failed;
    return failed ? -1 : child;
}

}  // namespace

VideoFile::VideoFile(fs::path path, int width, int height, double frames_per_second) : path_(std::move(path))
{
    // The ending stays last, for ffmpeg knows the format by it.
    temporary_ =
        path_.parent_path() / fmt::format("{}.part{}{}", path_.stem().string(), getpid(), path_.extension().string());
    std::signal(SIGPIPE, SIG_IGN);  // an encoder that ends early is an error of write
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw Error(fmt::format("--video {}: no pipe to ffmpeg could be made", path_.string()));
    encoder_ = start({"ffmpeg",
                      "-nostdin",
                      "-loglevel",
                      "error",
                      "-xerror",  // without it a disk that is full at the end goes unnoticed
                      "-y",
                      "-f",
                      "rawvideo",
                      "-pix_fmt",
                      "rgba",
                      "-s",
                      fmt::format("{}x{}", width, height),
                      "-r",
                      fmt::format("{}", frames_per_second),
                      "-i",
                      "pipe:0",
                      "-vf",
                      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                      "-pix_fmt",
                      "yuv420p",
                      temporary_.string()},
                     ends[0]);
    ::close(ends[0]);
    pipe_ = ends[1];
    if (encoder_ >= 0) return;
    ::close(pipe_);
    throw Error(
        fmt::format("{}: a video needs ffmpeg, which cannot be started ({}); install the package ffmpeg, or write "
                    "PNG files instead",
                    path_.string(), std::strerror(errno)));
}

VideoFile::~VideoFile()
{
    close_and_wait();
    std::error_code ignored;
    fs::remove(temporary_, ignored);
}

void VideoFile::add(const Picture& picture)
{
    for (std::size_t done = 0; done < picture.rgba.size();) {
        const ssize_t written = ::write(pipe_, picture.rgba.data() + done, picture.rgba.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw_failed();
        done += static_cast<std::size_t>(written);
    }
    ++picture_count_;
}

void VideoFile::finish()
{
    close_and_wait();
    if (failed_ || status_ != 0) throw_failed();
    std::error_code status;
    fs::rename(temporary_, path_, status);
    if (status) throw_failed();
}

void VideoFile::close_and_wait()
{
    if (encoder_ < 0) return;
    ::close(pipe_);
    while (waitpid(encoder_, &status_, 0) < 0 && errno == EINTR) {
    }
    encoder_ = -1;
}

void VideoFile::throw_failed()
{
    failed_ = true;
    close_and_wait();
    if (WIFSIGNALED(status_))
        throw Error(fmt::format(
            "--video {}: ffmpeg was ended by signal {} ({}) at picture {}; there is no video, so run again with more "
            "memory free, or encode the pictures of --out",
            path_.string(), WTERMSIG(status_), strsignal(WTERMSIG(status_)), picture_count_));
    throw Error(fmt::format(
        "--video {}: ffmpeg could not write it; give a place with room, and an ending that it knows, such as "
        ".mp4 or .webm",
        path_.string()));
}

}  // namespace nuno
