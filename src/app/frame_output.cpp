// Where the frames of a headless run go.
#include "app/frame_output.h"

#include <fmt/format.h>

#include "app/cloth_view.h"
#include "app/video_file.h"
#include "core/files.h"
#include "core/stopwatch.h"
#include "render/frame_writer.h"

namespace nuno {

struct FrameOutput::Pictures
{
    explicit Pictures(const Simulation& simulation) : scene_view(make_scene_view(simulation)) {}
    SceneView scene_view;
    FrameWriter writer;
    std::optional<VideoFile> video;
};

FrameOutput::FrameOutput(const OutputPlan& plan, const Simulation& simulation, const ViewParams& view)
    : plan_(plan), view_(view)
{
    if (plan_.draws()) pictures_ = std::make_unique<Pictures>(simulation);
    if (!plan_.video.empty())
        pictures_->video.emplace(plan_.video, view_.width, view_.height,
                                 double(simulation.params().frame_rate) / plan_.every);
    if (!plan_.pc2.empty()) point_cache_.emplace(simulation.model().vertex_count());
}

FrameOutput::~FrameOutput() = default;

void FrameOutput::write(Simulation& simulation, StageTimes& stage_ms)
{
    if (pictures_) write_image(simulation, stage_ms);
    if (plan_.mesh != MeshFormat::none) write_mesh(simulation);
    if (point_cache_) point_cache_->add(simulation.state().positions);
}

void FrameOutput::write_image(Simulation& simulation, StageTimes& stage_ms)
{
    Stopwatch watch;
    GLuint positions = simulation.position_buffer();
    if (positions == 0) positions = pictures_->scene_view.upload_positions(simulation.state().positions);
    stage_ms.upload += watch.lap_ms();
    Picture picture;
    pictures_->scene_view.draw_picture(view_, positions, {simulation.scene().bodies, simulation.time_s()}, picture);
    stage_ms.render += watch.lap_ms();
    if (pictures_->video) pictures_->video->add(picture);
    if (plan_.images)
        pictures_->writer.push(plan_.directory / fmt::format("frame_{:05}.png", simulation.frame()),
                               std::move(picture));
    stage_ms.encode += watch.lap_ms();
}

void FrameOutput::write_mesh(Simulation& simulation)
{
    const MeshView mesh{simulation.state().positions, simulation.model().uvs, simulation.model().faces};
    const bool obj = plan_.mesh == MeshFormat::obj;
    write_whole(plan_.directory / fmt::format("mesh_{:05}.{}", simulation.frame(), obj ? "obj" : "ply"),
                obj ? obj_text(mesh) : ply_text(mesh));
}

void FrameOutput::finish()
{
    if (pictures_) pictures_->writer.finish();
    if (pictures_ && pictures_->video) pictures_->video->finish();
    if (point_cache_) point_cache_->write(plan_.pc2);
}

}  // namespace nuno
