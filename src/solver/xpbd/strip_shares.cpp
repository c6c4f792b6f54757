// Shares of springs in strips.
#include "solver/xpbd/strip_shares.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/xpbd/spring_share.h"

namespace nuno {
namespace {

// Rest lengths and stiffness that differ by less than this share are rounding of the mesh.
constexpr float kAlike = 1e-3f;

bool alike(float a, float b) { return std::abs(a - b) <= kAlike * std::max(std::abs(a), std::abs(b)); }

// Which spring of a strip a spring of the model is; kStripSpringCount: one of another sheet.
struct SpringPlace
{
    int spring;
    bool on_rim;
};

class SpringPlaces
{
  public:
    SpringPlaces(const Sheet& sheet, const StripLayout& layout)
        : sheet_(sheet), layout_(layout), place_(sheet.vertex_count)
    {
        for (int j = 0; j < layout.rows; ++j)
            for (int i = 0; i < layout.columns; ++i) place_[layout.vertex(sheet, i, j) - sheet.first_vertex] = {i, j};
    }

    SpringPlace of(const Spring& spring) const
    {
        if (spring.a - sheet_.first_vertex >= sheet_.vertex_count) return {kStripSpringCount, false};
        const auto [i0, j0] = place_[spring.a - sheet_.first_vertex];
        const auto [i1, j1] = place_[spring.b - sheet_.first_vertex];
        int di = i1 - i0, dj = j1 - j0;
        if (dj < 0 || (dj == 0 && di < 0)) di = -di, dj = -dj;
        const bool on_rim =
            (dj == 0 && (j0 == 0 || j0 == layout_.rows - 1)) || (di == 0 && (i0 == 0 || i0 == layout_.columns - 1));
        const auto reaches = [&](const StripReach& r) {
            return di == r.second_column - r.first_column && dj == r.second_row;
        };
        const auto found = std::find_if(kStripReach.begin(), kStripReach.end(), reaches);
        return {static_cast<int>(found - kStripReach.begin()), on_rim};
    }

  private:
    const Sheet& sheet_;
    const StripLayout& layout_;
    std::vector<std::pair<int, int>> place_;  // column and row of each vertex
};

// Of a plate that a vertex owns: columns and rows from it to the points, the last point furthest.
struct PlatePoints
{
    int count;
    std::array<int, 4> column, row;
    std::array<double, 4> coefficient;
};
constexpr std::array<PlatePoints, kStripPlateCount> kPlatePoints{{{3, {0, 1, 2}, {0, 0, 0}, {1, -2, 1}},
                                                                  {3, {0, 0, 0}, {0, 1, 2}, {1, -2, 1}},
                                                                  {4, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, -1, -1, 1}}}};

struct ShareMaker
{
    const StripLayout& layout;
    const float* mobility;
    double inverse_mass, h;
    int sweeps;

    // Of a spring or plate whose points have these mobilities together, projected `passes` times a sweep.
    double share(double mobilities, double stiffness, int passes = 1) const
    {
        return spring_share(mobilities * inverse_mass, stiffness, h, passes * sweeps) * inverse_mass;
    }

    // Fills the shares of vector c and tells whether all lanes have the plain one.
    bool fill(float* lanes, const StripStiffness& stiffness, int spring, int c, int j) const
    {
        const StripReach& reach = kStripReach[static_cast<std::size_t>(spring)];
        const int j1 = j + reach.second_row;
        bool plain = true;
        for (int strip = 0; strip < kStrips; ++strip) {
            const int i0 = strip * layout.width + c + reach.first_column;
            const int i1 = strip * layout.width + c + reach.second_column;
            const int last = std::max(i0, i1);
            // Padding is a cloth of its own, at rest: its springs may be projected like others.
            if (std::min(i0, i1) >= layout.columns && last < kStrips * layout.width) continue;
            if (last >= layout.columns || j1 >= layout.rows) {
                plain = false;
                continue;
            }
            const bool across = reach.second_row == 0, down = reach.first_column == reach.second_column;
            const bool rim =
                (across && (j == 0 || j == layout.rows - 1)) || (down && (i0 == 0 || i0 == layout.columns - 1));
            const float k = rim ? stiffness.rim : stiffness.inside;
            const float w0 = mobility[layout.lane(i0, j)], w1 = mobility[layout.lane(i1, j1)];
            const double s = share(double(w0) + double(w1), double(k), kStripPasses[static_cast<std::size_t>(spring)]);
            lanes[strip] = static_cast<float>(s * double(w0));
            lanes[kStrips + strip] = static_cast<float>(s * double(w1));
            lanes[2 * kStrips + strip] = static_cast<float>(s > 0 ? 1 / (s * (double(w0) + double(w1))) : 0);
            plain = plain && w0 == 1 && w1 == 1 && k == stiffness.inside;
        }
        return plain;
    }

    // Shares of the plates of row j: c * points * kStrips + point * kStrips + strip.
    void fill_plates(float* lanes, const StripPlateStiffness& stiffness, int plate, int j) const
    {
        const PlatePoints points = kPlatePoints[static_cast<std::size_t>(plate)];
        const auto count = static_cast<std::size_t>(points.count);
        for (int i = 0; i < layout.columns; ++i) {
            if (i + points.column[count - 1] >= layout.columns || j + points.row[count - 1] >= layout.rows) continue;
            const bool rim = (plate == kPlateAcross && (j == 0 || j == layout.rows - 1)) ||
                             (plate == kPlateDown && (i == 0 || i == layout.columns - 1));
            std::array<double, 4> mobilities{};
            double sum = 0;
            for (std::size_t p = 0; p < count; ++p) {
                mobilities[p] = double(mobility[layout.lane(i + points.column[p], j + points.row[p])]);
                sum += points.coefficient[p] * points.coefficient[p] * mobilities[p];
            }
            const double s = share(sum, double(rim ? stiffness.rim : stiffness.inside));
            float* const at = lanes + i % layout.width * points.count * kStrips + i / layout.width;
            for (std::size_t p = 0; p < count; ++p)
                at[p * kStrips] = static_cast<float>(s * points.coefficient[p] * mobilities[p]);
        }
    }
};

}  // namespace

