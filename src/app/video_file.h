// A video of the frames, encoded by ffmpeg while they are made.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "render/picture.h"

namespace nuno {

class VideoFile
{
  public:
    // Starts ffmpeg. Error where it is not installed.
    VideoFile(std::filesystem::path path, int width, int height, double frames_per_second);
    // A video that was not finished is removed.
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    // Error where ffmpeg has ended before its time; then there will be no video.
    void add(const Picture& picture);
    // Waits for ffmpeg and gives the file its name. Error where it could not be written.
    void finish();

  private:
    [[noreturn]] void throw_failed();
    void close_and_wait();

    std::filesystem::path path_, temporary_;
    pid_t encoder_ = -1;
    int pipe_ = -1;
    int status_ = 0;  // of waitpid, once it has ended
    bool failed_ = false;
    int picture_count_ = 0;  // handed over whole
};

}  // namespace nuno
