// Forces, energy and matrix of a sheet that is no grid.
#include "solver/implicit/mesh_system.h"

#include <cmath>

namespace nuno {
namespace {

constexpr int kMeshColumns = 256;
constexpr float kJacobiWeight = 0.7f;
constexpr float kLeastLengthSq = 1e-24f;

NUNO_WIDE_INLINE RowLanes gather(const Field& a, const std::uint32_t* places)
{
    float values[kRowLanes];
    for (int lane = 0; lane < kRowLanes; ++lane) values[lane] = a[places[lane]];
    return row_load(values);
}

NUNO_WIDE_INLINE RowVec gather(const Field3& a, const std::uint32_t* places)
{
    return {gather(a.x, places), gather(a.y, places), gather(a.z, places)};
}

NUNO_WIDE_INLINE RowVec difference(const SheetMotion& m, std::size_t place, const std::uint32_t* neighbours)
{
    return (gather(m.x, neighbours) - row_load(m.x, place)) + (gather(m.x_low, neighbours) - row_load(m.x_low, place));
}

// As assemble_pairs of a grid, at both ends of each pair; each end counts half of the energy.
NUNO_SIMD_CLONES double assemble_row(const SheetRows& rows, MeshPairs& p, const SheetMotion& at, const Field& mass,
                                     const StageTerms& terms, Field3& force, Field6& inverse_diagonal, int j)
{
    RowLanes energy{};
    const RowLanes beta = row_all(terms.stiffness_damping), rate = row_all(terms.stiffness_damping / terms.tau);
    for (int i = 0; i < rows.width; i += kRowLanes) {
        const std::size_t place = rows.at(i, j);
        const RowLanes own = row_load(mass.get() + place), none{};
        RowVec sum{};
        RowMatrix diagonal{own, none, none, own, none, own};
        for (int slot = 0; slot < p.slots_of_row[std::size_t(j)]; ++slot) {
            const std::size_t entry = std::size_t(slot) * p.size + place;
            const std::uint32_t* neighbours = &p.neighbours[entry];
            const RowVec d = difference(at, place, neighbours);
            const RowLanes axial = row_load(&p.axial[entry]), rest = row_load(&p.rest_length[entry]);
            const RowLanes plate = row_load(&p.plate[entry]);
            const RowLanes length_sq = row_max(row_dot(d, d), row_all(kLeastLengthSq)), length = row_sqrt(length_sq);
            const RowLanes inverse = row_all(1.0f) / length, inverse_sq = inverse * inverse;
            const RowLanes taut = axial * row_min(row_all(1.0f), rest * inverse), stretch = length - rest;
            const RowLanes speed = row_dot(d, gather(at.v, neighbours) - row_load(at.v, place));
            const RowLanes damper = beta * axial * inverse_sq * speed;
            const RowLanes along = taut * inverse_sq + rate * axial * inverse_sq, across = plate + (axial - taut);
            energy += axial * stretch * stretch + plate * length_sq + row_all(terms.tau) * damper * speed;
            sum = sum + (axial * stretch * inverse + plate + damper) * d;
            diagonal = diagonal + row_outer(d, along, row_max(across, -across));
            row_store(&p.along[entry], along);
            row_store(&p.across[entry], across);
        }
        row_store(force, place, sum);
        row_store(inverse_diagonal, place, row_inverse(diagonal, own));
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
            const RowVec d = difference(to, place, neighbours);
            const RowLanes axial = row_load(&p.axial[entry]);
            const RowLanes length_sq = row_max(row_dot(d, d), row_all(kLeastLengthSq));
            const RowLanes stretch = row_sqrt(length_sq) - row_load(&p.rest_length[entry]);
            energy += axial * stretch * stretch + row_load(&p.plate[entry]) * length_sq;
            if (terms.stiffness_damping > 0) {
                const RowVec before = gather(from.x, neighbours) - row_load(from.x, place);
                const RowLanes speed = row_dot(before, gather(to.v, neighbours) - row_load(to.v, place));
                energy += row_all(terms.tau * terms.stiffness_damping) * axial * speed * speed /
                          row_max(row_dot(before, before), row_all(kLeastLengthSq));
            }
        }
    }
    return 0.25 * row_sum(energy);
}

NUNO_WIDE_INLINE RowVec product_at(const MeshPairs& p, const Field& mass, const Field3& x, const Field3& u,
                                   std::size_t place, int slots)
{
    const RowVec at = row_load(x, place), own = row_load(u, place);
    RowVec sum = row_load(mass.get() + place) * own;
    for (int slot = 0; slot < slots; ++slot) {
        const std::size_t entry = std::size_t(slot) * p.size + place;
        const RowVec d = at - gather(x, &p.neighbours[entry]), du = own - gather(u, &p.neighbours[entry]);
        sum = sum + (row_load(&p.along[entry]) * row_dot(d, du)) * d + row_load(&p.across[entry]) * du;
    }
    return sum;
}

NUNO_WIDE_INLINE RowVec where_free(const Field& mass, std::size_t i, const RowVec& v)
{
    const auto free = row_load(mass.get() + i) > RowLanes{};
    return {free ? v.x : RowLanes{}, free ? v.y : RowLanes{}, free ? v.z : RowLanes{}};
}

struct Matrix
{
    const SheetRows& rows;
    const MeshPairs& pairs;
    const Field& mass;
    const Field3& x;
    const Field6& inverse_diagonal;
};

NUNO_SIMD_CLONES double apply_row(const Matrix& a, const Field3& p, Field3& q, int j)
{
    RowLanes sum{};
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        const RowVec y =
            where_free(a.mass, place, product_at(a.pairs, a.mass, a.x, p, place, a.pairs.slots_of_row[std::size_t(j)]));
        row_store(q, place, y);
        sum += row_dot(row_load(p, place), y);
    }
    return row_sum(sum);
}

