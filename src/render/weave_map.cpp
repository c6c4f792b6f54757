// Threads over and under each other, in heights and then in slopes.
#include "render/weave_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaders/shared/render_bindings.h"

namespace nuno {
namespace {

constexpr int kThreadTexels = kWeaveSide / WEAVE_THREADS;

// Between -1 and 1, without a pattern.
float noise_of(std::uint32_t a, std::uint32_t b)
{
    std::uint32_t h = a * 0x9e3779b9u + b * 0x85ebca6bu + 0x27d4eb2fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return static_cast<float>((h ^ (h >> 15)) & 0xffff) / 32767.5f - 1.0f;
}

// How a spun thread varies along itself (`at` 0 .. 1 and round again): some knots, smoothly between them.
float slub(std::uint32_t thread, float at)
{
    constexpr std::uint32_t knots = 12;
    const float x = at * float(knots);
    const auto first = static_cast<std::uint32_t>(x) % knots;
    const float t = x - std::floor(x), smooth = t * t * (3 - 2 * t);
    return std::lerp(noise_of(thread, first), noise_of(thread, (first + 1) % knots), smooth);
}

struct Point
{
    float height, brightness;  // height in distances of threads
};

// Of the thread on top at a point counted in threads, 0 .. WEAVE_THREADS each way.
Point surface_at(float x, float y)
{
    const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
    const bool warp_on_top = (column + row) % 2 == 0;
    const std::uint32_t thread = warp_on_top ? column : WEAVE_THREADS + row;
    const float along_texture = (warp_on_top ? y : x) / float(WEAVE_THREADS);
    const float in_column = 2 * (x - float(column)) - 1, in_row = 2 * (y - float(row)) - 1;
    const float across = warp_on_top ? in_column : in_row, along = warp_on_top ? in_row : in_column;
    const float thickness = 1 + 0.2f * noise_of(thread, 99) + 0.25f * slub(thread, along_texture);
    const float round = std::sqrt(std::max(1 - 0.85f * across * across, 0.0f));
    const float over = 0.55f + 0.45f * std::cos(0.5f * std::numbers::pi_v<float> * along);
    const float dye = 1 + 0.06f * noise_of(thread, 7) + 0.05f * slub(thread + 1000, along_texture);
    return {0.42f * thickness * round * over, dye * (0.5f + 0.5f * round * over)};
}

std::uint8_t byte_of(float part) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0f, 1.0f))); }

}  // namespace

std::vector<std::uint8_t> weave_texels()
{
    std::vector<Point> points;
    points.reserve(std::size_t(kWeaveSide) * kWeaveSide);
    for (int y = 0; y < kWeaveSide; ++y)
        for (int x = 0; x < kWeaveSide; ++x)
            points.push_back(surface_at((float(x) + 0.5f) / kThreadTexels, (float(y) + 0.5f) / kThreadTexels));
    const auto height = [&](int x, int y) {
        const int column = (x + kWeaveSide) % kWeaveSide, row = (y + kWeaveSide) % kWeaveSide;
        return points[std::size_t(row) * kWeaveSide + std::size_t(column)].height;
    };
    double brightness_sum = 0;
    for (const Point& point : points) brightness_sum += double(point.brightness);
    const float full = WEAVE_BRIGHTEST * static_cast<float>(brightness_sum / double(points.size()));
    std::vector<std::uint8_t> texels;
    texels.reserve(4 * points.size());
    for (int y = 0; y < kWeaveSide; ++y)
        for (int x = 0; x < kWeaveSide; ++x) {
            const float slope_u = 0.5f * kThreadTexels * (height(x + 1, y) - height(x - 1, y));
            const float slope_v = 0.5f * kThreadTexels * (height(x, y + 1) - height(x, y - 1));
            const float brightness = points[std::size_t(y) * kWeaveSide + std::size_t(x)].brightness;
            texels.insert(texels.end(), {byte_of(128 / 255.0f + slope_u * 127 / 510),
                                         byte_of(128 / 255.0f + slope_v * 127 / 510), byte_of(brightness / full), 255});
        }
    return texels;
}

}  // namespace nuno
