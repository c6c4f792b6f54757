// What one frame cost and counted.
#pragma once

#include <array>
#include <string_view>

#include "collision/self_collision.h"

namespace nuno {

// Milliseconds of each stage of a frame, as cli.md's report names them; the last two are the caller's.
struct StageTimes
{
    double solve = 0, readback = 0, refit = 0, query = 0, respond = 0, upload = 0, render = 0, encode = 0;
};

struct StageInfo
{
    std::string_view name;
    double StageTimes::*ms;
};

inline constexpr std::array<StageInfo, 8> kStages{{{"solve", &StageTimes::solve},
                                                   {"readback", &StageTimes::readback},
                                                   {"refit", &StageTimes::refit},
                                                   {"query", &StageTimes::query},
                                                   {"respond", &StageTimes::respond},
                                                   {"upload", &StageTimes::upload},
                                                   {"render", &StageTimes::render},
                                                   {"encode", &StageTimes::encode}}};

struct FrameStats
{
    int frame = 0;      // 1 after the first
    double time_s = 0;  // simulated, at the end of the frame
    int substeps = 0;
    StageTimes stage_ms;
    CollisionCounts count;            // of all passes of the frame
    std::uint32_t peak_contacts = 0;  // of one pass
};

// Solver and collision together [ms].
inline double simulation_ms(const StageTimes& t)
{
    return t.solve + t.readback + t.refit + t.query + t.respond + t.upload;
}

}  // namespace nuno