// to = r - A u, or u + w D^-1 (r - A u).
NUNO_SIMD_CLONES void defect_row(const Matrix& a, const Field3& u, const Field3& r, bool smooths, Field3& to, int j)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        const RowVec defect =
            row_load(r, place) - product_at(a.pairs, a.mass, a.x, u, place, a.pairs.slots_of_row[std::size_t(j)]);
        if (smooths)
            row_store(to, place,
                      row_load(u, place) + row_all(kJacobiWeight) * (row_load(a.inverse_diagonal, place) * defect));
        else
            row_store(to, place, where_free(a.mass, place, defect));
    }
}

NUNO_SIMD_CLONES void scale_row(const Matrix& a, float weight, const Field3& r, Field3& to, int j)
{
    for (int i = 0; i < a.rows.width; i += kRowLanes) {
        const std::size_t place = a.rows.at(i, j);
        row_store(to, place, row_all(weight) * (row_load(a.inverse_diagonal, place) * row_load(r, place)));
    }
}

void copy_in(const SheetRows& rows, const Field& from, Field& to, int j)
{
    std::memcpy(to.get() + rows.at(0, j), from.get() + rows.at(0, j), std::size_t(rows.width) * sizeof(float));
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
    const Range part = team.part(rows_.rows);
    for (int j = part.begin; j < part.end; ++j) {
        row_energy[std::size_t(j)] = assemble_row(rows_, pairs_, at, mass, terms, force, inverse_diagonal_, j);
        copy_in(rows_, mass, mass_, j);
        copy_in(rows_, at.x.x, x_.x, j);
        copy_in(rows_, at.x.y, x_.y, j);
        copy_in(rows_, at.x.z, x_.z, j);
    }
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

void MeshSystem::step_energy(const SheetMotion& from, const SheetMotion& to, const StageTerms& terms,
                             std::span<double> row_energy, const Team& team) const
{
    const Range part = team.part(rows_.rows);
    for (int j = part.begin; j < part.end; ++j)
        row_energy[std::size_t(j)] = energy_of_row(rows_, pairs_, from, to, terms, j);
}

void MeshSystem::apply(const Field3& p, Field3& q, std::span<double> row_dots, const Team& team) const
{
    const Matrix a{rows_, pairs_, mass_, x_, inverse_diagonal_};
    const Range part = team.part(rows_.rows);
    for (int j = part.begin; j < part.end; ++j) row_dots[std::size_t(j)] = apply_row(a, p, q, j);
}

void MeshSystem::precondition(const Field3& r, Field3& z, Field3& t, const Team& team)
{
    const Matrix a{rows_, pairs_, mass_, x_, inverse_diagonal_};
    const Range part = team.part(rows_.rows);
    if (!overlay_) {
        for (int j = part.begin; j < part.end; ++j) scale_row(a, 1.0f, r, z, j);
        return;
    }
    for (int j = part.begin; j < part.end; ++j) scale_row(a, kJacobiWeight, r, t, j);
    team.wait();
    for (int j = part.begin; j < part.end; ++j) defect_row(a, t, r, false, z, j);
    team.wait();
    overlay_->correct(mass_, z, t, rows_, team);
    for (int j = part.begin; j < part.end; ++j) defect_row(a, t, r, true, z, j);
}

}  // namespace nuno
