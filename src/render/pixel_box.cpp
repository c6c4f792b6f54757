// Corners of boxes as pixels.
#include "render/pixel_box.h"

#include <cmath>

#include <glm/common.hpp>

namespace nuno {

Bounds bounds_of(std::span<const glm::vec4> positions)
{
    Bounds bounds{glm::vec3(positions.front()), glm::vec3(positions.front())};
    glm::vec3 sum(0);
    for (const glm::vec4& position : positions) {
        bounds.low = glm::min(bounds.low, glm::vec3(position));
        bounds.high = glm::max(bounds.high, glm::vec3(position));
        sum += glm::vec3(position);
    }
    // Comparisons pass over what is no number; a sum does not.
    if (!std::isfinite(sum.x + sum.y + sum.z)) bounds.high = sum;
    return bounds;
}

glm::vec3 corner_of(const Bounds& box, int number)
{
    return {number & 1 ? box.high.x : box.low.x, number & 2 ? box.high.y : box.low.y,
            number & 4 ? box.high.z : box.low.z};
}

PixelBox pixels_of(std::span<const Bounds> boxes, const glm::mat4& view_projection, glm::ivec2 size)
{
    const PixelBox all{{0, 0}, size};
    glm::vec2 low(1), high(-1);
    for (const Bounds& box : boxes)
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec4 clip = view_projection * glm::vec4(corner_of(box, corner), 1);
            if (!(clip.w > 1e-6f) || !std::isfinite(clip.x + clip.y)) return all;
            const glm::vec2 at = glm::vec2(clip) / clip.w;
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    low = glm::clamp(low, -1.0f, 1.0f);
    high = glm::clamp(high, -1.0f, 1.0f);
    if (!(low.x < high.x && low.y < high.y)) return {};
    // A pixel more on each side, for what is rounded otherwise on the device.
    const glm::vec2 half = 0.5f * glm::vec2(size);
    return {glm::max(glm::ivec2(glm::floor((low + 1.0f) * half)) - 1, glm::ivec2(0)),
            glm::min(glm::ivec2(glm::ceil((high + 1.0f) * half)) + 1, size)};
}

}  // namespace nuno
