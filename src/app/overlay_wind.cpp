// The wind around the cloth as arrows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/overlay_heat.h"
#include "app/overlay_marks.h"
#include "model/wind_field.h"
#include "solver/base/cloth_solver.h"

namespace nuno {
namespace {

constexpr glm::vec3 kSky{0.05f, 0.42f, 0.72f};
constexpr int kPlacesAlong = 6;    // about, along the longest side of the cloth
constexpr float kRoom = 0.75f;     // of the space between two places that lies around the cloth
constexpr float kLongest = 0.85f;  // of that space that the longest arrow takes
constexpr float kHead = 0.35f;     // of an arrow

struct Lattice
{
    glm::ivec3 first, last;  // in whole spaces
    float space;             // [m], one of 1, 2, 5, 10 .. times a power of ten: so it stays while the cloth moves
};

Lattice around(std::span<const glm::vec4> positions)
{
    glm::vec3 low(positions.front()), high = low;
    for (const glm::vec4& p : positions) {
        low = glm::min(low, glm::vec3(p));
        high = glm::max(high, glm::vec3(p));
    }
    const glm::vec3 size = high - low;
    const double side = double(std::max({size.x, size.y, size.z}));
    const auto space = static_cast<float>(round_top(side / kPlacesAlong, 1e-4));
    return {glm::ivec3(glm::ceil(low / space - kRoom)), glm::ivec3(glm::floor(high / space + kRoom)), space};
}

void append_arrow(std::vector<Mark>& marks, glm::vec3 middle, glm::vec3 way)
{
    const glm::vec3 from = middle - 0.5f * way, to = middle + 0.5f * way, neck = to - kHead * way;
    const glm::vec4 colour(kSky, 0.9f);
    marks.push_back({from, 1.6f, neck, 1.6f, colour});
    marks.push_back({neck, 7, to, 0, colour});
}

}  // namespace

void mark_wind(const SimParams& params, double time_s, std::span<const glm::vec4> positions, const MarkSheet& sheet)
{
    const bool is_air = params.wind_model == WindModel::aero;
    const Lattice lattice = around(positions);
    const AirField field = air_field(params, time_s);
    const glm::vec3 pressure(0, 0, wind_pressure(params, time_s));
    struct Place
    {
        glm::vec3 middle, wind;
    };
    std::vector<Place> places;
    float strongest = 0;
    for (int k = lattice.first.z; k <= lattice.last.z; ++k)
        for (int j = lattice.first.y; j <= lattice.last.y; ++j)
            for (int i = lattice.first.x; i <= lattice.last.x; ++i) {
                const glm::vec3 middle = lattice.space * glm::vec3(i, j, k);
                const glm::vec3 wind = is_air ? glm::vec3(air_velocity(field, glm::dvec3(middle))) : pressure;
                places.push_back({middle, wind});
                strongest = std::max(strongest, glm::length(wind));
            }
    if (strongest == 0) return sheet.legend.remarks.emplace_back("no wind now"), void();
    const float scale = kLongest * lattice.space / strongest;
    for (const Place& place : places) append_arrow(sheet.overlay.through, place.middle, scale * place.wind);
    sheet.legend.rows.push_back({kSky, is_air ? fmt::format("air, up to {:.2g} m/s", strongest)
                                              : fmt::format("wind, {:.2g} N/m2 everywhere", strongest)});
}

}  // namespace nuno
