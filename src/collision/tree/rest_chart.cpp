// Rest coordinates of a flat mesh, and bounds of its gradients over them.
#include "collision/tree/rest_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "collision/tree/rest_rim.h"
#include "core/task_share.h"

namespace nuno {
namespace {

constexpr double kFlat = 1e-6;  // of the size of the sheet
constexpr std::uint32_t kFacesInTask = 4096;
// Gradients are uncertain by 2^-22 of what they are the difference of; above this many times their size there is no
// use.
constexpr double kMostUncertain = 1e3;

// The plane of the sheet as two axes; nothing where it is not flat.
struct Plane
{
    glm::dvec3 origin, u, v;

    glm::dvec2 place(glm::vec3 p) const
    {
        const glm::dvec3 from = glm::dvec3(p) - origin;
        return {glm::dot(from, u), glm::dot(from, v)};
    }
};

std::optional<Plane> plane_of(std::span<const glm::vec3> positions, std::span<const glm::uvec3> faces)
{
    glm::dvec3 area(0);
    double size = 0;
    const glm::dvec3 origin(positions[faces[0].x]);
    for (const glm::uvec3& face : faces) {
        const glm::dvec3 a(positions[face.x]), b(positions[face.y]), c(positions[face.z]);
        area += glm::cross(b - a, c - a);
        size = std::max(size, glm::distance(a, origin));
    }
    if (!(glm::length(area) > 0)) return std::nullopt;
    const glm::dvec3 normal = glm::normalize(area);
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k)
            if (std::abs(glm::dot(glm::dvec3(positions[face[k]]) - origin, normal)) > kFlat * size) return std::nullopt;
    const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, normal));
    return Plane{origin, u, glm::cross(normal, u)};
}

// One face at rest: its chart, the least of its heights, and how many times its gradients the parts are of which they
// are the difference.
struct FlatFace
{
    FaceChart chart;
    double height, uncertainty;
};

std::optional<FlatFace> flat_face(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c)
{
    const glm::dvec2 p = b - a, q = c - a, r = c - b;
    const double area = p.x * q.y - p.y * q.x;  // twice
    if (!(area > 0)) return std::nullopt;
    // [f_b - f_a, f_c - f_a] = J [p, q], so J = [..] [p, q]^-1.
    const double inverse[4] = {q.y / area, -p.y / area, -q.x / area, p.x / area};
    const double longest = std::max({glm::length(p), glm::length(q), glm::length(r)});
    // At an obtuse corner the opposite edge is nearest elsewhere than along a height, but no nearer than that.
    FlatFace face{{}, area / longest, longest * longest / area};
    for (std::size_t k = 0; k < 4; ++k) face.chart.inverse[k] = static_cast<float>(inverse[k]);
    return face;
}

}  // namespace

std::optional<RestChart> RestChart::make(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                                         const Sheet& sheet)
{
    const std::span<const glm::uvec3> own = faces.subspan(sheet.first_face, sheet.face_count);
    const std::optional<Plane> plane = plane_of(rest_positions, own);
    if (!plane) return std::nullopt;
    RestChart chart;
    chart.first_face_ = sheet.first_face;
    chart.least_height_ = std::numeric_limits<double>::infinity();
    double uncertainty = 1;
    std::vector<glm::dvec2> places;
    for (const glm::vec3& p : rest_positions) places.push_back(plane->place(p));
    for (const glm::uvec3& face : own) {
        const std::optional<FlatFace> flat = flat_face(places[face.x], places[face.y], places[face.z]);
        if (!flat || flat->uncertainty > kMostUncertain) return std::nullopt;
        chart.charts_.push_back(flat->chart);
        chart.least_height_ = std::min(chart.least_height_, flat->height);
        uncertainty = std::max(uncertainty, flat->uncertainty);
    }
    const std::optional<double> roughness = rim_roughness(places, own);
    if (!roughness) return std::nullopt;
    chart.slack_ = static_cast<float>(1e-5 + 2.1 * *roughness + 0x1p-21 * uncertainty);
    return chart;
}

bool RestChart::is_apart(const Poses& poses, std::span<const glm::uvec3> faces, const TreeSettings& settings,
                         const TreeKernels& kernels, ThreadPool& pool) const
{
    typedef std::array<float, 12> Bounds;
    const auto face_count = static_cast<std::uint32_t>(charts_.size());
    std::vector<Bounds> parts((face_count + kFacesInTask - 1) / kFacesInTask);
    share_tasks(pool, static_cast<int>(parts.size()), [&](int task, int) {
        const std::uint32_t begin = static_cast<std::uint32_t>(task) * kFacesInTask;
        const FaceChartRun run{faces.data() + first_face_ + begin, charts_.data() + begin,
                               std::min(kFacesInTask, face_count - begin)};
        Bounds& bounds = parts[static_cast<std::size_t>(task)];
        kernels.gradient_bounds(poses.t0.data(), run, true, bounds.data());
        if (poses.is_swept()) kernels.gradient_bounds(poses.t1.data(), run, false, bounds.data());
    });
    // One block for the whole sheet, with the room that EdgeLevel asks for.
    std::array<std::array<float, 36>, 12> rows{};
    EdgeLevel whole;
    whole.width = whole.height = 1;
    whole.stride = 18;
    for (std::size_t bound = 0; bound < 12; ++bound) {
        whole.bound[bound] = rows[bound].data();
        rows[bound][0] = parts[0][bound];
        for (const Bounds& part : parts)
            rows[bound][0] =
                bound / 3 % 2 == 1 ? std::max(rows[bound][0], part[bound]) : std::min(rows[bound][0], part[bound]);
    }
    const double asked = std::min(double(settings.distance) / least_height_, double(settings.rest_share)) +
                         double(settings.margin) / least_height_;
    const double need = asked * 1.0001 + 1e-6 / least_height_;
    std::uint8_t flag = 0;
    kernels.prove_blocks(whole, static_cast<float>(need), slack_, &flag);
    return (flag & 1) != 0;
}

}  // namespace nuno
