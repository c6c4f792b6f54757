// Cloths as the tree is given them: poses of tests/collision/poses.h as grids, cut and numbered in several ways, and as
// meshes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "collision/poses.h"
#include "collision/tree/face_tree.h"

namespace nuno {

struct TreeCase
{
    std::string name;
    std::vector<glm::vec3> rest;
    std::vector<glm::vec4> t0, t1;
    std::vector<glm::uvec3> faces;
    std::vector<Sheet> sheets;

    Poses still() const { return {t0, t0}; }
    Poses moving() const { return {t0, t1}; }
    FaceTree tree() const { return FaceTree(rest, faces, sheets); }
};

// A pose of n x n vertices (columns, then rows) as a grid sheet; at rest until t1 is set.
TreeCase as_grid(std::string name, const Pose& pose, int columns, int rows);
TreeCase as_mesh(std::string name, const Pose& pose);
// The same cloth with its vertices, its faces and the corners of each face in a random order.
TreeCase in_random_order(TreeCase cloth, std::uint32_t seed);
// All cells, or a random half of them, cut along the other diagonal.
TreeCase cut_the_other_way(TreeCase cloth);
TreeCase cut_at_random(TreeCase cloth, std::uint32_t seed);
// Sheets of both, one after the other.
TreeCase together(const TreeCase& a, const TreeCase& b);
// Moving: every vertex from where it is to where `end` has it.
TreeCase moved_to(TreeCase cloth, const std::vector<glm::vec4>& end);

// Those of the poses that are hard: flat, folded, rolled up, a flat C whose ends touch, a ramp, crumples.
std::vector<TreeCase> hard_cases(int n);

bool share_vertex(const glm::uvec3& a, const glm::uvec3& b);
// The pairs of the last query in order; fails the test where one is there twice, or a > b.
std::vector<FacePair> sorted_pairs(const FaceTree& tree);
// All faces against all: without a common vertex, boxes as of the tree's last refit.
std::vector<FacePair> brute_force_pairs(const FaceTree& tree);
// The least distance of two faces at time t = 0 .. 1 of their way.
double face_distance(const TreeCase& cloth, const Poses& poses, FacePair pair, double t);

// The least distance, at time t, of a vertex to a face that it is no corner of and of two edges without a common end:
// of the two faces, and of the whole cloth.
double face_elements_distance(const TreeCase& cloth, const Poses& poses, FacePair pair, double t);
double element_distance(const TreeCase& cloth, const Poses& poses, double t);

}  // namespace nuno
