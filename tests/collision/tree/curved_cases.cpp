// Strips of rings and grids without some of their faces.
#include "collision/tree/curved_cases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace nuno {
namespace {

constexpr float kPi = 3.14159265f;

// Rings of vertices one above the other, `around` each, closed.
Pose rings(int around, int count, const std::function<glm::vec3(float angle, float height)>& place)
{
    Pose pose;
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < around; ++i)
            pose.rest.push_back(
                place(2 * kPi * (static_cast<float>(i) + 0.5f * static_cast<float>(j % 2)) / static_cast<float>(around),
                      static_cast<float>(j) / static_cast<float>(count - 1)));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * around + i % around); };
    for (int j = 0; j + 1 < count; ++j)
        for (int i = 0; i < around; ++i) {
            const int up = j % 2;  // every other ring is turned by half a step
            pose.faces.emplace_back(at(i, j), at(i + 1, j), at(i + up, j + 1));
            pose.faces.emplace_back(at(i + 1 - up, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return pose;
}

TreeCase mesh_of(std::string name, Pose pose)
{
    pose.positions.clear();
    for (const glm::vec3& p : pose.rest) pose.positions.emplace_back(p, 1);
    return as_mesh(std::move(name), pose);
}

// Without the faces whose middle is taken, and without vertices of no face.
Pose without(const Pose& pose, const std::function<bool(glm::vec3 middle)>& is_taken)
{
    Pose left;
    std::vector<std::uint32_t> number(pose.rest.size(), std::numeric_limits<std::uint32_t>::max());
    for (const glm::uvec3& face : pose.faces) {
        if (is_taken((pose.rest[face.x] + pose.rest[face.y] + pose.rest[face.z]) / 3.0f)) continue;
        glm::uvec3 corners;
        for (int k = 0; k < 3; ++k) {
            std::uint32_t& of_corner = number[face[k]];
            if (of_corner == std::numeric_limits<std::uint32_t>::max()) {
                of_corner = static_cast<std::uint32_t>(left.rest.size());
                left.rest.push_back(pose.rest[face[k]]);
            }
            corners[k] = of_corner;
        }
        left.faces.push_back(corners);
    }
    return left;
}

}  // namespace

TreeCase sleeve(int n)
{
    constexpr float radius = 0.25f;
    return mesh_of("sleeve", rings(n * 8 / 5, n / 2, [](float angle, float height) {
                       return glm::vec3(0.5f * height - 0.25f, radius * std::cos(angle), radius * std::sin(angle));
                   }));
}

TreeCase bag(int n)
{
    return mesh_of("bag", rings(2 * n, n, [](float angle, float height) {
                       const float down = 0.25f * kPi + 0.68f * kPi * height, r = 0.4f * std::sin(down);
                       return glm::vec3(r * std::cos(angle), r * std::sin(angle), 0.4f * std::cos(down));
                   }));
}

TreeCase saddle(int n)
{
    Pose pose = flat_sheet(n);
    for (glm::vec3& p : pose.rest) {
        const glm::vec3 at = p - 0.5f;
        p = {at.x, at.y, 1.6f * (at.x * at.x - at.y * at.y)};
    }
    return cut_at_random(mesh_of("saddle", pose), 5);
}

TreeCase l_shape(int n)
{
    return mesh_of("L", without(flat_sheet(n), [](glm::vec3 p) { return p.x > 0.5f && p.y > 0.4f; }));
}

TreeCase plate_with_hole(int n)
{
    return mesh_of("plate with a hole",
                   without(flat_sheet(n), [](glm::vec3 p) { return std::hypot(p.x - 0.4f, p.y - 0.5f) < 0.15f; }));
}

TreeCase notched(int n, float depth)
{
    Pose pose = flat_sheet(n);
    for (glm::vec3& p : pose.rest) p.y *= 1 - depth * std::max(0.0f, 1 - 4 * std::abs(p.x - 0.5f));
    return mesh_of("notched by " + std::to_string(depth), pose);
}

std::vector<TreeCase> curved_cases(int n)
{
    return {sleeve(n), bag(n * 2 / 3), saddle(n), l_shape(n), plate_with_hole(n)};
}

glm::vec3 waved(glm::vec3 p, float amount)
{
    const float k = 2 * kPi / 0.4f;
    return p + amount * glm::vec3(std::sin(k * p.y + p.x), std::sin(k * p.z + 2 * p.x),
                                  std::sin(0.8f * k * p.x + 2 * p.y) + std::cos(0.6f * k * p.y));
}

glm::vec3 crumpled(glm::vec3 p, float amount)
{
    const glm::vec3 pressed = p * glm::vec3(1 - 3 * amount, 1 - 2 * amount, 1);
    return pressed + amount * glm::vec3(std::sin(23 * p.y + 9 * p.z) + 0.5f * std::sin(61 * p.x),
                                        std::sin(29 * p.x - 12 * p.z) + 0.5f * std::cos(53 * p.y + 40 * p.x),
                                        std::sin(31 * p.x + 17 * p.y) + 0.6f * std::sin(70 * p.y - 45 * p.x));
}

glm::vec3 folded(glm::vec3 p, float amount)
{
    const float r = 0.5f * amount, s = p.x - 0.1f, angle = std::clamp(s / r, 0.0f, kPi);
    const float beyond = s - r * angle, out = r - p.z;
    return {0.1f + out * std::sin(angle) + beyond * std::cos(angle), p.y,
            r - out * std::cos(angle) + beyond * std::sin(angle)};
}

glm::vec3 rolled(glm::vec3 p, float amount)
{
    const float growth = amount / (2 * kPi), s = p.x + 0.6f;
    const float turn = (std::sqrt(0.05f * 0.05f + 2 * growth * s) - 0.05f) / growth;
    const float r = 0.05f + growth * turn + 0.1f * p.z;
    return {r * std::cos(turn), p.y, r * std::sin(turn)};
}

std::vector<glm::vec4> bent(const TreeCase& cloth, Bend bend, float amount)
{
    std::vector<glm::vec4> positions;
    for (const glm::vec3& p : cloth.rest) positions.emplace_back(bend(p, amount), 1);
    return positions;
}

}  // namespace nuno
