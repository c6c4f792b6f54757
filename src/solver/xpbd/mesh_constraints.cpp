// Springs and plates of any mesh.
#include "solver/xpbd/mesh_constraints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "solver/xpbd/spring_share.h"

namespace nuno {
namespace {

constexpr std::uint32_t kUnplaced = ~0u;

std::vector<std::uint32_t> breadth_first(const ClothModel& model, const Sheet& sheet,
                                         std::span<const std::size_t> springs)
{
    std::vector<std::vector<std::uint32_t>> neighbours(sheet.vertex_count);
    for (const std::size_t n : springs) {
        const std::uint32_t a = model.springs[n].a - sheet.first_vertex, b = model.springs[n].b - sheet.first_vertex;
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    std::vector<std::uint32_t> places(sheet.vertex_count, kUnplaced), queue;
    for (std::uint32_t start = 0; start < sheet.vertex_count; ++start) {
        if (places[start] != kUnplaced) continue;
        places[start] = static_cast<std::uint32_t>(queue.size());
        queue.push_back(start);
        for (std::size_t k = queue.size() - 1; k < queue.size(); ++k)
            for (const std::uint32_t v : neighbours[queue[k]]) {
                if (places[v] != kUnplaced) continue;
                places[v] = static_cast<std::uint32_t>(queue.size());
                queue.push_back(v);
            }
    }
    return places;
}

float cotangent(glm::vec3 corner, glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 u = a - corner, v = b - corner;
    return glm::dot(u, v) / std::max(glm::length(glm::cross(u, v)), 1e-20f);
}

}  // namespace

MeshConstraints::MeshConstraints(const ClothModel& model, const Sheet& sheet) : model_(model), sheet_(sheet)
{
    for (std::size_t n = 0; n < model.springs.size(); ++n)
        if (model.springs[n].a - sheet.first_vertex < sheet.vertex_count) own_springs_.push_back(n);
    places_ = breadth_first(model, sheet, own_springs_);
    if (sheet.is_grid())
        find_grid_plates();
    else
        find_hinges();
    // Threads first, hinges last, each from one end of the sheet to the other.
    const auto order = [&](std::size_t n) {
        const Spring& s = model.springs[n];
        const std::uint32_t a = place(s.a), b = place(s.b);
        return std::tuple(spring_group(s.kind), std::min(a, b), std::max(a, b));
    };
    std::sort(own_springs_.begin(), own_springs_.end(),
              [&](std::size_t m, std::size_t n) { return order(m) < order(n); });
}

void MeshConstraints::find_hinges()
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;
    for (const glm::uvec3& face : std::span(model_.faces).subspan(sheet_.first_face, sheet_.face_count))
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
            opposite[{low, high}].push_back(face[(k + 2) % 3]);
        }
    // Springs across edges are in the order of their edges (append_mesh_springs).
    auto spring = own_springs_.begin();
    for (const auto& [edge, corners] : opposite) {
        if (corners.size() != 2 || corners[0] == corners[1]) continue;
        while (spring != own_springs_.end() && model_.springs[*spring].kind != SpringKind::hinge) ++spring;
        if (spring == own_springs_.end()) return;
        const std::array<std::uint32_t, 4> v{edge.first, edge.second, corners[0], corners[1]};
        const auto at = [&](int k) { return model_.rest_positions[v[std::size_t(k)]]; };
        const float cot02 = cotangent(at(0), at(1), at(2)), cot03 = cotangent(at(0), at(1), at(3));
        const float cot12 = cotangent(at(1), at(0), at(2)), cot13 = cotangent(at(1), at(0), at(3));
        // M. Bergou et al., A quadratic bending model for inextensible surfaces, 2006; as model/springs.cpp has it.
        const std::array<float, 4> c{cot12 + cot13, cot02 + cot03, -cot02 - cot12, -cot03 - cot13};
        plates_.push_back({v, c, *spring++, c[2] * c[3]});
    }
}

