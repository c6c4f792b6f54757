// The same place of a sheet on two grids.
#include "study/grid_poses.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

struct Grid
{
    const SheetSource& sheet;
    const std::vector<glm::vec3>& positions;
    std::uint32_t first_vertex;

    glm::dvec3 at(int i, int j) const
    {
        const auto place = static_cast<std::uint32_t>(j * sheet.columns + i);
        return glm::dvec3(positions[first_vertex + (sheet.grid_order.empty() ? place : sheet.grid_order[place])]);
    }
    // u, v from 0 to 1 across and down.
    glm::dvec3 at(double u, double v) const
    {
        const double x = u * (sheet.columns - 1), y = v * (sheet.rows - 1);
        const int i = std::min(static_cast<int>(x), sheet.columns - 2),
                  j = std::min(static_cast<int>(y), sheet.rows - 2);
        const double p = x - i, q = y - j;
        return (1 - q) * ((1 - p) * at(i, j) + p * at(i + 1, j)) + q * ((1 - p) * at(i, j + 1) + p * at(i + 1, j + 1));
    }
};

double square_sum(const Grid& coarse, const Grid& fine)
{
    double sum = 0;
    for (int j = 0; j < coarse.sheet.rows; ++j)
        for (int i = 0; i < coarse.sheet.columns; ++i) {
            const double u = double(i) / (coarse.sheet.columns - 1), v = double(j) / (coarse.sheet.rows - 1);
            const glm::dvec3 apart = coarse.at(i, j) - fine.at(u, v);
            sum += glm::dot(apart, apart);
        }
    return sum;
}

}  // namespace

double rms_of_grids(std::span<const SheetSource> coarse_sheets, const Trajectory& coarse,
                    std::span<const SheetSource> fine_sheets, const Trajectory& fine, int frames)
{
    assert(coarse_sheets.size() == fine_sheets.size() && coarse.frames() >= frames && fine.frames() >= frames);
    double sum = 0, count = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        std::uint32_t coarse_first = 0, fine_first = 0;
        for (std::size_t s = 0; s < coarse_sheets.size(); ++s) {
            const SheetSource &a = coarse_sheets[s], &b = fine_sheets[s];
            if (a.columns > 0) {
                sum += square_sum({a, coarse.positions[std::size_t(frame)], coarse_first},
                                  {b, fine.positions[std::size_t(frame)], fine_first});
                count += double(a.columns) * a.rows;
            }
            coarse_first += static_cast<std::uint32_t>(a.mesh.positions.size());
            fine_first += static_cast<std::uint32_t>(b.mesh.positions.size());
        }
    }
    assert(count > 0);
    return std::sqrt(sum / count);
}

}  // namespace nuno