StripStiffnesses strip_stiffnesses(const ClothModel& model, const Sheet& sheet, const StripLayout& layout,
                                   std::span<const SpringWeight> weights)
{
    const SpringPlaces places(sheet, layout);
    StripStiffnesses stiffnesses{};
    for (std::size_t n = 0; n < model.springs.size(); ++n) {
        const SpringPlace at = places.of(model.springs[n]);
        if (at.spring == kStripSpringCount) continue;
        StripStiffness& terms = stiffnesses.springs[std::size_t(at.spring)];
        terms.rest_length = model.springs[n].rest_length;
        (at.on_rim ? terms.rim : terms.inside) = weights[n].axial;
        // The last of a plate's pairs is in no other of its kind: b (x0 - 2 x1 + x2)^2 has -b (x0 - x2)^2, and
        // b (x0 - x1 - x2 + x3)^2 has -b (x1 - x2)^2.
        const auto plate = at.spring == kTwoAcross  ? kPlateAcross
                           : at.spring == kTwoDown  ? kPlateDown
                           : at.spring == kDownLeft ? kPlateTwist
                                                    : kStripPlateCount;
        if (plate == kStripPlateCount) continue;
        StripPlateStiffness& stiffness = stiffnesses.plates[std::size_t(plate)];
        (at.on_rim ? stiffness.rim : stiffness.inside) = -weights[n].plate;
    }
    return stiffnesses;
}

bool suits_strips(const ClothModel& model, const Sheet& sheet)
{
    const StripLayout layout = make_strip_layout(sheet.columns, sheet.rows);
    const SpringPlaces places(sheet, layout);
    std::array<float, kStripSpringCount> rest_lengths{};
    for (const Spring& spring : model.springs) {
        const int kind = places.of(spring).spring;
        if (kind == kStripSpringCount) continue;
        float& rest_length = rest_lengths[std::size_t(kind)];
        if (rest_length == 0) rest_length = spring.rest_length;
        if (!alike(rest_length, spring.rest_length)) return false;
    }
    return true;
}

void StripShareTables::make(const StripLayout& layout, const float* mobility, float inverse_mass,
                            const StripStiffnesses& stiffnesses, float h, int sweeps, float limit)
{
    const ShareMaker maker{layout, mobility, double(inverse_mass), double(h), sweeps};
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const StripStiffness& s = stiffnesses.springs[k];
        const float share = static_cast<float>(maker.share(2, double(s.inside), kStripPasses[k]));
        terms[k].present = s.inside > 0 || s.rim > 0;
        terms[k].rest_length.fill(s.rest_length);
        terms[k].share.fill(share);
        terms[k].share_length.fill(share * s.rest_length);
        terms[k].lightness.fill(share * static_cast<float>(kStripPasses[k]));
        terms[k].limit_length.fill(s.rest_length * (1 + limit));
        terms[k].hardness.fill(share > 0 ? 0.5f / share : 0);
    }
    for (std::size_t k = 0; k < has_plate.size(); ++k)
        has_plate[k] = stiffnesses.plates[k].inside > 0 || stiffnesses.plates[k].rim > 0;
    tables_.clear();
    shares_.clear();
    rows.clear();

    // Rows alike in the masses of the three rows that their springs join have the same shares.
    const int row_lanes = layout.width * kStrips;
    std::map<std::vector<float>, const StripRowShares*> known;
    for (int j = 0; j < layout.rows; ++j) {
        std::vector<float> key(mobility + std::ptrdiff_t(j) * row_lanes,
                               mobility + std::ptrdiff_t(std::min(j + 3, layout.rows)) * row_lanes);
        key.push_back(j == 0 || j == layout.rows - 1);
        const StripRowShares*& found = known[std::move(key)];
        if (!found) {
            StripRowShares& made = shares_.emplace_back();
            for (int k = 0; k < kStripPlateCount; ++k) {
                made.plates[std::size_t(k)] = nullptr;
                if (!has_plate[std::size_t(k)]) continue;
                StripLanes& table = tables_.emplace_back(static_cast<std::size_t>(4 * row_lanes), 0.0f);
                maker.fill_plates(table.data(), stiffnesses.plates[std::size_t(k)], k, j);
                made.plates[std::size_t(k)] = table.data();
            }
            for (int k = 0; k < kStripSpringCount; ++k) {
                StripLanes& table =
                    tables_.emplace_back(static_cast<std::size_t>(kStripShareFloats * layout.width), 0.0f);
                std::vector<bool> plain;
                for (int c = 0; c < layout.width; ++c)
                    plain.push_back(
                        maker.fill(table.data() + c * kStripShareFloats, stiffnesses.springs[std::size_t(k)], k, c, j));
                const auto begin = std::find(plain.begin(), plain.end(), true);
                const auto end = std::find(begin, plain.end(), false);
                made.springs[std::size_t(k)] = {table.data(), int(begin - plain.begin()), int(end - plain.begin())};
            }
            found = &made;
        }
        rows.push_back(found);
    }
}

}  // namespace nuno
