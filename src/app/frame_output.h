// Where the frames of a headless run go: PNG pictures, mesh files, a point cache.
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
    bool images = true;
    MeshFormat mesh = MeshFormat::none;
    std::filesystem::path pc2;  // empty: none
    int every = 1;              // frames from one that is written to the next
};

class FrameOutput
{
  public:
    // With images a context must be current. Error where the directory cannot be written or a texture cannot be read.
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
