// Grids renumbered and recut; brute force.
#include "collision/tree/tree_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "collision/tree/face_distance.h"

namespace nuno {
namespace {

std::vector<std::uint32_t> random_order(std::size_t count, std::mt19937& bits)
{
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t k = count; k > 1; --k) std::swap(order[k - 1], order[bits() % k]);
    return order;
}

glm::dvec3 place(const Poses& poses, std::uint32_t vertex, double t)
{
    const glm::dvec3 t0(poses.t0[vertex]), t1(poses.t1[vertex]);
    return t0 + t * (t1 - t0);
}

// Cuts the cell whose faces are f and f + 1 from b to c instead of from a to d.
void recut(TreeCase& cloth, std::size_t f)
{
    const std::uint32_t a = cloth.faces[f].x, c = cloth.faces[f].y, d = cloth.faces[f].z, b = cloth.faces[f + 1].z;
    cloth.faces[f] = {a, c, b};
    cloth.faces[f + 1] = {b, c, d};
}

}  // namespace

TreeCase as_grid(std::string name, const Pose& pose, int columns, int rows)
{
    const auto vertex_count = static_cast<std::uint32_t>(pose.rest.size());
    const auto face_count = static_cast<std::uint32_t>(pose.faces.size());
    return {std::move(name), pose.rest,  pose.positions,
            pose.positions,  pose.faces, {{"sheet", 0, vertex_count, 0, face_count, columns, rows, {}}}};
}

TreeCase as_mesh(std::string name, const Pose& pose) { return as_grid(std::move(name), pose, 0, 0); }

TreeCase in_random_order(TreeCase cloth, std::uint32_t seed)
{
    std::mt19937 bits(seed);
    const std::vector<std::uint32_t> place = random_order(cloth.rest.size(), bits);  // new number of each vertex
    TreeCase mixed = cloth;
    mixed.name += " in random order";
    for (std::size_t v = 0; v < place.size(); ++v) {
        mixed.rest[place[v]] = cloth.rest[v];
        mixed.t0[place[v]] = cloth.t0[v];
        mixed.t1[place[v]] = cloth.t1[v];
    }
    const std::vector<std::uint32_t> order = random_order(cloth.faces.size(), bits);
    for (std::size_t f = 0; f < order.size(); ++f) {
        const glm::uvec3 face = cloth.faces[f];
        const int first = static_cast<int>(bits() % 3);
        for (int k = 0; k < 3; ++k) mixed.faces[order[f]][k] = place[face[(first + k) % 3]];
    }
    if (mixed.sheets[0].is_grid()) mixed.sheets[0].grid_order = place;
    return mixed;
}

TreeCase cut_the_other_way(TreeCase cloth)
{
    cloth.name += " cut the other way";
    for (std::size_t f = 0; f < cloth.faces.size(); f += 2) recut(cloth, f);
    return cloth;
}

TreeCase cut_at_random(TreeCase cloth, std::uint32_t seed)
{
    std::mt19937 bits(seed);
    cloth.name += " cut at random";
    for (std::size_t f = 0; f < cloth.faces.size(); f += 2)
        if (bits() % 2 == 0) recut(cloth, f);
    return cloth;
}

TreeCase together(const TreeCase& a, const TreeCase& b)
{
    TreeCase both = a;
    both.name += " and " + b.name;
    const auto first = static_cast<std::uint32_t>(a.rest.size()), face = static_cast<std::uint32_t>(a.faces.size());
    both.rest.insert(both.rest.end(), b.rest.begin(), b.rest.end());
    both.t0.insert(both.t0.end(), b.t0.begin(), b.t0.end());
    both.t1.insert(both.t1.end(), b.t1.begin(), b.t1.end());
    for (const glm::uvec3& f : b.faces) both.faces.push_back(f + first);
    for (Sheet sheet : b.sheets) {
        sheet.first_vertex += first;
        sheet.first_face += face;
        both.sheets.push_back(sheet);
    }
    return both;
}

TreeCase moved_to(TreeCase cloth, const std::vector<glm::vec4>& end)
{
    cloth.t1 = end;
    return cloth;
}

