// A grid laid over a flat mesh.
#include "solver/implicit/mesh_overlay.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace nuno {
namespace {

constexpr double kFlatness = 1e-3;  // largest distance from the plane, of the mesh's size
constexpr double kSpacing = 2;      // of the grid, in sides of the square that a vertex stands for

struct Plane2
{
    glm::dvec3 origin, across, down;
};

std::optional<Plane2> plane_of(const ClothModel& model, const Sheet& sheet)
{
    glm::dvec3 normal(0), low(1e300), high(-1e300);
    double area = 0;
    for (std::uint32_t f = sheet.first_face; f < sheet.first_face + sheet.face_count; ++f) {
        const glm::uvec3 c = model.faces[f];
        const glm::dvec3 a(model.rest_positions[c.x]), b(model.rest_positions[c.y]), d(model.rest_positions[c.z]);
        const glm::dvec3 n = glm::cross(b - a, d - a);
        normal += n;
        area += glm::length(n);
        for (const glm::dvec3& p : {a, b, d}) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    const double size = glm::length(high - low);
    if (!(glm::length(normal) > 0.99 * area)) return std::nullopt;
    normal = glm::normalize(normal);
    const glm::dvec3 axis = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 across = glm::normalize(axis - glm::dot(axis, normal) * normal);
    const Plane2 plane{glm::dvec3(model.rest_positions[sheet.first_vertex]), across, glm::cross(normal, across)};
    for (std::uint32_t v = sheet.first_vertex; v < sheet.first_vertex + sheet.vertex_count; ++v)
        if (std::abs(glm::dot(glm::dvec3(model.rest_positions[v]) - plane.origin, normal)) > kFlatness * size)
            return std::nullopt;
    return plane;
}

// Entries of a symmetric matrix block, of a pair or a tie.
void add_block(Field6& to, std::size_t place, float weight, const float (&block)[6])
{
    for (std::size_t e = 0; e < 6; ++e) to.part[e][place] += weight * block[e];
}

}  // namespace

std::optional<MeshOverlay> MeshOverlay::make(const ClothModel& model, const Sheet& sheet,
                                             const std::vector<std::size_t>& places, std::vector<OverlayPair> pairs)
{
    const std::optional<Plane2> plane = plane_of(model, sheet);
    if (!plane) return std::nullopt;
    std::vector<glm::dvec2> at(sheet.vertex_count);
    glm::dvec2 low(1e300), high(-1e300);
    double area = 0;
    for (std::uint32_t i = 0; i < sheet.vertex_count; ++i) {
        const glm::dvec3 d = glm::dvec3(model.rest_positions[sheet.first_vertex + i]) - plane->origin;
        at[i] = {glm::dot(d, plane->across), glm::dot(d, plane->down)};
        low = glm::min(low, at[i]);
        high = glm::max(high, at[i]);
        area += double(model.areas[sheet.first_vertex + i]);
    }
    // Whole cells, so that the rim of a rectangle is the rim of the grid.
    const double spacing = kSpacing * std::sqrt(area / double(sheet.vertex_count));
    const glm::dvec2 size = high - low, cells = glm::max(glm::round(size / spacing), glm::dvec2(1));
    for (glm::dvec2& p : at) p = (p - low) / size * cells;
    MeshOverlay overlay(int(cells.x) + 1, int(cells.y) + 1);
    overlay.pairs_ = std::move(pairs);
    overlay.blocks_ = Field6(overlay.pairs_.size() + kRowLanes);
    const std::size_t field_size = *std::max_element(places.begin(), places.end()) + 1;
    overlay.place_vertices(at, places, field_size);
    std::vector<glm::dvec2> at_place(field_size);
    for (std::size_t i = 0; i < places.size(); ++i) at_place[places[i]] = at[i];
    overlay.place_pairs(at_place);
    return overlay;
}

MeshOverlay::Shares MeshOverlay::in_order(const std::vector<std::vector<Share>>& lists)
{
    Shares shares;
    shares.first.push_back(0);
    for (const std::vector<Share>& list : lists) {
        shares.entries.insert(shares.entries.end(), list.begin(), list.end());
        shares.first.push_back(static_cast<std::uint32_t>(shares.entries.size()));
    }
    return shares;
}

// Bilinear shares in the four corners of a vertex' cell.
void MeshOverlay::place_vertices(const std::vector<glm::dvec2>& at, const std::vector<std::size_t>& places,
                                 std::size_t size)
{
    const SheetRows& coarse = grids_.first().rows;
    parents_.resize(size, {});
    std::vector<std::vector<Share>> children(std::size_t(coarse.columns * coarse.rows));
    for (std::size_t v = 0; v < places.size(); ++v) {
        const int i = std::clamp(int(at[v].x), 0, coarse.columns - 2), j = std::clamp(int(at[v].y), 0, coarse.rows - 2);
        const double x = std::clamp(at[v].x - i, 0.0, 1.0), y = std::clamp(at[v].y - j, 0.0, 1.0);
        const double weights[4] = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
        for (int k = 0; k < 4; ++k) {
            const int ci = i + k % 2, cj = j + k / 2;
            const auto weight = static_cast<float>(weights[k]);
            parents_[places[v]][std::size_t(k)] = {static_cast<std::uint32_t>(coarse.at(ci, cj)), weight};
            if (weight > 0)
                children[std::size_t(cj * coarse.columns + ci)].push_back(
                    {static_cast<std::uint32_t>(places[v]), weight});
        }
    }
    children_ = in_order(children);
}

// A pair that spans (x, y) cells stretches by x e_x + y e_y where the cloth does by e_x and e_y a cell; with |x| >= |y|
//   |x e_x + y e_y|^2 <= |x y| |e_x +- e_y|^2 + |x| (|x| - |y|) |e_x|^2,
// so links of those shares, a diagonal and a side, are as stiff or stiffer. They are those nearest to its middle.
void MeshOverlay::place_pairs(const std::vector<glm::dvec2>& at_place)
{
    const SheetRows& coarse = grids_.first().rows;
    std::array<std::vector<std::vector<Share>>, 4> lists;
    for (auto& list : lists) list.resize(std::size_t(coarse.columns * coarse.rows));
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const glm::dvec2 a = at_place[pairs_[p].a], b = at_place[pairs_[p].b], middle = (a + b) / 2.0, d = b - a;
        const double x = std::abs(d.x), y = std::abs(d.y);
        const int i = std::clamp(int(middle.x), 0, coarse.columns - 2),
                  j = std::clamp(int(middle.y), 0, coarse.rows - 2);
        const int near_i = std::clamp(int(std::lround(middle.x)), 0, coarse.columns - 1);
        const int near_j = std::clamp(int(std::lround(middle.y)), 0, coarse.rows - 1);
        const auto add = [&](std::size_t link, int ci, int cj, double weight) {
            if (weight > 1e-9)
                lists[link][std::size_t(cj * coarse.columns + ci)].push_back(
                    {static_cast<std::uint32_t>(p), static_cast<float>(weight)});
        };
        if (d.x * d.y >= 0)
            add(2, i, j, x * y);
        else
            add(3, i + 1, j, x * y);
        if (x >= y)
            add(0, i, near_j, x * (x - y));
        else
            add(1, near_i, j, y * (y - x));
    }
    for (std::size_t link = 0; link < 4; ++link) linked_[link] = in_order(lists[link]);
}

