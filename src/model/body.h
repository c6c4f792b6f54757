// Rigid bodies that cloth rests on, and handles that carry pinned vertices. All lengths in m.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "model/body_motion.h"
#include "model/distance_grid.h"
#include "model/triangle_mesh.h"

namespace nuno {

// Half-space n . x >= offset, n of unit length.
struct Plane
{
    glm::vec3 normal{0, 1, 0};
    float offset = 0;
    BodyMotion motion{};
};

struct Sphere
{
    glm::vec3 centre{0, 0, 0};
    float radius = 1;
    BodyMotion motion{};
};

// All points within `radius` of the line from `from` to `to`; a ball where the two are one point.
struct Capsule
{
    glm::vec3 from{0, 0, 0}, to{0, 1, 0};
    float radius = 0.1f;
    BodyMotion motion{};
};

struct Box
{
    glm::vec3 centre{0, 0, 0}, size{1, 1, 1};  // size: whole sides
    glm::quat rotation{1, 0, 0, 0};
    BodyMotion motion{};
};

// A closed mesh; vertices are R x + position.
struct MeshBody
{
    TriangleMesh mesh;
    std::shared_ptr<const DistanceGrid> grid;  // of `mesh`, in its own coordinates
    glm::vec3 position{0, 0, 0};
    glm::quat rotation{1, 0, 0, 0};
    BodyMotion motion{};
};

// What pinned vertices can be attached to: a point in motion, without a shape.
struct Handle
{
    std::string name;
    BodyMotion motion{};
};

struct Bodies
{
    std::vector<Plane> planes;
    std::vector<Sphere> spheres;
    std::vector<Capsule> capsules;
    std::vector<Box> boxes;
    std::vector<MeshBody> meshes;
    std::vector<Handle> handles;

    std::size_t shape_count() const
    {
        return planes.size() + spheres.size() + capsules.size() + boxes.size() + meshes.size();
    }
};

// A body of any shape in the coordinates of its formulas (shaders/shared/body_shapes.h).
struct PlacedBody
{
    Pose rest;                 // of the body's own axes; a plane's normal and a capsule's line are its y axis
    glm::vec3 half_size{0};    // of a box; a capsule's half length is y
    float radius = 0;          // of a sphere or capsule
    const BodyMotion* motion;  // points into the Bodies
    const DistanceGrid* grid;  // of a mesh, else null
};

// All bodies in the order in which they push: planes, spheres, capsules, boxes, meshes. `bodies` must outlive it.
std::vector<PlacedBody> placed_bodies(const Bodies& bodies);

}  // namespace nuno