std::vector<TreeCase> hard_cases(int n)
{
    return {as_grid("flat", flat_sheet(n), n, n),
            as_grid("fold", folded_sheet(n, 0.02f), n, n),
            as_grid("roll", rolled_sheet(n, 0.02f), n, n),
            as_grid("flat C", flat_c(n, 0.01f), n, n),
            as_grid("ramp", spiral_ramp(n, 0.01f), n, n),
            as_grid("crumple", crumpled_sheet(n, 0.1f, 1), n, n),
            as_grid("waves", crumpled_sheet(n, 0.02f, 2), n, n)};
}

bool share_vertex(const glm::uvec3& a, const glm::uvec3& b)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (a[i] == b[j]) return true;
    return false;
}

std::vector<FacePair> sorted_pairs(const FaceTree& tree)
{
    std::vector<FacePair> pairs;
    for (const std::span<const FacePair> part : tree.pairs()) pairs.insert(pairs.end(), part.begin(), part.end());
    std::sort(pairs.begin(), pairs.end());
    EXPECT_TRUE(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end()) << "a pair is found twice";
    EXPECT_TRUE(std::all_of(pairs.begin(), pairs.end(), [](FacePair pair) { return pair.a < pair.b; }));
    return pairs;
}

std::vector<FacePair> brute_force_pairs(const FaceTree& tree)
{
    const std::span<const glm::uvec3> faces = tree.faces();
    std::vector<FaceBox> boxes;
    for (std::uint32_t f = 0; f < faces.size(); ++f) boxes.push_back(tree.face_box(f));
    std::vector<FacePair> pairs;
    for (std::uint32_t a = 0; a < faces.size(); ++a)
        for (std::uint32_t b = a + 1; b < faces.size(); ++b)
            if (boxes[a].overlaps(boxes[b]) && !share_vertex(faces[a], faces[b])) pairs.push_back({a, b});
    return pairs;
}

double face_distance(const TreeCase& cloth, const Poses& poses, FacePair pair, double t)
{
    const auto triangle = [&](std::uint32_t face) {
        const glm::uvec3 corners = cloth.faces[face];
        return Triangle{place(poses, corners.x, t), place(poses, corners.y, t), place(poses, corners.z, t)};
    };
    return triangle_distance(triangle(pair.a), triangle(pair.b));
}

double face_elements_distance(const TreeCase& cloth, const Poses& poses, FacePair pair, double t)
{
    double least = 1e30;
    const auto compare = [&](const glm::uvec3& a, const glm::uvec3& b) {
        const auto triangle = [&](const glm::uvec3& corners) {
            return Triangle{place(poses, corners.x, t), place(poses, corners.y, t), place(poses, corners.z, t)};
        };
        if (!share_vertex(a, b)) least = std::min(least, triangle_distance(triangle(a), triangle(b)));
    };
    const glm::uvec3 first = cloth.faces[pair.a], second = cloth.faces[pair.b];
    for (int i = 0; i < 3; ++i) {
        compare({first[i], first[i], first[i]}, second);
        compare({second[i], second[i], second[i]}, first);
        for (int j = 0; j < 3; ++j)
            compare({first[i], first[(i + 1) % 3], first[i]}, {second[j], second[(j + 1) % 3], second[j]});
    }
    return least;
}

double element_distance(const TreeCase& cloth, const Poses& poses, double t)
{
    std::vector<glm::uvec3> elements;  // edges and vertices as faces without area
    for (const glm::uvec3& face : cloth.faces)
        for (int k = 0; k < 3; ++k) elements.emplace_back(face[k], face[(k + 1) % 3], face[(k + 1) % 3]);
    for (std::uint32_t v = 0; v < cloth.rest.size(); ++v) elements.emplace_back(v, v, v);
    const auto triangle = [&](const glm::uvec3& corners) {
        return Triangle{place(poses, corners.x, t), place(poses, corners.y, t), place(poses, corners.z, t)};
    };
    double least = 1e30;
    for (const glm::uvec3& a : elements) {
        const bool is_vertex = a.x == a.y;
        const std::span<const glm::uvec3> others = is_vertex ? std::span<const glm::uvec3>(cloth.faces) : elements;
        for (const glm::uvec3& b : others)
            if (!share_vertex(a, b)) least = std::min(least, triangle_distance(triangle(a), triangle(b)));
    }
    return least;
}

}  // namespace nuno
