// The grid of level `spheres`.
//
// Cells are as wide as the distance or wider, so that two vertices closer than it lie in one cell or in two that touch.
// Cells are numbered along x, then y, then z, with an empty cell around all of them: so three cells side by side along
// x are three numbers in a row, and the vertices in them, sorted by number, one run. Of the 26 cells around a cell, the
// 13 with higher numbers are the next one and four such runs; as the cell's number grows, so do the beginnings of
// these.
#include "collision/sphere_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "collision/sheet_numbers.h"
#include "core/task_share.h"

namespace nuno {
namespace {

// More cells than so many along an axis, and they are made wider instead.
constexpr double kMostCells = 1 << 20;
// By how much a cell is wider than the distance, for what rounding may do to a place or a distance.
constexpr double kRoom = 1 + 1e-6;
constexpr std::size_t kEntriesOfTask = 2048;
constexpr int kDigitBits = 11;

}  // namespace

SphereSearch::SphereSearch(std::span<const glm::vec3> rest_positions, std::span<const Sheet> sheets)
    : rest_positions_(rest_positions), sheet_numbers_(sheet_numbers(sheets, rest_positions.size()))
{
}

bool SphereSearch::is_pair(const glm::vec4& position_a, const glm::vec4& position_b, VertexPair pair,
                           float distance) const
{
    const auto closer = [distance](const glm::vec3& way) {
        return way.x * way.x + way.y * way.y + way.z * way.z < distance * distance;
    };
    if (!closer(glm::vec3(position_a) - glm::vec3(position_b))) return false;
    return sheet_numbers_[pair.a] != sheet_numbers_[pair.b] ||
           !closer(rest_positions_[pair.a] - rest_positions_[pair.b]);
}

void SphereSearch::sort(std::span<const glm::vec4> positions, float distance)
{
    distance_ = distance;
    entries_.resize(positions.size());
    if (positions.empty()) return;
    glm::dvec3 lo(positions[0]), hi = lo;
    for (const glm::vec4& p : positions) {
        lo = glm::min(lo, glm::dvec3(p));
        hi = glm::max(hi, glm::dvec3(p));
    }
    const glm::dvec3 size = hi - lo;
    const double widest = std::max({size.x, size.y, size.z});
    const double width = std::max({kRoom * double(distance), widest / kMostCells, 1e-30});
    const auto cell_of = [&](double from_lo) { return static_cast<std::uint64_t>(from_lo / width) + 1; };
    row_stride_ = cell_of(size.x) + 2;
    layer_stride_ = row_stride_ * (cell_of(size.y) + 2);
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        const glm::dvec3 at = glm::dvec3(positions[v]) - lo;
        entries_[v] = {cell_of(at.x) + row_stride_ * cell_of(at.y) + layer_stride_ * cell_of(at.z), v};
    }
    sort_entries(layer_stride_ * (cell_of(size.z) + 2));
    positions_.resize(positions.size());
    for (std::size_t e = 0; e < entries_.size(); ++e) positions_[e] = positions[entries_[e].vertex];
}

// By digits, the lowest first; keys are below key_end.
void SphereSearch::sort_entries(std::uint64_t key_end)
{
    unsorted_.resize(entries_.size());
    for (int shift = 0; shift < 64 && key_end >> shift != 0; shift += kDigitBits) {
        const auto digit = [shift](const Entry& e) { return (e.key >> shift) & ((1u << kDigitBits) - 1); };
        std::array<std::uint32_t, (1u << kDigitBits) + 1> starts{};
        for (const Entry& entry : entries_) ++starts[digit(entry) + 1];
        for (std::size_t d = 1; d < starts.size(); ++d) starts[d] += starts[d - 1];
        for (const Entry& entry : entries_) unsorted_[starts[digit(entry)]++] = entry;
        entries_.swap(unsorted_);
    }
}

// Pairs of each of these entries with those behind it.
void SphereSearch::search(std::size_t begin, std::size_t end, Task& task) const
{
    const auto try_pair = [&](std::size_t e, std::size_t other) {
        const auto [a, b] = std::minmax(entries_[e].vertex, entries_[other].vertex);
        ++task.pairs_tested;
        if (is_pair(positions_[e], positions_[other], {a, b}, distance_)) task.pairs.push_back({a, b});
    };
    const std::array<std::uint64_t, 4> rows = {row_stride_, layer_stride_ - row_stride_, layer_stride_,
                                               layer_stride_ + row_stride_};
    const auto begins_before = [](const Entry& entry, std::uint64_t key) { return entry.key < key; };
    std::array<std::size_t, 4> starts;
    for (std::size_t r = 0; r < 4; ++r) {
        const std::uint64_t first = entries_[begin].key + rows[r] - 1;
        starts[r] = static_cast<std::size_t>(std::lower_bound(entries_.begin(), entries_.end(), first, begins_before) -
                                             entries_.begin());
    }
    const std::size_t count = entries_.size();
    for (std::size_t e = begin; e < end; ++e) {
        const std::uint64_t key = entries_[e].key;
        for (std::size_t o = e + 1; o < count && entries_[o].key <= key + 1; ++o) try_pair(e, o);
        for (std::size_t r = 0; r < 4; ++r) {
            while (starts[r] < count && entries_[starts[r]].key < key + rows[r] - 1) ++starts[r];
            for (std::size_t o = starts[r]; o < count && entries_[o].key <= key + rows[r] + 1; ++o) try_pair(e, o);
        }
    }
}

std::span<const VertexPair> SphereSearch::find(ThreadPool& pool)
{
    const std::size_t task_count = (entries_.size() + kEntriesOfTask - 1) / kEntriesOfTask;
    tasks_.resize(std::max(tasks_.size(), task_count));
    share_tasks(pool, static_cast<int>(task_count), [&](int number, int) {
        const std::size_t begin = static_cast<std::size_t>(number) * kEntriesOfTask;
        Task task = std::move(tasks_[static_cast<std::size_t>(number)]);
        task.pairs.clear();
        task.pairs_tested = 0;
        search(begin, std::min(begin + kEntriesOfTask, entries_.size()), task);
        tasks_[static_cast<std::size_t>(number)] = std::move(task);
    });
    pairs_.clear();
    pairs_tested_ = 0;
    for (std::size_t t = 0; t < task_count; ++t) {
        pairs_.insert(pairs_.end(), tasks_[t].pairs.begin(), tasks_[t].pairs.end());
        pairs_tested_ += tasks_[t].pairs_tested;
    }
    return pairs_;
}

}  // namespace nuno
