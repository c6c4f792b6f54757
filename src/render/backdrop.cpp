// The kept picture.
#include "render/backdrop.h"

#include <algorithm>
#include <span>

namespace nuno {

bool Backdrop::Key::operator==(const Key& other) const
{
    const auto bytes = std::as_bytes(std::span(&block, 1)), others = std::as_bytes(std::span(&other.block, 1));
    return look == other.look && floor == other.floor && size == other.size && std::ranges::equal(bytes, others);
}

bool Backdrop::repeats(const Key& key)
{
    if (key_ == key) return true;
    key_ = key;
    is_drawn_ = false;
    return false;
}

void Backdrop::begin()
{
    const glm::ivec2 size = key_->size;
    if (!picture_ || picture_->width() != size.x || picture_->height() != size.y) picture_.emplace(size.x, size.y, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, picture_->id());
    is_drawn_ = true;
}

void Backdrop::copy_to(GLuint framebuffer) const
{
    const glm::ivec2 size = key_->size;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_->id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace nuno
