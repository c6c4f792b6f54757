// Where the frames of a headless run go.
#include "app/frame_output.h"

#include <fmt/format.h>

#include <optional>

#include "app/cloth_view.h"
#include "app/overlays.h"
#include "app/video_file.h"
#include "core/error.h"
#include "core/stopwatch.h"
#include "render/frame_writer.h"

namespace nuno {

struct FrameOutput::Pictures
{
    explicit Pictures(const Simulation& simulation) : scene_view(make_scene_view(simulation)) {}
    SceneView scene_view;
    Overlays overlays;
    FrameWriter writer;
    std::optional<VideoFile> video;
};

FrameOutput::FrameOutput(const OutputPlan& plan, const Simulation& simulation, const ViewParams& view)
    : plan_(plan), view_(view), meshes_(plan.mesh, simulation, view.texture_scale)
{
    if (plan_.draws()) pictures_ = std::make_unique<Pictures>(simulation);
    if (!plan_.video.empty())
        pictures_->video.emplace(plan_.video, view_.width, view_.height,
                                 double(simulation.params().frame_rate) / plan_.every);
}

FrameOutput::~FrameOutput() = default;

void FrameOutput::set_view(const ViewParams& view)
{
    const int width = view_.width, height = view_.height;
    view_ = view;
    view_.width = width;
    view_.height = height;
}

void FrameOutput::write(Simulation& simulation, StageTimes& stage_ms)
{
    if (pictures_) write_image(simulation, stage_ms);
    meshes_.write(simulation);
}

void FrameOutput::write_image(Simulation& simulation, StageTimes& stage_ms)
{
    Stopwatch watch;
    GLuint positions = simulation.position_buffer();
    if (positions == 0) positions = pictures_->scene_view.upload_positions(simulation.state().positions);
    stage_ms.upload += watch.lap_ms();
    Picture picture;
    pictures_->scene_view.set_overlay(pictures_->overlays.gather(view_, simulation));
    pictures_->scene_view.draw_picture(view_, positions, {simulation.bodies(), simulation.time_s()}, picture);
    stage_ms.render += watch.lap_ms();
    if (pictures_->video) pictures_->video->add(picture);
    if (plan_.images)
        pictures_->writer.push(plan_.directory / fmt::format("frame_{:05}.png", simulation.frame()),
                               std::move(picture));
    stage_ms.encode += watch.lap_ms();
}

void FrameOutput::finish()
{
    std::optional<Error> first;
    const auto attempt = [&first](auto finish_one) {
        try {
            finish_one();
        } catch (const Error& error) {
            if (!first) first = error;
        }
    };
    if (pictures_) attempt([&] { pictures_->writer.finish(); });
    if (pictures_ && pictures_->video) attempt([&] { pictures_->video->finish(); });
    attempt([&] { meshes_.finish_cache(); });
    attempt([&] { meshes_.finish_gltf(); });
    if (first) throw *first;
}

}  // namespace nuno
