// What the commands have in common that measure many points (docs/trade.md).
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/progress.h"
#include "study/point_store.h"

namespace nuno {

struct SweepFlags
{
    std::string out, shard = "1/1";
};

// --out, with the default that is in `flags`, and --shard.
void add_sweep_flags(CLI::App& command, SweepFlags& flags);

// Tells on stderr what is there already, and what half a line is lost.
void remark_on_points(const PointStore& store, std::string_view command, const std::filesystem::path& directory);

// Shows how far long work has come, from its first step on, until it is interrupted: then it is false.
class InterruptibleProgress
{
  public:
    InterruptibleProgress(std::string what, bool quiet);
    bool operator()(std::size_t done, std::size_t total);

  private:
    std::string what_;
    bool quiet_;
    std::shared_ptr<Progress> shown_;  // of all copies
};

}  // namespace nuno
