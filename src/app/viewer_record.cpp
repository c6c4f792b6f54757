// What the session of the viewer does for recording.
#include <fmt/format.h>

#include "app/viewer_session.h"
#include "core/error.h"

namespace nuno {

void ViewerSession::toggle_recording()
{
    if (recording_.is_on()) return stop_recording();
    try {
        if (went_bad_) throw Error("record: the numbers are no longer finite; restart before recording");
        recording_.start(recording_plan_, *simulation_, view_);
        log_.action("recording to {}", recording_.directory().string());
    } catch (const std::exception& error) {
        note_error(error);
    }
}

void ViewerSession::record_frame()
{
    if (!recording_.is_on()) return;
    try {
        recording_.add_frame(*simulation_, view_);
    } catch (const std::exception& error) {
        note_error(Error(fmt::format("recording has ended: {}", error.what())));
    }
}

void ViewerSession::stop_recording()
{
    if (!recording_.is_on()) return;
    try {
        recording_.stop();
        recorded_ = fmt::format("wrote {} frames to {}", recording_.frame_count(), recording_.directory().string());
        log_.action("{}", recorded_);
    } catch (const std::exception& error) {
        note_error(error);
    }
}

}  // namespace nuno
