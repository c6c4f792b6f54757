// Forces, energy and matrix of a sheet that is no grid.
#include "solver/implicit/mesh_system.h"

#include <algorithm>

#include "solver/implicit/row_products.h"
#include "solver/implicit/spring_pairs.h"

namespace nuno {
namespace {

constexpr int kMeshColumns = 256;

NUNO_WIDE_INLINE RowLanes gather(const Field& a, const std::uint32_t* places)
{
    RowLanes values;
    for (int lane = 0; lane < kRowLanes; ++lane) values.lanes[lane] = a[places[lane]];
    return values;
}

NUNO_WIDE_INLINE RowVec gather(const Field3& a, const std::uint32_t* places)
{
    return {gather(a.x, places), gather(a.y, places), gather(a.z, places)};
}

NUNO_WIDE_INLINE RowVec difference(const SheetMotion& m, std::size_t place, const std::uint32_t* neighbours)
{
    return (gather(m.x, neighbours) - row_load(m.x, place)) + (gather(m.x_low, neighbours) - row_load(m.x_low, place));
}

// What assemble_row reads and fills beside the pairs.
struct MeshTarget
{
    const Field& mass;
    Field3& force;
    Field6& inverse_diagonal;
};

NUNO_WIDE_INLINE PairSprings springs_at(const MeshPairs& p, std::size_t entry)
{
    return {row_load(p.axial, entry), row_load(p.rest_length, entry), row_load(p.plate, entry)};
}

// Pairs are met at both ends; each counts half of their energy.
NUNO_SIMD_CLONES double assemble_row(const SheetRows& rows, MeshPairs& p, const SheetMotion& at, const MeshTarget& to,
                                     const StageTerms& terms, int j)
{
    RowLanes energy{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        const RowLanes own = row_load(to.mass, place);
        RowVec sum{};
        RowMatrix diagonal = row_diagonal(own);
        for (int slot = 0; slot < p.slots_of_row[std::size_t(j)]; ++slot) {
            const std::size_t entry = std::size_t(slot) * p.size + place;
            const std::uint32_t* neighbours = &p.neighbours[entry];
            const auto change = [&](const Field3& of)
                                    NUNO_WIDE_LAMBDA { return gather(of, neighbours) - row_load(of, place); };
            const RowVec d = difference(at, place, neighbours);
            const PairMotion motion{d, terms.stiffness_damping > 0 ? change(at.v) : RowVec{},
                                    terms.tried ? change(*terms.tried) : RowVec{}};
            const PairTerms pair = pair_terms(springs_at(p, entry), motion, terms);
            energy = energy + pair.energy;
            sum = sum + pair.pull * d;
            diagonal = diagonal + row_outer(d, pair.along, max_real(pair.across, -pair.across));
            row_store(p.along, entry, pair.along);
            row_store(p.across, entry, pair.across);
        }
        row_store(to.force, place, sum);
        row_store(to.inverse_diagonal, place, row_inverse(diagonal, own));
    }
    return 0.25 * row_sum(energy);
}

NUNO_SIMD_CLONES double energy_of_row(const SheetRows& rows, const MeshPairs& p, const SheetMotion& from,
                                      const SheetMotion& to, const StageTerms& terms, int j)
{
    RowLanes energy{};
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        for (int slot = 0; slot < p.slots_of_row[std::size_t(j)]; ++slot) {
            const std::size_t entry = std::size_t(slot) * p.size + place;
            const std::uint32_t* neighbours = &p.neighbours[entry];
            RowVec before{}, u{};
            if (terms.stiffness_damping > 0) {
                before = gather(from.x, neighbours) - row_load(from.x, place);
                u = gather(to.v, neighbours) - row_load(to.v, place);
            }
            energy = energy + pair_energy(springs_at(p, entry), difference(to, place, neighbours), before, u, terms);
        }
    }
    return 0.25 * row_sum(energy);
}

struct Matrix
{
    const SheetRows& rows;
    const MeshPairs& pairs;
    const Field& mass;
    const Field3& x;
    const Field6& inverse_diagonal;
};

NUNO_WIDE_INLINE RowVec product_at(const Matrix& a, const Field3& u, std::size_t place, int j)
{
    const MeshPairs& p = a.pairs;
    const RowVec at = row_load(a.x, place), own = row_load(u, place);
    RowVec sum = row_load(a.mass, place) * own;
    for (int slot = 0; slot < p.slots_of_row[std::size_t(j)]; ++slot) {
        const std::size_t entry = std::size_t(slot) * p.size + place;
        const RowVec d = at - gather(a.x, &p.neighbours[entry]), du = own - gather(u, &p.neighbours[entry]);
        sum = sum + (row_load(p.along, entry) * row_dot(d, du)) * d + row_load(p.across, entry) * du;
    }
    return sum;
}

NUNO_SIMD_CLONES double mesh_apply(const Matrix& a, const Field3& p, Field3& q, int j)
{
    return apply_row(a.rows, a.mass, p, q, j,
                     [&](std::size_t place) NUNO_WIDE_LAMBDA { return product_at(a, p, place, j); });
}

NUNO_SIMD_CLONES void mesh_residual(const Matrix& a, const Field3& u, const Field3& r, Field3& to, int j)
{
    defect_row(a.rows, a.mass, r, to, j,
               [&](std::size_t place) NUNO_WIDE_LAMBDA { return product_at(a, u, place, j); });
}

NUNO_SIMD_CLONES double mesh_smooth(const Matrix& a, const Field3& u, const Field3& r, Field3& to, int j)
{
    return smooth_row(a.rows, a.inverse_diagonal, u, r, to, j,
                      [&](std::size_t place) NUNO_WIDE_LAMBDA { return product_at(a, u, place, j); });
}

// to = weight D^-1 r; returns r . to.
NUNO_SIMD_CLONES double scale_row(const Matrix& a, float weight, const Field3& r, Field3& to, int j)
{
    RowLanes sum{};
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        const RowVec goal = row_load(r, place);
        const RowVec y = RowLanes(weight) * (row_load(a.inverse_diagonal, place) * goal);
        row_store(to, place, y);
        sum = sum + row_dot(goal, y);
    }
    return row_sum(sum);
}

