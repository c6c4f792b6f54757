// Where the frames of a headless run go: PNG pictures, a video, and meshes.
#pragma once

#include <filesystem>
#include <memory>

#include "app/mesh_output.h"
#include "render/view_params.h"
#include "sim/simulation.h"

namespace nuno {

struct OutputPlan
{
    std::filesystem::path directory;
    bool images = true;           // PNG files
    std::filesystem::path video;  // empty: none
    MeshPlan mesh;
    int every = 1;  // frames from one that is written to the next

    bool draws() const { return images || !video.empty(); }
};

class FrameOutput
{
  public:
    // Where the plan draws, a context must be current. Error where a texture cannot be read, ffmpeg is missing or a file
    // cannot be made.
    FrameOutput(const OutputPlan& plan, const Simulation& simulation, const ViewParams& view);
    ~FrameOutput();

    // What is seen from the next frame on; the size of the pictures stays.
    void set_view(const ViewParams& view);
    // Writes what the plan says of the present frame; adds render and encode times [ms] to `stage_ms`.
    void write(Simulation& simulation, StageTimes& stage_ms);
    // Waits until every file is whole, with the frames so far, also after write() has thrown. The first Error where
    // some could not be written.
    void finish();

  private:
    void write_image(Simulation& simulation, StageTimes& stage_ms);

    struct Pictures;
    OutputPlan plan_;
    ViewParams view_;
    std::unique_ptr<Pictures> pictures_;
    MeshOutput meshes_;
};

}  // namespace nuno
