// Reads bodies, handles and their keyframes.
#include "scene/body_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/error.h"

namespace nuno {
namespace {

float positive_length(TomlTable& table, std::string_view key, double fallback)
{
    const double metres = table.number(key, fallback);
    if (!(metres > 0) || !(metres < 1e6)) table.fail(key, "a number of metres above 0 and below 1e6");
    return static_cast<float>(metres);
}

glm::dvec3 unit_vector(TomlTable& table, std::string_view key, glm::vec3 fallback)
{
    const glm::dvec3 v(table.vector(key, fallback));
    if (!(glm::length(v) > 0)) table.fail(key, "three numbers that are not all zero");
    return glm::normalize(v);
}

struct AxisAngle
{
    glm::dvec3 axis{0, 1, 0};
    double angle = 0;  // [rad]
};

AxisAngle axis_angle_of(const glm::dquat& q)
{
    const glm::dvec3 v = (q.w < 0 ? -1.0 : 1.0) * glm::dvec3(q.x, q.y, q.z);
    const double sine = glm::length(v);
    if (sine == 0) return {};
    return {v / sine, 2 * std::atan2(sine, std::abs(q.w))};
}

// A rotation as axis and angle [degrees], or as quaternion [x, y, z, w].
AxisAngle read_rotation(TomlTable& table)
{
    const toml::array* quaternion = table.array("quaternion");
    const double degrees = table.number("angle", 0);
    const glm::dvec3 axis = unit_vector(table, "axis", {0, 1, 0});
    if (!std::isfinite(degrees)) table.fail("angle", "a finite number of degrees");
    if (!quaternion) return {axis, glm::radians(degrees)};
    if (degrees != 0) table.fail("quaternion", "left out where angle is given");
    double q[4] = {};
    for (std::size_t k = 0; k < 4 && quaternion->size() == 4; ++k) {
        const auto number = quaternion->get(k)->value<double>();
        q[k] = number && std::isfinite(*number) ? *number : 0;
    }
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(length > 0)) table.fail("quaternion", "four numbers that are not all zero, [x, y, z, w]");
    return axis_angle_of(glm::dquat(q[3] / length, q[0] / length, q[1] / length, q[2] / length));
}

glm::quat read_placing(TomlTable& table)
{
    const AxisAngle turn = read_rotation(table);
    return glm::quat(rotation_about(turn.axis, turn.angle));
}

Keyframe read_keyframe(TomlTable table)
{
    Keyframe key;
    key.time_s = table.number("time", NAN);
    if (!std::isfinite(key.time_s)) table.fail("time", "a finite number of seconds, in every keyframe");
    key.move = table.vector("move", {0, 0, 0});
    const AxisAngle turn = read_rotation(table);
    key.axis = turn.axis;
    key.angle = turn.angle;
    table.finish();
    return key;
}

void check_repeat(const BodyMotion& motion, const TomlTable& table)
{
    if (motion.keyframes.size() < 2) table.fail("repeat", "false, or there must be two keyframes or more");
    const Keyframe &first = motion.keyframes.front(), &last = motion.keyframes.back();
    const glm::dquat a = rotation_about(first.axis, first.angle), b = rotation_about(last.axis, last.angle);
    if (glm::distance(first.move, last.move) > 1e-6 || std::abs(glm::dot(a, b)) < 1 - 1e-9)
        table.fail("repeat", "false, or the last keyframe must be where the first is");
}

BodyMotion read_motion(TomlTable& table, const std::string& file_name)
{
    BodyMotion motion;
    const std::string easing = table.text("easing", "smooth");
    if (easing != "smooth" && easing != "linear") table.fail("easing", "smooth or linear");
    motion.easing = easing == "smooth" ? Easing::smooth : Easing::linear;
    motion.repeat = table.flag("repeat", false);
    const glm::vec3 pivot = table.vector("pivot", {0, 0, 0});
    if (table.has("pivot")) motion.pivot = glm::dvec3(pivot);
    const toml::array* list = table.array("keyframes");
    if (list && list->empty()) table.fail("keyframes", "a list with at least one keyframe, or left out");
    for (std::size_t i = 0; list && i < list->size(); ++i) {
        const toml::table* entry = list->get(i)->as_table();
        if (!entry) table.fail("keyframes", "a list of {time = ..., move = [x, y, z], axis = [x, y, z], angle = ...}");
        const TomlTable key_table(*entry, file_name);
        const Keyframe key = read_keyframe(key_table);
        if (i > 0 && !(key.time_s > motion.keyframes.back().time_s))
            key_table.fail("time", fmt::format("later than that of the keyframe before it, which is {:g} s",
                                               motion.keyframes.back().time_s));
        motion.keyframes.push_back(key);
    }
    if (motion.repeat) check_repeat(motion, table);
    return motion;
}

BodyMotion read_motion_of_body(TomlTable& table, const std::string& file_name)
{
    BodyMotion motion = read_motion(table, file_name);
    motion.group = table.text("group", "");
    return motion;
}

Plane read_plane(TomlTable table, const std::string& file_name)
{
    Plane plane;
    plane.normal = glm::vec3(unit_vector(table, "normal", plane.normal));
    plane.offset = static_cast<float>(table.number("offset", 0));
    if (!std::isfinite(plane.offset)) table.fail("offset", "a finite number of metres");
    plane.motion = read_motion(table, file_name);
    table.finish();
    return plane;
}

Sphere read_sphere(TomlTable table, const std::string& file_name)
{
    Sphere sphere;
    sphere.centre = table.vector("centre", sphere.centre);
    sphere.radius = positive_length(table, "radius", 1);
    sphere.motion = read_motion_of_body(table, file_name);
    table.finish();
    return sphere;
}

Capsule read_capsule(TomlTable table, const std::string& file_name)
{
    Capsule capsule;
    capsule.from = table.vector("from", capsule.from);
    capsule.to = table.vector("to", capsule.to);
    capsule.radius = positive_length(table, "radius", 0.1);
    capsule.motion = read_motion_of_body(table, file_name);
    table.finish();
    return capsule;
}

Box read_box(TomlTable table, const std::string& file_name)
{
    Box box;
    box.centre = table.vector("centre", box.centre);
    box.size = table.vector("size", box.size);
    if (!(box.size.x > 0 && box.size.y > 0 && box.size.z > 0)) table.fail("size", "three numbers of metres above 0");
    box.rotation = read_placing(table);
    box.motion = read_motion_of_body(table, file_name);
    table.finish();
    return box;
}

MeshBody read_body_mesh(TomlTable table, const std::string& file_name, const std::filesystem::path& scene_path)
{
    MeshBody body;
    const std::string mesh = table.text("mesh", "");
    if (mesh.empty()) table.fail("mesh", "the path of an OBJ file");
    body.position = table.vector("position", body.position);
    body.rotation = read_placing(table);
    const float scale = positive_length(table, "scale", 1);
    const float cell = table.has("cell") ? positive_length(table, "cell", 0) : (table.number("cell", 0), 0.0f);
    body.motion = read_motion_of_body(table, file_name);
    table.finish();
    const std::string where = table.where("mesh");
    const std::filesystem::path path = (scene_path.parent_path() / mesh).lexically_normal();
    body.mesh = load_obj(path);
    for (glm::vec3& p : body.mesh.positions) p *= scale;
    body.grid = std::make_shared<DistanceGrid>(
        make_distance_grid(body.mesh, cell, fmt::format("{}: {}", where, path.string())));
    return body;
}

void add_handle(TomlTable table, const std::string& file_name, std::vector<Handle>& handles)
{
    Handle handle;
    handle.name = table.text("name", "");
    if (handle.name.empty()) table.fail("name", "a text that the handles of a [[sheet]] can name");
    for (const Handle& other : handles)
        if (other.name == handle.name) table.fail("name", "a name that no other handle has");
    handle.motion = read_motion(table, file_name);
    table.finish();
    handles.push_back(std::move(handle));
}

}  // namespace

Bodies read_bodies(TomlTable& file, const std::string& file_name, const std::filesystem::path& scene_path)
{
    Bodies bodies;
    file.for_each_table("plane", [&](TomlTable t) { bodies.planes.push_back(read_plane(std::move(t), file_name)); });
    file.for_each_table("sphere", [&](TomlTable t) { bodies.spheres.push_back(read_sphere(std::move(t), file_name)); });
    file.for_each_table("capsule",
                        [&](TomlTable t) { bodies.capsules.push_back(read_capsule(std::move(t), file_name)); });
    file.for_each_table("box", [&](TomlTable t) { bodies.boxes.push_back(read_box(std::move(t), file_name)); });
    file.for_each_table("body_mesh", [&](TomlTable t) {
        bodies.meshes.push_back(read_body_mesh(std::move(t), file_name, scene_path));
    });
    file.for_each_table("handle", [&](TomlTable t) { add_handle(std::move(t), file_name, bodies.handles); });
    return bodies;
}

}  // namespace nuno
