// Gathers the frames of a run: the metrics of its end check, and the JSON report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/params.h"
#include "model/diagnostics.h"
#include "scene/end_check.h"
#include "sim/frame_stats.h"
#include "sim/pose_check.h"
#include "sim/simulation.h"

namespace nuno {

struct FrameRecord
{
    FrameStats stats;
    Diagnostics diagnostics;
};

class RunRecorder
{
  public:
    void add(const FrameStats& stats, const Diagnostics& diagnostics);
    const std::vector<FrameRecord>& frames() const { return frames_; }
    RunMetrics metrics() const;

    CheckCounts check;  // of --check

  private:
    std::vector<FrameRecord> frames_;
};

// What the report says of machine and renderer; empty GL texts where no context was made.
struct MachineInfo
{
    std::string cpu;
    int threads = 1;
    std::string gl_vendor, gl_renderer, gl_version;
    bool software_gl = false;
};
std::string cpu_name();
nlohmann::ordered_json machine_json(const MachineInfo& machine);

// The report of docs/report.md. `view_params`: (name, value) of the view's table as JSON, or null.
nlohmann::ordered_json make_report(const RunRecorder& recorder, Simulation& simulation, const MachineInfo& machine,
                                   const nlohmann::ordered_json& view_params);

// The frames of the report as comma-separated values: a line of names, `stage_ms.solve` for a field in a field, and a
// line for each frame.
std::string frames_csv(const RunRecorder& recorder);

// {"name": value, ...} of a block: numbers, true or false, and the names of choices.
nlohmann::ordered_json params_json(ParamTable table, const void* block);

// "state-hash" digits: 16 hexadecimal ones.
std::string hash_text(const ClothState& state);

}  // namespace nuno