void copy_in(const SheetRows& rows, const Field& from, Field& to, int j)
{
    std::copy_n(&from[rows.at(0, j)], rows.width, &to[rows.at(0, j)]);
}

// The block of a pair, without what would make it indefinite.
void block_of(const MeshPairs& p, const Field3& x, std::uint32_t a, std::uint32_t b, std::size_t entry,
              float (&block)[6])
{
    const float s = p.along[entry], t = std::max(p.across[entry], 0.0f);
    const float dx = x.x[a] - x.x[b], dy = x.y[a] - x.y[b], dz = x.z[a] - x.z[b];
    const float values[6] = {s * dx * dx + t, s * dx * dy, s * dx * dz, s * dy * dy + t, s * dy * dz, s * dz * dz + t};
    std::copy(values, values + 6, block);
}

}  // namespace

MeshSystem::MeshSystem(const ClothModel& model, const Sheet& sheet)
    : first_vertex_(sheet.first_vertex),
      rows_(std::min<int>(kMeshColumns, int(sheet.vertex_count)),
            int((sheet.vertex_count + kMeshColumns - 1) / kMeshColumns)),
      mass_(rows_.size()),
      x_(rows_.size()),
      inverse_diagonal_(rows_.size())
{
    const std::uint32_t end = sheet.first_vertex + sheet.vertex_count;
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> around(sheet.vertex_count);
    for (std::uint32_t s = 0; s < model.springs.size(); ++s) {
        const Spring& spring = model.springs[s];
        if (spring.a < first_vertex_ || spring.a >= end) continue;
        around[spring.a - first_vertex_].push_back({spring.b, s});
        around[spring.b - first_vertex_].push_back({spring.a, s});
    }
    std::size_t most = 0;
    pairs_.slots_of_row.resize(std::size_t(rows_.rows));
    for (std::uint32_t i = 0; i < sheet.vertex_count; ++i) {
        int& slots = pairs_.slots_of_row[i / kMeshColumns];
        slots = std::max(slots, int(around[i].size()));
        most = std::max(most, around[i].size());
    }
    pairs_.size = rows_.size();
    pairs_.neighbours.resize(most * pairs_.size);
    for (std::size_t i = 0; i < pairs_.neighbours.size(); ++i)
        pairs_.neighbours[i] = static_cast<std::uint32_t>(i % pairs_.size);
    pairs_.springs.assign(pairs_.neighbours.size(), SpringTable::kNoSpring);
    for (auto* values : {&pairs_.axial, &pairs_.rest_length, &pairs_.plate, &pairs_.along, &pairs_.across})
        values->assign(pairs_.neighbours.size(), 0.0f);

    std::vector<std::size_t> places;
    std::vector<OverlayPair> pairs;
    for (std::uint32_t i = 0; i < sheet.vertex_count; ++i) {
        places.push_back(place(first_vertex_ + i));
        for (std::size_t slot = 0; slot < around[i].size(); ++slot) {
            const auto [other, spring] = around[i][slot];
            const std::size_t entry = slot * pairs_.size + places.back();
            pairs_.neighbours[entry] = static_cast<std::uint32_t>(place(other));
            pairs_.springs[entry] = spring;
            if (other > first_vertex_ + i)
                pairs.push_back({static_cast<std::uint32_t>(places.back()), pairs_.neighbours[entry], entry});
        }
    }
    overlay_ = MeshOverlay::make(model, sheet, places, std::move(pairs));
}

