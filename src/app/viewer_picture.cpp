// Drawing into the window, and photos of it.
#include "app/viewer_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/viewer_ui.h"
#include "core/error.h"
#include "core/stopwatch.h"
#include "render/png_file.h"

namespace nuno {

void ViewerPicture::draw(ViewerSession& session, glm::ivec2 pixels, int covered, StageTimes& stage_ms)
{
    const glm::ivec2 size(std::max(pixels.x - covered, 1), pixels.y);
    Stopwatch watch;
    const double upload_before_ms = stage_ms.upload;
    if (!target_ || target_->width() != size.x || target_->height() != size.y) target_.emplace(size.x, size.y, 1);
    session.draw({target_->id(), size.x, size.y}, stage_ms);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_->id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glViewport(0, 0, pixels.x, pixels.y);
    glClearColor(kPanelColour.r, kPanelColour.g, kPanelColour.b, kPanelColour.a);
    glClear(GL_COLOR_BUFFER_BIT);
    glBlitFramebuffer(0, 0, size.x, size.y, pixels.x - size.x, 0, pixels.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    // The stage times are those of finished work.
    glFinish();
    stage_ms.render += watch.elapsed_ms() - (stage_ms.upload - upload_before_ms);
}

Picture read_window(glm::ivec2 pixels)
{
    Picture picture{pixels.x, pixels.y, {}};
    const auto row = 4 * static_cast<std::ptrdiff_t>(pixels.x);
    picture.rgba.resize(static_cast<std::size_t>(row * pixels.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, pixels.x, pixels.y, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    for (std::ptrdiff_t low = 0, high = pixels.y - 1; low < high; ++low, --high)
        std::swap_ranges(picture.rgba.begin() + low * row, picture.rgba.begin() + (low + 1) * row,
                         picture.rgba.begin() + high * row);
    return picture;
}

std::filesystem::path write_photo(const Picture& picture)
{
    for (int number = 1; number < 10000; ++number) {
        std::filesystem::path path = fmt::format("nuno_{:04}.png", number);
        std::error_code status;
        if (std::filesystem::exists(path, status)) continue;
        write_png(path, picture);
        return path;
    }
    throw Error("photo: nuno_0001.png to nuno_9999.png are all there already; move some away");
}

}  // namespace nuno
