// Flags, remarks and progress of sweeps.
#include "app/sweep_flags.h"

#include <fmt/format.h>

#include <utility>

#include "app/interrupt.h"

namespace nuno {

void add_sweep_flags(CLI::App& command, SweepFlags& flags)
{
    command.add_option("--out", flags.out, "Directory for data, pictures and report.html; run again to go on")
        ->capture_default_str();
    command.add_option("--shard", flags.shard, "K/N: every Nth point, from the Kth on")->capture_default_str();
}

void remark_on_points(const PointStore& store, std::string_view command, const std::filesystem::path& directory)
{
    if (store.dropped_half_a_line())
        fmt::print(stderr, "{}: half a point at the end of {} is measured anew\n", command,
                   (directory / "points.jsonl").string());
    if (store.resumed() > 0) fmt::print(stderr, "{}: {} points are there already\n", command, store.resumed());
}

InterruptibleProgress::InterruptibleProgress(std::string what, bool quiet) : what_(std::move(what)), quiet_(quiet)
{
    watch_interrupts();
}

bool InterruptibleProgress::operator()(std::size_t done, std::size_t total)
{
    if (!shown_) shown_ = std::make_shared<Progress>(what_, static_cast<int>(total), quiet_);
    shown_->show(static_cast<int>(done));
    return !interrupted();
}

}  // namespace nuno
