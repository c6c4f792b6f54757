// Springs and plates of any mesh.
#include "solver/xpbd/mesh_constraints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

// The springs that a sweep begins with are the ones that its reverse ends with: they would be left without an excess,
// and their neighbours with twice theirs. So those of the first colours take less: a stiff one this share less than it
// would, a soft one, which takes little of its excess anyway, the same. Not so in the colours of a mesh that is no grid,
// where a spring may be alone. Measured (bench/hang_bench, mesh): largest strain 6.1 and 5.0 % at 128 and 256 a side
// without this, 2.9 and 3.9 % with it.
double share_less(std::size_t colour)
{
    double less = 0.5;
    for (; colour > 0; --colour) less *= 0.6;
    return less;
}

}  // namespace

MeshConstraints::MeshConstraints(const ClothModel& model, const Sheet& sheet) : model_(model), sheet_(sheet)
{
    for (std::size_t n = 0; n < model.springs.size(); ++n)
        if (model.springs[n].a - sheet.first_vertex < sheet.vertex_count) own_springs_.push_back(n);
    places_ = breadth_first(model, sheet, own_springs_);
    if (sheet.is_grid()) {
        find_grid_plates();
        find_grid_colours();
    } else {
        find_hinges();
    }
    // A mesh: threads first, hinges last, each from one end of the sheet to the other.
    const auto order = [&](std::size_t n) {
        const Spring& s = model.springs[n];
        const std::uint32_t a = place(s.a), b = place(s.b);
        const std::size_t rank = sheet.is_grid() ? least_colours_[n] : static_cast<std::size_t>(spring_group(s.kind));
        return std::tuple(rank, std::min(a, b), std::max(a, b));
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

// Column and row of each vertex of the sheet.
std::vector<std::pair<int, int>> MeshConstraints::grid_places() const
{
    std::vector<std::pair<int, int>> places(sheet_.vertex_count);
    for (int j = 0; j < sheet_.rows; ++j)
        for (int i = 0; i < sheet_.columns; ++i) places[sheet_.grid_vertex(i, j) - sheet_.first_vertex] = {i, j};
    return places;
}

// Twelve colours, the fewest that there can be, in an order in which colours that follow each other hang together in
// fours only, so that a device can take them in one dispatch (solver/xpbd/spring_quads.h): the sides and diagonals of
// cells whose column and row are even, then those of cells where both are odd, the diagonals of the other cells, and
// springs over two cells, which are cells twice as large.
void MeshConstraints::find_grid_colours()
{
    const std::vector<std::pair<int, int>> places = grid_places();
    least_colours_.assign(model_.springs.size(), 0);
    for (const std::size_t n : own_springs_) {
        const Spring& spring = model_.springs[n];
        const auto [i0, j0] = places[spring.a - sheet_.first_vertex];
        const auto [i1, j1] = places[spring.b - sheet_.first_vertex];
        const int i = std::min(i0, i1), j = std::min(j0, j1), along = j0 == j1 ? i : j, across = j0 == j1 ? 0 : 1;
        int colour = 0;
        if (i0 != i1 && j0 != j1)
            colour = i % 2 == j % 2 ? 3 * (i % 2) + 2 : 6 + i % 2;
        else if (std::abs(i1 - i0) + std::abs(j1 - j0) == 1)
            colour = 3 * (along % 2) + across;
        else
            colour = 8 + 2 * (along / 2 % 2) + across;
        least_colours_[n] = static_cast<std::size_t>(colour);
    }
}

// x(i) - 2 x(i + 1) + x(i + 2) along rows and columns, x(i, j) - x(i + 1, j) - x(i, j + 1) + x(i + 1, j + 1) in cells.
void MeshConstraints::find_grid_plates()
{
    const std::vector<std::pair<int, int>> places = grid_places();
    for (const std::size_t n : own_springs_) {
        const Spring& spring = model_.springs[n];
        const auto [i0, j0] = places[spring.a - sheet_.first_vertex];
        const auto [i1, j1] = places[spring.b - sheet_.first_vertex];
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

void MeshConstraints::choose(std::span<const SpringWeight> weights, std::uint32_t place_count, Layout layout)
{
    chosen_springs_.clear();
    chosen_plates_.clear();
    std::vector<std::uint32_t> spring_ends;
    std::vector<std::size_t> least_colours;
    for (const std::size_t n : own_springs_) {
        if (weights[n].axial <= 0) continue;
        const Spring& s = model_.springs[n];
        chosen_springs_.push_back({place(s.a), place(s.b), s.rest_length, weights[n].axial});
        spring_ends.insert(spring_ends.end(), {place(s.a), place(s.b)});
        if (sheet_.is_grid()) least_colours.push_back(least_colours_[n]);
    }
    std::vector<std::uint32_t> plate_ends;
    for (const Plate& plate : plates_) {
        const float stiffness = plate.product != 0 ? -weights[plate.spring].plate / plate.product : 0;
        if (!(stiffness > 0)) continue;
        chosen_plates_.push_back({&plate, stiffness});
        for (const std::uint32_t vertex : plate.vertices) plate_ends.push_back(place(vertex));
    }
    limited_ = layout == Layout::limited_springs;
    in_springs_.resize(chosen_springs_.size());
    std::iota(in_springs_.begin(), in_springs_.end(), std::size_t(0));
    stars_.reset();
    if (layout == Layout::stars) {
        put_into_stars(spring_ends, place_count);
        least_colours.clear();
    }
    springs_.emplace(spring_ends, 2, limited_ ? kLimitedSpringNumberCount : kSpringNumberCount, place_count,
                     least_colours);
    plate_colours_.emplace(plate_ends, 4, kPlateNumberCount, place_count);
}

// Leaves those that are in no star.
void MeshConstraints::put_into_stars(std::vector<std::uint32_t>& spring_ends, std::uint32_t place_count)
{
    std::vector<glm::uvec3> faces;
    for (const glm::uvec3& face : std::span(model_.faces).subspan(sheet_.first_face, sheet_.face_count))
        faces.emplace_back(place(face.x), place(face.y), place(face.z));
    const Stars found = find_stars(spring_ends, faces, place_count);
    stars_.emplace(found.stars, chosen_springs_.size(), place_count);
    std::fill(in_springs_.begin(), in_springs_.end(), Star::kNoSpring);
    spring_ends.clear();
    for (std::size_t k = 0; k < found.left_over.size(); ++k) {
        const std::size_t n = found.left_over[k];
        in_springs_[n] = k;
        spring_ends.insert(spring_ends.end(), {chosen_springs_[n].a, chosen_springs_[n].b});
    }
}

void MeshConstraints::set_numbers(float step, int projections, float limit, std::span<const glm::vec4> positions)
{
    for (std::size_t n = 0; n < chosen_springs_.size(); ++n) {
        const ChosenSpring& s = chosen_springs_[n];
        const double inverse_masses = double(positions[s.a].w) + double(positions[s.b].w);
        const double share = spring_share(inverse_masses, double(s.stiffness), double(step), projections);
        const double taken = inverse_masses * share;  // of its excess, by one projection
        if (in_springs_[n] == Star::kNoSpring) {
            const double less = share_less(stars_->colour(n));
            stars_->set_numbers(n, s.rest_length, static_cast<float>((1 - less * taken) * share));
            continue;
        }
        const double less = sheet_.is_grid() && !stars_ ? share_less(springs_->colour(n)) : 0;
        springs_->number(in_springs_[n], kRestLength) = s.rest_length;
        springs_->number(in_springs_[n], kSpringShare) = static_cast<float>((1 - less * taken) * share);
        if (!limited_) continue;
        springs_->number(n, kLimitLength) = s.rest_length * (1 + limit);
        springs_->number(n, kHardness) = taken > 0 ? static_cast<float>(1 / ((1 - less * taken) * taken)) : 0;
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
