// What is shown written to files, a picture for each simulated frame.
#pragma once

#include <filesystem>
#include <memory>

#include "app/frame_output.h"

namespace nuno {

enum class RecordingKind
{
    pictures,  // PNG files
    video      // by ffmpeg
};

struct RecordingPlan
{
    RecordingKind kind = RecordingKind::pictures;
    bool point_cache = false;  // PC2 and its OBJ beside
};

class ViewerRecording
{
  public:
    ViewerRecording() = default;
    // Ends without a word what goes on; files are whole where that works.
    ~ViewerRecording();
    ViewerRecording(const ViewerRecording&) = delete;
    ViewerRecording& operator=(const ViewerRecording&) = delete;

    bool is_on() const { return output_ != nullptr; }
    // Of what goes on or went on last: SCENE_frames_0001 or the next free name in the working directory.
    const std::filesystem::path& directory() const { return directory_; }
    int frame_count() const { return frame_count_; }

    // Makes the directory and writes the present frame. view.width x view.height pixels. An OpenGL context must be
    // current. Error, and nothing left behind, where ffmpeg is missing or nothing can be written.
    void start(const RecordingPlan& plan, Simulation& simulation, const ViewParams& view);
    // Writes the present frame as it is seen now. Error where that fails: then it has ended, and what could be finished
    // is whole.
    void add_frame(Simulation& simulation, const ViewParams& view);
    // Finishes the files. Error where some could not be.
    void stop();

  private:
    std::filesystem::path directory_;
    std::unique_ptr<FrameOutput> output_;
    int frame_count_ = 0;
};

}  // namespace nuno
