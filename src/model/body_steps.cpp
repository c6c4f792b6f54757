// Poses and displacements of bodies over substeps.
#include "model/body_steps.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nuno {
namespace {

BodyStep step_of(const PlacedBody& body, const Pose& start, const Pose& end, double h, float bound, float grid_start)
{
    BodyStep step;
    step.position = glm::vec4(glm::vec3(end.position), body.radius > 0 ? body.radius : bound);
    step.origin = glm::vec4(glm::vec3(start.position), grid_start);
    // A point x of the body at the start ends at p1 + R1 R0^T (x - p0).
    const glm::dmat3 turn = (end.rotation * glm::transpose(start.rotation) - glm::dmat3(1)) / h;
    const glm::dvec3 speed = (end.position - start.position) / h;
    const bool moved = start.position != end.position || start.rotation != end.rotation;
    for (int k = 0; k < 3; ++k) {
        step.axis[k] = glm::vec4(glm::vec3(end.rotation[k]), body.half_size[k]);
        step.velocity[k] = moved ? glm::vec4(turn[0][k], turn[1][k], turn[2][k], speed[k]) : glm::vec4(0);
    }
    return step;
}

// `is_plane`: the body has no end.
float bound_of(const PlacedBody& body, bool is_plane)
{
    if (is_plane) return std::numeric_limits<float>::infinity();
    glm::vec3 reach = body.half_size;
    if (body.grid) {
        const glm::vec3 low = body.grid->origin, high = low + body.grid->cell * glm::vec3(body.grid->cells);
        reach = glm::max(glm::abs(low), glm::abs(high));
    }
    return glm::length(reach) + body.radius;
}

}  // namespace

BodySteps::BodySteps(const Bodies& bodies, const ClothModel& model)
    : handles_(bodies.handles), model_(model), placed_(placed_bodies(bodies))
{
    for (std::size_t b = 0; b < placed_.size(); ++b) bounds_.push_back(bound_of(placed_[b], b < bodies.planes.size()));
    std::size_t start = 0;
    for (const PlacedBody& body : placed_) {
        grid_starts_.push_back(static_cast<float>(start));
        if (body.grid) start += 1 + (body.grid->values.size() + kGridHeader - 1) / kGridHeader;
    }
}

std::vector<float> BodySteps::grid_numbers() const
{
    std::vector<float> numbers;
    for (const PlacedBody& body : placed_) {
        if (!body.grid) continue;
        const DistanceGrid& grid = *body.grid;
        const glm::vec3 cells(grid.cells);
        numbers.insert(numbers.end(), {grid.origin.x, grid.origin.y, grid.origin.z, grid.cell, 1 / grid.cell, cells.x,
                                       cells.y, cells.z});
        numbers.insert(numbers.end(), grid.values.begin(), grid.values.end());
        while (numbers.size() % kGridHeader != 0) numbers.push_back(0);
    }
    return numbers;
}

void BodySteps::plan(double start_time_s, double h, int substep_count)
{
    const bool moved = moves_;
    moves_ = std::any_of(placed_.begin(), placed_.end(), [](const PlacedBody& body) { return body.motion->moves(); });
    const int filled = moves_ ? substep_count : 1;
    if (moves_ || moved || body_steps_.empty()) {
        body_steps_.clear();
        for (int k = 0; k < filled; ++k)
            for (std::size_t b = 0; b < placed_.size(); ++b) {
                const PlacedBody& body = placed_[b];
                const Pose start = pose_at(*body.motion, body.rest, start_time_s + k * h);
                const Pose end = pose_at(*body.motion, body.rest, start_time_s + (k + 1) * h);
                body_steps_.push_back(step_of(body, start, end, h, bounds_[b], grid_starts_[b]));
            }
    }
    if (!pins().empty()) plan_pins(start_time_s, h, substep_count);
}

void BodySteps::plan_pins(double start_time_s, double h, int substep_count)
{
    pin_steps_.clear();
    std::vector<Pose> start(handles_.size()), end(handles_.size());
    const auto poses_at = [&](double time_s, std::vector<Pose>& poses) {
        for (std::size_t i = 0; i < handles_.size(); ++i) poses[i] = pose_at(handles_[i].motion, Pose{}, time_s);
    };
    poses_at(start_time_s, end);
    for (int k = 0; k < substep_count; ++k) {
        std::swap(start, end);
        poses_at(start_time_s + (k + 1) * h, end);
        for (const HandlePin& pin : pins()) {
            const glm::dvec3 x(model_.start_positions[pin.vertex]);
            const auto at = [&](const Pose& pose) { return pose.rotation * x + pose.position; };
            const glm::dvec3 x0 = at(start[pin.handle]), x1 = at(end[pin.handle]);
            pin_steps_.push_back({glm::vec4(glm::vec3(x1), 0), glm::vec4(glm::vec3((x1 - x0) / h), 0)});
        }
    }
}

}  // namespace nuno
