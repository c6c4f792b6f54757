// One worker and a short queue: a disk that is slower than the renderer slows it down instead of filling the memory.
#include "render/frame_writer.h"

#include "core/stopwatch.h"
#include "render/png_file.h"

namespace nuno {
namespace {

constexpr std::size_t kQueued = 2;

}  // namespace

FrameWriter::FrameWriter() : worker_([this] { run(); }) {}

FrameWriter::~FrameWriter()
{
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    worker_.join();
}

void FrameWriter::push(std::filesystem::path path, Picture picture)
{
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return error_ || queue_.size() < kQueued; });
        rethrow();
        queue_.push_back({std::move(path), std::move(picture)});
    }
    changed_.notify_all();
}

void FrameWriter::finish()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return error_ || (queue_.empty() && !busy_); });
    rethrow();
}

std::vector<double> FrameWriter::encode_ms() const
{
    const std::lock_guard lock(mutex_);
    return encode_ms_;
}

void FrameWriter::rethrow() const
{
    if (error_) std::rethrow_exception(error_);
}

void FrameWriter::run()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return closing_ || !queue_.empty(); });
        if (queue_.empty()) return;
        const Frame frame = std::move(queue_.front());
        queue_.pop_front();
        busy_ = true;
        lock.unlock();
        changed_.notify_all();
        const Stopwatch stopwatch;
        std::exception_ptr error;
        try {
            write_png(frame.path, frame.picture);
        } catch (...) {
            error = std::current_exception();
        }
        const double ms = stopwatch.elapsed_ms();
        lock.lock();
        busy_ = false;
        encode_ms_.push_back(ms);
        if (error) {
            error_ = error;
            queue_.clear();
        }
        changed_.notify_all();
    }
}

}  // namespace nuno
