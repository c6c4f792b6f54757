// Recording with the writers of headless runs.
#include "app/viewer_recording.h"

#include <fmt/format.h>

#include "core/error.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

fs::path make_directory(const std::string& scene)
{
    for (int number = 1; number < 10000; ++number) {
        fs::path path = fmt::format("{}_frames_{:04}", scene, number);
        std::error_code status;
        if (fs::create_directory(path, status)) return path;
        if (status)
            throw Error(fmt::format("{}: cannot be made a directory ({}); start nuno where it may write", path.string(),
                                    status.message()));
    }
    throw Error(fmt::format("record: {0}_frames_0001 to {0}_frames_9999 are all there already; move some away", scene));
}

OutputPlan output_plan(const RecordingPlan& plan, const fs::path& directory)
{
    OutputPlan output;
    output.directory = directory;
    output.images = plan.kind == RecordingKind::pictures;
    if (plan.kind == RecordingKind::video) output.video = directory / "video.mp4";
    if (plan.point_cache) output.mesh.pc2 = directory / "cloth.pc2";
    return output;
}

}  // namespace

ViewerRecording::~ViewerRecording()
{
    try {
        stop();
    } catch (const std::exception&) {
        // Who wants to know has called stop().
    }
}

void ViewerRecording::start(const RecordingPlan& plan, Simulation& simulation, const ViewParams& view)
{
    directory_ = make_directory(simulation.scene().name);
    frame_count_ = 0;
    try {
        output_ = std::make_unique<FrameOutput>(output_plan(plan, directory_), simulation, view);
        add_frame(simulation, view);
    } catch (...) {
        std::error_code ignored;
        fs::remove(directory_, ignored);  // where nothing is in it
        throw;
    }
}

void ViewerRecording::add_frame(Simulation& simulation, const ViewParams& view)
{
    try {
        StageTimes unused;
        output_->set_view(view);
        output_->write(simulation, unused);
        ++frame_count_;
    } catch (...) {
        try {
            stop();
        } catch (const std::exception&) {
            // The first thing that went wrong is told.
        }
        throw;
    }
}

void ViewerRecording::stop()
{
    if (const auto output = std::exchange(output_, nullptr)) output->finish();
}

}  // namespace nuno
