// Poses of cloth.
#include "tests/collision/poses.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Uniform in -1 .. 1, the same on every platform.
class Dice
{
  public:
    explicit Dice(std::uint32_t seed) : bits_(seed) {}
    float operator()() { return static_cast<float>(bits_()) * 0x1p-31f - 1.0f; }
    std::uint32_t below(std::uint32_t count)
    {
        return static_cast<std::uint32_t>(std::uint64_t{bits_()} * count >> 32);
    }
    glm::vec3 vector()
    {
        const float x = (*this)(), y = (*this)(), z = (*this)();
        return {x, y, z};
    }

  private:
    std::mt19937 bits_;
};

// The flat sheet with every vertex (u, v, 0) moved to place(u, v).
Pose bent_sheet(int n, const std::function<glm::vec3(float u, float v)>& place)
{
    const TriangleMesh mesh = grid_mesh(n, n, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const auto vertex_count = static_cast<std::uint32_t>(mesh.positions.size());
    const auto face_count = static_cast<std::uint32_t>(mesh.faces.size());
    Pose pose{mesh.positions, {}, mesh.faces, {{"sheet", 0, vertex_count, 0, face_count, n, n, {}}}};
    for (const glm::vec3& p : pose.rest) pose.positions.emplace_back(place(p.x, p.y), 1.0f);
    return pose;
}

}  // namespace

Pose flat_sheet(int n)
{
    return bent_sheet(n, [](float u, float v) { return glm::vec3(u, v, 0); });
}

Pose crumpled_sheet(int n, float amplitude, std::uint32_t seed)
{
    Dice dice(seed);
    struct Wave
    {
        glm::vec3 direction, along;
    };
    std::vector<Wave> waves;
    for (int i = 0; i < 12; ++i)
        waves.push_back({dice.vector() / (1.0f + 0.3f * i), (3.0f + 2.0f * i) * dice.vector()});
    return bent_sheet(n, [&](float u, float v) {
        glm::vec3 p(0.5f * u, 0.5f * v, 0);
        for (const Wave& wave : waves)
            p += amplitude * wave.direction * std::sin(wave.along.x * u + wave.along.y * v + kPi * wave.along.z);
        return p;
    });
}

Pose folded_sheet(int n, float gap)
{
    const float radius = 0.5f * gap, flat = 0.5f * (1.0f - kPi * radius);
    return bent_sheet(n, [=](float u, float v) {
        if (u < flat) return glm::vec3(u, v, 0);
        if (u > 1.0f - flat) return glm::vec3(1.0f - u, v, gap);
        const float angle = (u - flat) / radius;
        return glm::vec3(flat + radius * std::sin(angle), v, radius * (1.0f - std::cos(angle)));
    });
}

// The spiral r = r0 + gap a / (2 pi), whose length is r0 a + gap a^2 / (4 pi).
Pose rolled_sheet(int n, float gap)
{
    const float r0 = 3.0f * gap, growth = gap / (2.0f * kPi);
    return bent_sheet(n, [=](float u, float v) {
        const float angle = (std::sqrt(r0 * r0 + 2.0f * growth * u) - r0) / growth, r = r0 + growth * angle;
        return glm::vec3(r * std::cos(angle), v, r * std::sin(angle));
    });
}

Pose stacked_sheets(int n, int count, std::uint32_t seed)
{
    Dice dice(seed);
    Pose all;
    for (int sheet = 0; sheet < count; ++sheet) {
        const glm::vec3 tilt = 0.02f * dice.vector(), shift = 0.01f * dice.vector() + glm::vec3(0, 0, 0.01f * sheet);
        Pose one = bent_sheet(n, [&](float u, float v) {
            return glm::vec3(u + tilt.z * v, v - tilt.z * u, tilt.x * u + tilt.y * v) + shift;
        });
        for (glm::vec3& p : one.rest) p.z += static_cast<float>(sheet);
        add_sheets(all, one);
    }
    return all;
}

Pose face_soup(int face_count, std::uint32_t seed)
{
    Dice dice(seed);
    Pose soup;
    const auto add_vertex = [&](glm::vec3 at) {
        soup.rest.push_back(at);
        soup.positions.emplace_back(at, 1.0f);
        return static_cast<std::uint32_t>(soup.rest.size() - 1);
    };
    for (int f = 0; f < face_count; ++f) {
        const glm::vec3 centre = dice.vector();
        const float size = std::exp2(-4.0f + 3.0f * dice());
        const std::uint32_t a = add_vertex(centre + size * dice.vector());
        // Every second face shares a corner with an earlier one; every eighth has no area, or nearly none.
        const std::uint32_t b = f % 2 == 0 && a > 0 ? dice.below(a) : add_vertex(centre + size * dice.vector());
        glm::vec3 third = centre + size * dice.vector();
        if (f % 16 == 7) third = soup.rest[b];
        if (f % 16 == 15) third = 0.5f * (soup.rest[a] + soup.rest[b]);
        soup.faces.emplace_back(a, b, add_vertex(third));
    }
    return soup;
}

Pose flat_c(int n, float rise)
{
    return bent_sheet(n, [=](float u, float v) {
        const float angle = 2.1f * kPi * u, r = 0.5f + 0.5f * v;
        return glm::vec3(r * std::cos(angle), r * std::sin(angle), rise * u);
    });
}

Pose spiral_ramp(int n, float rise)
{
    return bent_sheet(n, [=](float u, float v) {
        const float angle = 4.0f * kPi * u, r = 0.2f + 0.3f * v;
        return glm::vec3(r * std::cos(angle), r * std::sin(angle), 2.0f * rise * u);
    });
}

void add_sheets(Pose& pose, const Pose& more)
{
    const auto first_vertex = static_cast<std::uint32_t>(pose.rest.size());
    const auto first_face = static_cast<std::uint32_t>(pose.faces.size());
    pose.rest.insert(pose.rest.end(), more.rest.begin(), more.rest.end());
    pose.positions.insert(pose.positions.end(), more.positions.begin(), more.positions.end());
    for (const glm::uvec3& face : more.faces) pose.faces.push_back(face + first_vertex);
    for (Sheet sheet : more.sheets) {
        sheet.first_vertex += first_vertex;
        sheet.first_face += first_face;
        pose.sheets.push_back(sheet);
    }
}

std::vector<glm::vec4> shaken(std::span<const glm::vec4> positions, float distance, std::uint32_t seed)
{
    Dice dice(seed);
    std::vector<glm::vec4> moved(positions.begin(), positions.end());
    for (glm::vec4& p : moved) p += glm::vec4(distance * dice.vector(), 0);
    return moved;
}

}  // namespace nuno
