// Windows of sheets and of nodes, proven from the largest down.
#include "collision/tree/chart_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/task_share.h"

namespace nuno {
namespace {

// Cloth at rest has a lambda of 1; nothing above is tried.
constexpr double kMostNeed = 1;
// Cloths with fewer faces are done in less time than it takes to wake a thread.
constexpr std::size_t kLargeFaceCount = 8192;

// Rows e1, e2 of the symmetric orthonormalisation of J = [u v]: L = (J^T J)^(-1/2) J^T. Nothing where u and v are nearly
// parallel.
std::optional<std::array<glm::dvec3, 2>> orthonormal(glm::dvec3 u, glm::dvec3 v)
{
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), area_sq = uu * vv - uv * uv;
    if (!(area_sq > 1e-8 * uu * vv)) return std::nullopt;
    // sqrt(G) = (G + sqrt(det G) I) / sqrt(tr G + 2 sqrt(det G)), of determinant sqrt(det G).
    const double area = std::sqrt(area_sq), trace = std::sqrt(uu + vv + 2 * area);
    const double s11 = (uu + area) / trace, s22 = (vv + area) / trace, s12 = uv / trace;
    return std::array{(s22 * u - s12 * v) / area, (s11 * v - s12 * u) / area};
}

}  // namespace

std::optional<ChartTest> ChartProof::test_of(const ChartWindow& chart, const Way& way)
{
    const double asked = std::min(double(way.settings.distance) / chart.least_distance,
                                  double(way.settings.rest_share) * chart.stretch) +
                         double(way.settings.margin) / chart.least_distance;
    const double need = asked * 1.0001 + chart.rounding;
    if (!(need < kMostNeed)) return std::nullopt;
    glm::dvec3 u(0), v(0);
    for (const std::span<const glm::vec4> pose : {way.poses.t0, way.poses.t1})
        for (const ChartSample& sample : chart.samples) {
            const glm::dvec3 x(glm::vec3(pose[sample.vertex] - pose[chart.centre]));
            u += double(sample.weight.x) * x;
            v += double(sample.weight.y) * x;
        }
    const std::optional<std::array<glm::dvec3, 2>> rows = orthonormal(u, v);
    if (!rows) return std::nullopt;
    const auto less = static_cast<float>(-need);
    ChartTest test{{}, {1, 1, less, less}, chart.centre, chart.reach, chart.rim_rounding};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t row = 0; row < 2; ++row)
            test.column[axis][2 + row] = static_cast<float>((*rows)[row][static_cast<int>(axis)]);
    return test;
}

bool ChartProof::holds_where_it_failed(const ChartWindow& chart, const ChartTest& test, const Way& way)
{
    return way.kernels.prove_face(way.poses.t0.data(), chart.failed, test) &&
           (!way.poses.is_swept() || way.kernels.prove_face(way.poses.t1.data(), chart.failed, test));
}

ChartAnswer ChartProof::prove_part(const ChartPart& part, const ChartTest& test, const Way& way)
{
    const ChartAnswer answer = way.kernels.prove_part(way.poses.t0.data(), part, test);
    return answer.holds && way.poses.is_swept() ? way.kernels.prove_part(way.poses.t1.data(), part, test) : answer;
}

bool ChartProof::prove_window(ChartWindow& chart, const Way& way)
{
    const std::optional<ChartTest> test = test_of(chart, way);
    if (!test || !holds_where_it_failed(chart, *test, way)) return false;
    for (const ChartPart& part : chart.parts) {
        const ChartAnswer answer = prove_part(part, *test, way);
        if (answer.failed) chart.failed = *answer.failed;
        if (!answer.holds) return false;
    }
    return true;
}

void ChartProof::prove_family(std::uint32_t window, const Way& way)
{
    is_proven_[window] = prove_window(windows_[window].chart, way);
    if (is_proven_[window] == 0)
        for (const std::uint32_t inner : windows_[window].inner) prove_family(inner, way);
}

// Sheets are large: their parts are shared out.
void ChartProof::prove_sheets(const Way& way, ThreadPool& pool)
{
    tasks_.clear();
    for (const std::uint32_t sheet : sheets_) {
        const ChartWindow& chart = windows_[sheet].chart;
        const std::optional<ChartTest> test = test_of(chart, way);
        if (!test || !holds_where_it_failed(chart, *test, way)) continue;
        is_proven_[sheet] = 1;
        for (std::size_t part = 0; part < chart.parts.size(); ++part) tasks_.push_back({sheet, part, *test, {}});
    }
    share(pool, tasks_.size(), [&](std::size_t number) {
        PartTask& task = tasks_[number];
        task.answer = prove_part(windows_[task.window].chart.parts[task.part], task.test, way);
    });
    for (const PartTask& task : tasks_) {
        if (!task.answer.holds) is_proven_[task.window] = 0;
        if (task.answer.failed) windows_[task.window].chart.failed = *task.answer.failed;
    }
}

void ChartProof::share(ThreadPool& pool, std::size_t task_count, const std::function<void(std::size_t)>& body) const
{
    if (node_of_face_.size() < kLargeFaceCount)
        for (std::size_t task = 0; task < task_count; ++task) body(task);
    else
        share_tasks(pool, static_cast<int>(task_count), [&](int task, int) { body(static_cast<std::size_t>(task)); });
}

void ChartProof::prove(const Poses& poses, const TreeSettings& settings, const TreeKernels& kernels, ThreadPool& pool)
{
    const Way way{poses, settings, kernels};
    std::fill(is_proven_.begin(), is_proven_.end(), std::uint8_t{0});
    for (std::vector<std::uint32_t>& level : of_node_) std::fill(level.begin(), level.end(), kNoWindow);
    prove_sheets(way, pool);
    const auto is_open = [&](const Family& family) {
        return family.sheet == kNoWindow || is_proven_[family.sheet] == 0;
    };
    share(pool, families_.size(), [&](std::size_t number) {
        if (is_open(families_[number])) prove_family(families_[number].window, way);
    });
    for (const std::uint32_t sheet : sheets_)
        if (is_proven_[sheet] != 0) note(sheet);
    for (const Family& family : families_)
        if (is_open(family)) note_family(family.window);
}

void ChartProof::note_family(std::uint32_t window)
{
    if (is_proven_[window] != 0) return note(window);
    for (const std::uint32_t inner : windows_[window].inner) note_family(inner);
}

// Nodes of level l are 4^(l - 1) of level 1.
void ChartProof::note(std::uint32_t window)
{
    for (std::size_t level = 1; level < of_node_.size(); ++level) {
        const std::uint32_t width = std::uint32_t{1} << (2 * (level - 1));
        const std::uint32_t begin = (windows_[window].begin + width - 1) / width, end = windows_[window].end / width;
        if (begin >= end) return;
        std::fill(of_node_[level].begin() + begin, of_node_[level].begin() + end, window);
    }
}

bool ChartProof::holds_for_all() const
{
    return has_all_sheets_ &&
           std::all_of(sheets_.begin(), sheets_.end(), [&](std::uint32_t sheet) { return is_proven_[sheet] != 0; });
}

}  // namespace nuno
