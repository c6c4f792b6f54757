// Writes rendered frames as PNG files while the next ones are made.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#include "render/picture.h"

namespace nuno {

class FrameWriter
{
  public:
    FrameWriter();
    // Writes what was pushed and drops the error of a frame that could not be; call finish() to hear of it.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // Takes a frame; waits while several are queued. After a frame could not be written, no later one is: every call
    // throws that frame's Error.
    void push(std::filesystem::path path, Picture picture);

    // Waits until every frame is on the disk. Error where one could not be written.
    void finish();

    // Time [ms] that each frame took to encode and write, in the order of push; complete after finish().
    std::vector<double> encode_ms() const;

  private:
    struct Frame
    {
        std::filesystem::path path;
        Picture picture;
    };
    void run();
    void rethrow() const;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Frame> queue_;
    std::vector<double> encode_ms_;
    std::exception_ptr error_;
    bool busy_ = false, closing_ = false;
    std::thread worker_;  // last: it uses all of the above
};

}  // namespace nuno