std::size_t MeshSystem::place(std::uint32_t vertex) const
{
    const std::uint32_t i = vertex - first_vertex_;
    return rows_.at(int(i % kMeshColumns), int(i / kMeshColumns));
}

void MeshSystem::set_springs(const ClothModel& model, std::span<const SpringWeight> weights)
{
    for (std::size_t entry = 0; entry < pairs_.springs.size(); ++entry) {
        const std::uint32_t s = pairs_.springs[entry];
        if (s == SpringTable::kNoSpring) continue;
        pairs_.axial[entry] = weights[s].axial;
        pairs_.rest_length[entry] = model.springs[s].rest_length;
        pairs_.plate[entry] = weights[s].plate;
    }
}

void MeshSystem::assemble(const SheetMotion& at, const Field& mass, const StageTerms& terms, Field3& force,
                          std::span<double> row_energy, const Team& team)
{
    for_rows(rows_, team, [&](int j) {
        row_energy[std::size_t(j)] = assemble_row(rows_, pairs_, at, {mass, force, inverse_diagonal_}, terms, j);
        copy_in(rows_, mass, mass_, j);
        copy_in(rows_, at.x.x, x_.x, j);
        copy_in(rows_, at.x.y, x_.y, j);
        copy_in(rows_, at.x.z, x_.z, j);
    });
    team.wait();
    if (!overlay_) return;
    const std::vector<OverlayPair>& pairs = overlay_->pairs();
    const Range own = team.part(int(pairs.size()));
    for (auto k = std::size_t(own.begin); k < std::size_t(own.end); ++k) {
        float block[6] = {};
        if (mass_[pairs[k].a] > 0 && mass_[pairs[k].b] > 0)
            block_of(pairs_, x_, pairs[k].a, pairs[k].b, pairs[k].entry, block);
        for (std::size_t e = 0; e < 6; ++e) overlay_->blocks().part[e][k] = block[e];
    }
    std::vector<MeshOverlay::Tie> ties;
    if (team.leads())
        for (const OverlayPair& pair : pairs) {
            if ((mass_[pair.a] > 0) == (mass_[pair.b] > 0)) continue;
            MeshOverlay::Tie tie{mass_[pair.a] > 0 ? pair.a : pair.b, {}};
            block_of(pairs_, x_, pair.a, pair.b, pair.entry, tie.block);
            ties.push_back(tie);
        }
    team.wait();
    overlay_->coarsen(mass_, ties, team);
}

double MeshSystem::step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms, int row) const
{
    return energy_of_row(rows_, pairs_, from, to, terms, row);
}

double MeshSystem::apply(const Field3& p, Field3& q, int row) const
{
    return mesh_apply({rows_, pairs_, mass_, x_, inverse_diagonal_}, p, q, row);
}

void MeshSystem::subtract(const Field3& p, Field3& r, int row) const
{
    mesh_residual({rows_, pairs_, mass_, x_, inverse_diagonal_}, p, r, r, row);
}

void MeshSystem::precondition(const Field3& r, Field3& z, Field3& t, std::span<double> row_dots, const Team& team)
{
    const Matrix a{rows_, pairs_, mass_, x_, inverse_diagonal_};
    if (!overlay_) {
        for_rows(rows_, team, [&](int j) { row_dots[std::size_t(j)] = scale_row(a, 1.0f, r, z, j); });
        return;
    }
    for_rows(rows_, team, [&](int j) { scale_row(a, kJacobiWeight, r, t, j); });
    team.wait();
    for_rows(rows_, team, [&](int j) { mesh_residual(a, t, r, z, j); });
    team.wait();
    overlay_->correct(mass_, z, t, rows_, team);
    for_rows(rows_, team, [&](int j) { row_dots[std::size_t(j)] = mesh_smooth(a, t, r, z, j); });
}

}  // namespace nuno