void MeshOverlay::coarsen(const Field& mass, std::span<const Tie> ties, const Team& team)
{
    CoarseLevel& level = grids_.first();
    const SheetRows& coarse = level.rows;
    const Range part = team.part(coarse.rows);
    for (int j = part.begin; j < part.end; ++j)
        for (int i = 0; i < coarse.columns; ++i) {
            const std::size_t place = coarse.at(i, j), node = std::size_t(j * coarse.columns + i);
            float resists = 0;
            for (std::uint32_t k = children_.first[node]; k < children_.first[node + 1]; ++k)
                resists += children_.entries[k].weight * mass[children_.entries[k].from];
            for (std::size_t e = 0; e < 6; ++e) level.anchor.part[e][place] = e == 0 || e == 3 || e == 5 ? resists : 0;
            for (std::size_t link = 0; link < 4; ++link) {
                float sum[6] = {};
                for (std::uint32_t k = linked_[link].first[node]; k < linked_[link].first[node + 1]; ++k) {
                    const Share& share = linked_[link].entries[k];
                    for (std::size_t e = 0; e < 6; ++e) sum[e] += share.weight * blocks_.part[e][share.from];
                }
                for (std::size_t e = 0; e < 6; ++e) level.links[link].part[e][place] = sum[e];
            }
        }
    team.wait();
    if (team.leads())
        for (const Tie& tie : ties)
            for (const Share& parent : parents_[tie.place])
                add_block(level.anchor, parent.from, parent.weight, tie.block);
    grids_.prepare(team);
}

void MeshOverlay::correct(const Field& mass, const Field3& t, Field3& z, const SheetRows& rows, const Team& team)
{
    CoarseLevel& level = grids_.first();
    const SheetRows& coarse = level.rows;
    const Range part = team.part(coarse.rows), fine = team.part(rows.rows);
    for (int j = part.begin; j < part.end; ++j)
        for (int i = 0; i < coarse.columns; ++i) {
            const std::size_t node = std::size_t(j * coarse.columns + i), place = coarse.at(i, j);
            float x = 0, y = 0, w = 0;
            for (std::uint32_t k = children_.first[node]; k < children_.first[node + 1]; ++k) {
                const Share& share = children_.entries[k];
                x += share.weight * t.x[share.from];
                y += share.weight * t.y[share.from];
                w += share.weight * t.z[share.from];
            }
            level.r.x[place] = x;
            level.r.y[place] = y;
            level.r.z[place] = w;
        }
    team.wait();
    grids_.solve(team);
    team.wait();
    for (int j = fine.begin; j < fine.end; ++j)
        for (int i = 0; i < rows.columns; ++i) {
            const std::size_t place = rows.at(i, j);
            if (place >= parents_.size() || !(mass[place] > 0)) continue;
            for (const Share& parent : parents_[place]) {
                z.x[place] += parent.weight * level.x.x[parent.from];
                z.y[place] += parent.weight * level.x.y[parent.from];
                z.z[place] += parent.weight * level.x.z[parent.from];
            }
        }
    team.wait();
}

}  // namespace nuno
