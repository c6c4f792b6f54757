// Maps of stability: for each method, what becomes of a shaken cloth over two parameters, and where its limit lies.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "study/stability_run.h"
#include "study/sweep.h"

namespace nuno {

enum class MapKind : std::int32_t
{
    stiffness,  // substep against stiffness
    damping,    // substep against the damper
    wind,       // substep against the pressure of the wind, at rest in it
    mass        // stiffness against the mass ratio of neighbours, at one substep
};
inline constexpr std::array<MapKind, 4> kMapKinds{MapKind::stiffness, MapKind::damping, MapKind::wind, MapKind::mass};

struct MapInfo
{
    std::string_view id, title, x_label, y_label;
};
const MapInfo& map_info(MapKind kind);

// Cells from the limit by less than this share of the substep may fall on either side.
inline constexpr double kLimitBand = 0.05;
// Largest deviation of a measured limit from the predicted one, as a share.
inline constexpr double kLimitTolerance = 0.03;

struct MapSize
{
    int columns = 13, rows = 17;
};

class StabilityMaps
{
  public:
    // Of a scene's sheets at params.resolution. Error where no method can be measured with these parameters.
    StabilityMaps(const Scene& scene, const SimParams& params, MapSize size = {});

    const std::string& name() const { return name_; }
    const std::vector<Method>& methods() const { return methods_; }
    const std::vector<double>& x_values(MapKind kind) const { return x_[std::size_t(kind)]; }
    const std::vector<double>& y_values(MapKind kind) const { return y_[std::size_t(kind)]; }
    double structural_stiffness() const { return structural_stiffness_; }  // [N/m] where the factor is 1
    // [s] of a map at one substep.
    double fixed_substep_s(Method method) const;

    // One for each cell, and one for each column of an explicit method: its limit, by halving.
    std::vector<SweepPoint> points() const;

    nlohmann::ordered_json measure_cell(MapKind kind, Method method, std::size_t column, std::size_t row) const;
    nlohmann::ordered_json measure_limit(MapKind kind, Method method, std::size_t column) const;

  private:
    struct Place
    {
        std::shared_ptr<const RestCloth> cloth;
        double substep_s;
    };
    struct Entry
    {
        std::once_flag once;
        RestCloth cloth;
    };

    RestCase rest_case(MapKind kind, Method method, double x, double y) const;
    std::shared_ptr<const RestCloth> cloth_of(const RestCase& rest) const;
    Place place(MapKind kind, Method method, double x, double y) const;
    double over_limit(const Place& place, Method method) const;
    double y_where(MapKind kind, Method method, double x, double over, double RestCloth::*omega_of) const;

    std::string name_;
    ClothModel model_;
    SimParams params_;
    std::vector<Method> methods_;
    double structural_stiffness_;
    double omega_;  // at rest [rad/s]
    int seed_;
    std::array<std::vector<double>, kMapKinds.size()> x_, y_;
    mutable std::mutex mutex_;
    mutable std::map<std::string, std::shared_ptr<Entry>> cloths_;  // by what they are of
};

// The id of a cell, and of a column's limit.
std::string cell_id(MapKind kind, Method method, std::size_t column, std::size_t row);
std::string limit_id(MapKind kind, Method method, std::size_t column);

// What a map of one method came to.
struct MapSummary
{
    MapKind kind;
    Method method;
    int cells = 0, missing = 0, stable = 0, wrong = 0, blown_up = 0;
    int lost = 0;                  // cells in which a number was lost, all of them seen
    int wrong_side = 0, near = 0;  // cells outside of the band on the wrong side of the predicted limit; within it
    int limits = 0;                // columns with a measured limit
    double deviation = 0;          // the largest of a measured limit, as a share; explicit methods
    bool holds() const { return wrong_side == 0 && deviation <= kLimitTolerance; }
};
std::vector<MapSummary> summarise(const StabilityMaps& maps,
                                  const std::map<std::string, nlohmann::ordered_json>& results);

}  // namespace nuno
