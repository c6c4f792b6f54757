// Bodies that several tests start from.
#include "support/bodies.h"

#include <glm/geometric.hpp>

#include "support/body_meshes.h"
#include "support/sheets.h"

namespace nuno {
namespace {

BodyMotion moving(glm::dvec3 move, glm::dvec3 axis)
{
    BodyMotion motion;
    motion.keyframes = {{0, {0, 0, 0}, axis, 0}, {0.3, move, axis, 0.8}};
    return motion;
}

}  // namespace

Bodies one_of_each_shape()
{
    Bodies bodies;
    bodies.planes.push_back({glm::normalize(glm::vec3(0.1f, 1, 0)), -0.5f, moving({0, 0.02, 0}, {1, 0, 0})});
    bodies.spheres.push_back({{-0.3f, -0.2f, 0.1f}, 0.15f, moving({0.2, 0.1, 0}, {0, 1, 0})});
    bodies.capsules.push_back({{0.1f, -0.2f, 0.2f}, {0.4f, -0.1f, 0.3f}, 0.1f, moving({0, 0.1, 0}, {0, 0, 1})});
    bodies.boxes.push_back({{0.2f, -0.3f, -0.2f},
                            {0.2f, 0.3f, 0.25f},
                            glm::angleAxis(0.4f, glm::vec3(0, 0.6f, 0.8f)),
                            moving({0, 0.2, 0}, {0, 1, 0})});
    const TriangleMesh mesh = dented_box_mesh({0.3f, 0.2f, 0.25f}, 0.1f);
    bodies.meshes.push_back({mesh,
                             std::make_shared<DistanceGrid>(make_distance_grid(mesh, 0.03f, "mesh")),
                             {-0.2f, -0.25f, -0.25f},
                             glm::angleAxis(0.3f, glm::vec3(1, 0, 0)),
                             moving({0, 0.2, 0.1}, {0.6, 0.8, 0})});
    return bodies;
}

SheetSource sheet_over_the_shapes(int count)
{
    SheetSource sheet = square_sheet(count, 1);
    sheet.mesh = grid_mesh(count, count, {-0.5f, 0.02f, -0.5f}, {1, 0, 0}, {0, 0, 1});
    return sheet;
}

}  // namespace nuno
