// Finds what collides between two frames of one mesh, its vertices going straight from one to the other, through nuno's
// own tree and continuous tests.
//   mesh_ccd T0.ply T1.ply
// prints a line "vf,vertex,face" or "ee,vertex,vertex,vertex,vertex" for each pair without a common vertex that meets,
// numbers as in the files; times on stderr. Exit 0, or 2 where the files are no such meshes. A vertex of no face is no
// part of the mesh.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "collision/ccd/impact.h"
#include "collision/element_query.h"
#include "core/stopwatch.h"
#include "core/task_share.h"
#include "exact/mesh_files.h"

namespace nuno {
namespace {

using Positions = std::vector<std::array<double, 3>>;

glm::dvec3 at(const Positions& positions, std::uint32_t vertex)
{
    const auto& x = positions[vertex];
    return {x[0], x[1], x[2]};
}

std::vector<glm::vec4> rounded(const Positions& positions)
{
    std::vector<glm::vec4> all;
    for (const auto& x : positions) all.emplace_back(x[0], x[1], x[2], 1);
    return all;
}

// By how much rounding to float moves a coordinate at most.
float rounding(const Positions& positions)
{
    double largest = 0;
    for (const auto& x : positions)
        for (const double a : x) {
            if (!std::isfinite(a) || std::abs(a) > 1e30)
                throw std::runtime_error("a coordinate is not finite, or huge");
            largest = std::max(largest, std::abs(a));
        }
    return static_cast<float>(largest) * std::numeric_limits<float>::epsilon();
}

bool meets(const ElementPair& pair, const Positions& x0, const Positions& x1)
{
    FourPoints t0, t1;
    for (int i = 0; i < 4; ++i) {
        t0[std::size_t(i)] = at(x0, pair.vertices[i]);
        t1[std::size_t(i)] = at(x1, pair.vertices[i]);
    }
    return (pair.kind == PairKind::vertex_face ? vertex_face_impact(t0, t1) : edge_edge_impact(t0, t1)).has_value();
}

std::string line_of(const ElementPair& pair)
{
    const glm::uvec4& v = pair.vertices;
    if (pair.kind == PairKind::vertex_face) return fmt::format("vf,{},{}\n", v.x, pair.face);
    std::array<std::uint32_t, 2> a{std::min(v.x, v.y), std::max(v.x, v.y)}, b{std::min(v.z, v.w), std::max(v.z, v.w)};
    if (b < a) std::swap(a, b);
    return fmt::format("ee,{},{},{},{}\n", a[0], a[1], b[0], b[1]);
}

struct Answer
{
    std::vector<std::string> lines;
    std::uint64_t tested = 0;
};

void run(const std::string& first, const std::string& second)
{
    const CheckedMesh t0 = read_mesh(first), t1 = read_mesh(second);
    if (t0.faces != t1.faces || t0.positions.size() != t1.positions.size())
        throw std::runtime_error(second + ": not the same mesh as " + first);
    std::vector<glm::uvec3> faces;
    for (const auto& f : t0.faces) faces.emplace_back(f[0], f[1], f[2]);
    const std::vector<glm::vec4> x0 = rounded(t0.positions), x1 = rounded(t1.positions);
    const std::vector<glm::vec3> rest(x0.begin(), x0.end());
    const float growth = std::max(rounding(t0.positions), rounding(t1.positions));

    ThreadPool pool(0);
    Stopwatch watch;
    ElementQuery query(rest, faces);
    const double build_ms = watch.lap_ms();
    const int tasks = query.begin({x0, x1}, {2 * growth, Culling::sound}, pool);
    const double tree_ms = watch.lap_ms();
    std::vector<Answer> answers(static_cast<std::size_t>(tasks));
    share_tasks(pool, tasks, [&](int task, int) {
        Answer& answer = answers[std::size_t(task)];
        query.run(task, [&](const ElementPair& pair) {
            ++answer.tested;
            if (meets(pair, t0.positions, t1.positions)) answer.lines.push_back(line_of(pair));
        });
    });
    const double test_ms = watch.lap_ms();

    std::uint64_t tested = 0, hits = 0;
    for (const Answer& answer : answers) {
        tested += answer.tested;
        hits += answer.lines.size();
        for (const std::string& line : answer.lines) std::fputs(line.c_str(), stdout);
    }
    fmt::print(
        stderr,
        "build {:.1f} ms, refit and query {:.1f} ms, {} continuous tests {:.1f} ms on {} threads, {:.3f} us each, "
        "{} collide\n",
        build_ms, tree_ms, tested, test_ms, pool.thread_count(),
        1e3 * test_ms * pool.thread_count() / double(std::max<std::uint64_t>(tested, 1)), hits);
}

}  // namespace
}  // namespace nuno

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::fprintf(stderr, "usage: mesh_ccd T0.ply T1.ply\n");
        return 2;
    }
    try {
        nuno::run(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mesh_ccd: %s\n", error.what());
        return 2;
    }
}
