// Where the frames of a headless run go: PNG pictures, mesh files, a point cache, a video.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "model/mesh_writer.h"
#include "render/view_params.h"
#include "sim/simulation.h"

namespace nuno {

enum class MeshFormat
{
    none,
    obj,
    ply
};

struct OutputPlan
{
    std::filesystem::path directory;
    bool images = true;  // PNG files
    MeshFormat mesh = MeshFormat::none;
    std::filesystem::path pc2, video;  // empty: none
    int every = 1;                     // frames from one that is written to the next

    bool draws() const { return images || !video.empty(); }
};

class FrameOutput
{
  public:
    // Where the plan draws, a context must be current. Error where a texture cannot be read or ffmpeg is missing.
    FrameOutput(const OutputPlan& plan, const Simulation& simulation, const ViewParams& view);
    ~FrameOutput();

    // Writes what the plan says of the present frame; adds render and encode times [ms] to `stage_ms`.
    void write(Simulation& simulation, StageTimes& stage_ms);
    // Waits until every file is whole. Error where one could not be written.
    void finish();

  private:
    void write_image(Simulation& simulation, StageTimes& stage_ms);
    void write_mesh(Simulation& simulation);

    struct Pictures;
    OutputPlan plan_;
    ViewParams view_;
    std::unique_ptr<Pictures> pictures_;
    std::optional<PointCache> point_cache_;
};

}  // namespace nuno
