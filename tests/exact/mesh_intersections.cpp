// Counts the pairs of faces that intersect in meshes, by exact predicates of CGAL; shares no code with nuno.
//   mesh_intersections FILE...
// prints "FILE: N" for each; exit 0 if all N are 0, 1 if not, 2 where a file is no mesh, holds a number that is not
// finite, or a face without area.
// Faces with a common edge count where they are folded onto each other, faces with a common vertex where one meets the
// edge of the other that is opposite to it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <vector>

#include "exact/mesh_files.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
using Face = std::array<std::uint32_t, 3>;

class Soup
{
  public:
    explicit Soup(const nuno::CheckedMesh& mesh) : faces_(mesh.faces)
    {
        for (const auto& x : mesh.positions) points_.emplace_back(x[0], x[1], x[2]);
    }

    bool is_degenerate(std::size_t f) const { return CGAL::collinear(point(f, 0), point(f, 1), point(f, 2)); }
    Box box(std::size_t f) const { return Box(triangle(f).bbox(), f); }

    bool intersect(std::size_t f, std::size_t g) const
    {
        std::vector<int> own, others;  // corners in common, as numbered in f and in g
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (faces_[f][i] == faces_[g][j]) {
                    own.push_back(i);
                    others.push_back(j);
                }
        if (own.size() == 3) return true;
        if (own.size() == 2) return folded(f, g, 3 - own[0] - own[1], 3 - others[0] - others[1], own[0], own[1]);
        if (own.size() == 1)
            return CGAL::do_intersect(triangle(f), opposite(g, others[0])) ||
                   CGAL::do_intersect(triangle(g), opposite(f, own[0]));
        return CGAL::do_intersect(triangle(f), triangle(g));
    }

  private:
    const Point& point(std::size_t f, int corner) const { return points_[faces_[f][std::size_t(corner)]]; }
    Kernel::Triangle_3 triangle(std::size_t f) const { return {point(f, 0), point(f, 1), point(f, 2)}; }
    Kernel::Segment_3 opposite(std::size_t f, int corner) const
    {
        return {point(f, (corner + 1) % 3), point(f, (corner + 2) % 3)};
    }
    // Faces with the edge a b in common (corners of f): in one plane, on the same side of it.
    bool folded(std::size_t f, std::size_t g, int apex_f, int apex_g, int a, int b) const
    {
        return CGAL::coplanar(point(f, a), point(f, b), point(f, apex_f), point(g, apex_g)) &&
               CGAL::coplanar_orientation(point(f, a), point(f, b), point(f, apex_f), point(g, apex_g)) ==
                   CGAL::POSITIVE;
    }

    std::vector<Point> points_;
    std::vector<Face> faces_;
};

// The number of intersecting pairs; std::runtime_error where the mesh has none.
std::size_t count_intersections(const nuno::CheckedMesh& mesh)
{
    for (const auto& x : mesh.positions)
        for (const double a : x)
            if (!std::isfinite(a)) throw std::runtime_error("a coordinate is not finite");
    const Soup soup(mesh);
    std::vector<Box> boxes;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (soup.is_degenerate(f)) throw std::runtime_error("face " + std::to_string(f) + " has no area");
        boxes.push_back(soup.box(f));
    }
    std::size_t count = 0;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                  [&](const Box& a, const Box& b) { count += soup.intersect(a.info(), b.info()); });
    return count;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2) {
        std::fprintf(stderr, "usage: mesh_intersections FILE...   (PLY or OBJ, triangles)\n");
        return 2;
    }
    int status = 0;
    for (int i = 1; i < argc; ++i) try
        {
            const std::size_t count = count_intersections(nuno::read_mesh(argv[i]));
            std::printf("%s: %zu\n", argv[i], count);
            if (count > 0 && status == 0) status = 1;
        } catch (const std::exception& error) {
            const bool named = std::strstr(error.what(), argv[i]) != nullptr;
            std::fprintf(stderr, "mesh_intersections: %s%s%s\n", named ? "" : argv[i], named ? "" : ": ", error.what());
            status = 2;
        }
    return status;
}
