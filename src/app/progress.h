// How far long work has come: a bar with the time left on a terminal, plain lines elsewhere.
#pragma once

#include <string>

#include "core/stopwatch.h"

namespace nuno {

class Progress
{
  public:
    // Writes to stderr. `quiet`: nothing at all.
    Progress(std::string what, int total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(int done);

  private:
    std::string what_;
    int total_;
    bool quiet_, terminal_;
    Stopwatch started_;
    double shown_ms_ = -1e9;
    int shown_tenths_ = 0;
    bool bar_drawn_ = false;
};

}  // namespace nuno