// x(i) - 2 x(i + 1) + x(i + 2) along rows and columns, x(i, j) - x(i + 1, j) - x(i, j + 1) + x(i + 1, j + 1) in cells.
void MeshConstraints::find_grid_plates()
{
    std::vector<std::pair<int, int>> place(sheet_.vertex_count);
    for (int j = 0; j < sheet_.rows; ++j)
        for (int i = 0; i < sheet_.columns; ++i) place[sheet_.grid_vertex(i, j) - sheet_.first_vertex] = {i, j};
    for (const std::size_t n : own_springs_) {
        const Spring& spring = model_.springs[n];
        const auto [i0, j0] = place[spring.a - sheet_.first_vertex];
        const auto [i1, j1] = place[spring.b - sheet_.first_vertex];
        const int columns_on = i1 - i0, rows_on = j1 - j0;
        if (std::abs(columns_on) == 2 || std::abs(rows_on) == 2) {
            // The fourth vertex takes no part.
            const int i = columns_on != 0 ? i0 : i0 > 0 ? i0 - 1 : i0 + 1;
            const int j = rows_on != 0 ? j0 : j0 > 0 ? j0 - 1 : j0 + 1;
            const std::uint32_t middle = sheet_.grid_vertex((i0 + i1) / 2, (j0 + j1) / 2);
            plates_.push_back({{spring.a, middle, spring.b, sheet_.grid_vertex(i, j)}, {1, -2, 1, 0}, n, 1});
        } else if (columns_on * rows_on < 0) {
            plates_.push_back(
                {{spring.a, spring.b, sheet_.grid_vertex(i0, j1), sheet_.grid_vertex(i1, j0)}, {1, 1, -1, -1}, n, 1});
        }
    }
}

void MeshConstraints::choose(std::span<const SpringWeight> weights, std::uint32_t place_count, bool limited)
{
    chosen_springs_.clear();
    chosen_plates_.clear();
    std::vector<std::uint32_t> spring_ends;
    for (const std::size_t n : own_springs_) {
        if (weights[n].axial <= 0) continue;
        const Spring& s = model_.springs[n];
        chosen_springs_.push_back({place(s.a), place(s.b), s.rest_length, weights[n].axial});
        spring_ends.insert(spring_ends.end(), {place(s.a), place(s.b)});
    }
    std::vector<std::uint32_t> plate_ends;
    for (const Plate& plate : plates_) {
        const float stiffness = plate.product != 0 ? -weights[plate.spring].plate / plate.product : 0;
        if (!(stiffness > 0)) continue;
        chosen_plates_.push_back({&plate, stiffness});
        for (const std::uint32_t vertex : plate.vertices) plate_ends.push_back(place(vertex));
    }
    limited_ = limited;
    springs_.emplace(spring_ends, 2, limited ? kLimitedSpringNumberCount : kSpringNumberCount, place_count);
    plate_colours_.emplace(plate_ends, 4, kPlateNumberCount, place_count);
}

void MeshConstraints::set_numbers(float step, int projections, float limit, std::span<const glm::vec4> positions)
{
    for (std::size_t n = 0; n < chosen_springs_.size(); ++n) {
        const ChosenSpring& s = chosen_springs_[n];
        const double inverse_masses = double(positions[s.a].w) + double(positions[s.b].w);
        const double share = spring_share(inverse_masses, double(s.stiffness), double(step), projections);
        springs_->number(n, kRestLength) = s.rest_length;
        springs_->number(n, kSpringShare) = static_cast<float>(share);
        if (!limited_) continue;
        springs_->number(n, kLimitLength) = s.rest_length * (1 + limit);
        springs_->number(n, kHardness) = share > 0 ? static_cast<float>(1 / (inverse_masses * share)) : 0;
    }
    for (std::size_t n = 0; n < chosen_plates_.size(); ++n) {
        const Plate& plate = *chosen_plates_[n].plate;
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double c = double(plate.coefficients[k]);
            sum += c * c * double(positions[place(plate.vertices[k])].w);
            plate_colours_->number(n, static_cast<int>(k)) = plate.coefficients[k];
        }
        const double share = spring_share(sum, double(chosen_plates_[n].stiffness), double(step), projections);
        plate_colours_->number(n, kPlateShare) = static_cast<float>(share);
    }
}

}  // namespace nuno
