// How far long work has come.
#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace nuno {
namespace {

constexpr int kBarWidth = 30;
constexpr double kRedrawMs = 100;

}  // namespace

Progress::Progress(std::string what, int total, bool quiet)
    : what_(std::move(what)), total_(total), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
    if (bar_drawn_) fmt::print(stderr, "\n");
}

void Progress::show(int done)
{
    if (quiet_ || total_ <= 0) return;
    const double elapsed_ms = started_.elapsed_ms();
    const double left_s = done > 0 ? elapsed_ms * (total_ - done) / done / 1000 : 0;
    if (!terminal_) {
        const int tenths = 10 * done / total_;
        if (tenths > shown_tenths_) fmt::print(stderr, "{}: {} of {}, {:.0f} s left\n", what_, done, total_, left_s);
        shown_tenths_ = tenths;
        return;
    }
    if (done < total_ && elapsed_ms - shown_ms_ < kRedrawMs) return;
    shown_ms_ = elapsed_ms;
    const int filled = kBarWidth * done / total_;
    fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {}/{}  {:.0f} s left \033[K", what_, "", filled, "", kBarWidth - filled,
               done, total_, left_s);
    std::fflush(stderr);
    bar_drawn_ = true;
}

}  // namespace nuno
