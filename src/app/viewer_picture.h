// The picture in the window: drawn, shown, and read back for a photo.
#pragma once

#include <filesystem>
#include <optional>

#include <glm/vec2.hpp>

#include "app/viewer_session.h"
#include "gl/framebuffer.h"
#include "render/picture.h"

namespace nuno {

class ViewerPicture
{
  public:
    // Draws the session's scene into a window of `pixels`, right of its first `covered` columns, and waits for the
    // device; adds the times to `stage_ms`.
    void draw(ViewerSession& session, glm::ivec2 pixels, int covered, StageTimes& stage_ms);

  private:
    std::optional<Framebuffer> target_;
};

// What the window shows now, before the buffers are swapped.
Picture read_window(glm::ivec2 pixels);

// Writes it as nuno_0001.png or the next number that is free in the working directory, and returns that name.
std::filesystem::path write_photo(const Picture& picture);

}  // namespace nuno
