// Cells, columns and their limits.
#include "study/stability_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "model/oscillator.h"
#include "model/stability.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Damping ratio at the highest mode that explicit Euler gets where a map does not set it, and all get in the wind:
// without it the one is never stable, and the other never at rest.
constexpr double kRatio = 0.25;
// Mass ratio at which the substep of the map of masses is each method's limit.
constexpr double kFixedAtRatio = 10;

constexpr MapInfo kMaps[] = {
    {"stiffness", "Substep against stiffness", "structural stiffness [N/m]", "substep [s]"},
    {"damping", "Substep against damping", "damping [kg/(m^2 s)]", "substep [s]"},
    {"wind", "Substep against wind", "steady pressure of the wind [N/m^2]", "substep [s]"},
    {"mass", "Stiffness against mass ratio", "mass ratio of neighbours", "structural stiffness [N/m]"}};

std::vector<double> decades(double from, double to, int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(from * std::pow(to / from, double(i) / (count - 1)));
    return values;
}

bool is_measured(const MethodInfo& info, const SimParams& params)
{
    if (info.method == Method::reference || !info.on(Backend::cpu)) return false;
    if (params.internal_model == InternalModel::continuum && !info.takes_continuum) return false;
    return params.stiffness_damping <= 0 || info.takes_dampers;
}

double air_for(double ratio, double omega, const SimParams& params)
{
    return 2 * ratio * omega * double(params.areal_density);
}

}  // namespace

const MapInfo& map_info(MapKind kind) { return kMaps[std::size_t(kind)]; }

StabilityMaps::StabilityMaps(const Scene& scene, const SimParams& params, MapSize size)
    : name_(scene.name),
      model_(build_cloth_model(make_sheets(scene, params), params.mass_lumping)),
      params_(params),
      structural_stiffness_(double(params.structural_stiffness)),
      seed_(params.seed == 0 ? 1 : params.seed)
{
    for (const MethodInfo& info : method_table())
        if (is_measured(info, params) && (params.method == Method::automatic || params.method == info.method))
            methods_.push_back(info.method);
    if (methods_.empty())
        throw Error(
            fmt::format("{}: no method can be mapped with these parameters; give another --method, internal_model "
                        "springs or stiffness_damping 0",
                        scene.name));
    const RestCloth cloth = rest_cloth(model_, params_, {.damping = double(params.damping)});
    omega_ = cloth.omega;
    if (!(omega_ > 0 && cloth.slow_omega > 0))
        throw Error(scene.name + ": nothing moves: every vertex is pinned, or no spring resists; there is no limit");
    const double h = 2 / omega_;
    const auto at = [](MapKind kind) { return std::size_t(kind); };
    x_[at(MapKind::stiffness)] = decades(1e-2, 1e4, size.columns);
    y_[at(MapKind::stiffness)] = decades(h * std::pow(10, -2.5), h * std::pow(10, 1.5), size.rows);
    x_[at(MapKind::damping)] = decades(air_for(0.05, omega_, params_), air_for(4, omega_, params_), size.columns);
    y_[at(MapKind::damping)] = decades(h * std::pow(10, -1.75), h * 10, size.rows);
    x_[at(MapKind::wind)] = decades(0.1, 1000, size.columns);
    y_[at(MapKind::wind)] = decades(h * std::pow(10, -1.5), h * 10, size.rows);
    x_[at(MapKind::mass)] = decades(1, 1e4, size.columns);
    y_[at(MapKind::mass)] = decades(1e-4, 1e2, size.rows);
}

RestCase StabilityMaps::rest_case(MapKind kind, Method method, double x, double y) const
{
    RestCase rest{.damping = double(params_.damping)};
    if (method == Method::explicit_euler) rest.damping = air_for(kRatio, omega_, params_);
    switch (kind) {
    case MapKind::stiffness:
        rest.stiffness = x;
        if (method == Method::explicit_euler) rest.damping *= std::sqrt(x);
        break;
    case MapKind::damping: rest.damping = x; break;
    case MapKind::wind:
        rest.damping = air_for(kRatio, omega_, params_);
        rest.pressure = x;
        rest.loaded = true;
        break;
    case MapKind::mass:
        rest.mass_ratio = x;
        rest.stiffness = y;
        break;
    }
    return rest;
}

double StabilityMaps::fixed_substep_s(Method method) const
{
    const auto cloth = cloth_of(rest_case(MapKind::mass, method, kFixedAtRatio, 1));
    return is_explicit(method) ? predicted_limit_s(*cloth, method) : 2 / cloth->omega;
}

// Most cells of a column and most methods have one cloth in common, which is made once.
std::shared_ptr<const RestCloth> StabilityMaps::cloth_of(const RestCase& rest) const
{
    const std::string key =
        fmt::format("{} {} {} {} {}", rest.stiffness, rest.damping, rest.pressure, rest.mass_ratio, rest.loaded);
    std::shared_ptr<Entry> entry;
    {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<Entry>& kept = cloths_[key];
        if (!kept) kept = std::make_shared<Entry>();
        entry = kept;
    }
    std::call_once(entry->once, [&] { entry->cloth = rest_cloth(model_, params_, rest); });
    return {entry, &entry->cloth};
}

StabilityMaps::Place StabilityMaps::place(MapKind kind, Method method, double x, double y) const
{
    const RestCase rest = rest_case(kind, method, x, y);
    if (kind != MapKind::mass) return {cloth_of(rest), y};
    return {std::make_shared<const RestCloth>(rest_cloth(model_, params_, rest)), fixed_substep_s(method)};
}

double StabilityMaps::over_limit(const Place& place, Method method) const
{
    return place.substep_s / predicted_limit_s(*place.cloth, method);
}

// Where in a column the substep is `over` times the limit that `omega_of` a cloth gives.
double StabilityMaps::y_where(MapKind kind, Method method, double x, double over, double RestCloth::*omega_of) const
{
    const auto cloth = cloth_of(rest_case(kind, method, x, 1));
    SimParams params = cloth->params;
    params.method = method;
    if (kind != MapKind::mass) return over * largest_stable_substep(params, *cloth.*omega_of);
    const double substep_s = fixed_substep_s(method);
    double low = 1e-9, high = 1e9;
    for (int i = 0; i < 60; ++i) {  // omega^2 is proportional to the stiffness
        const double middle = std::sqrt(low * high);
        const double limit_s = largest_stable_substep(params, *cloth.*omega_of * std::sqrt(middle));
        (substep_s < over * limit_s ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

Json StabilityMaps::measure_cell(MapKind kind, Method method, std::size_t column, std::size_t row) const
{
    const double x = x_values(kind)[column], y = y_values(kind)[row];
    const Place at = place(kind, method, x, y);
    const ShakeRun run = shake(*at.cloth, method, at.substep_s, substeps_to_judge(method), seed_);
    return {{"x", x},
            {"y", y},
            {"substep_s", at.substep_s},
            {"omega", at.cloth->omega},
            {"damping_ratio",
             double(at.cloth->params.damping) / double(at.cloth->params.areal_density) / (2 * at.cloth->omega)},
            {"over_limit", is_explicit(method) ? Json(over_limit(at, method)) : Json()},
            {"verdict", name_of(run.verdict)},
            {"growth", run.growth},
            {"error", run.error},
            {"substeps", run.substeps},
            {"lost_after", run.lost_after}};
}

Json StabilityMaps::measure_limit(MapKind kind, Method method, std::size_t column) const
{
    constexpr int halvings = 8;  // of a quarter below to a quarter above: to 0.2 %
    const double x = x_values(kind)[column];
    double stable = y_where(kind, method, x, 0.8, &RestCloth::omega);
    double unstable = y_where(kind, method, x, 1.25, &RestCloth::omega);
    const auto is_over = [&](double y) {
        const Place at = place(kind, method, x, y);
        return grows(*at.cloth, method, at.substep_s, 3 * substeps_to_judge(method), seed_);
    };
    const bool brackets = !is_over(stable) && is_over(unstable);
    for (int i = 0; brackets && i < halvings; ++i) {
        const double middle = std::sqrt(stable * unstable);
        (is_over(middle) ? unstable : stable) = middle;
    }
    const double measured = std::sqrt(stable * unstable);
    const Place at = place(kind, method, x, measured);
    return {{"x", x},
            {"predicted", y_where(kind, method, x, 1, &RestCloth::omega)},
            {"safe", y_where(kind, method, x, 1, &RestCloth::omega_bound)},
            {"measured", brackets ? Json(measured) : Json()},
            {"deviation", brackets ? over_limit(at, method) - 1 : 1.0},
            {"residual_speed", at.cloth->residual_speed}};
}

std::string cell_id(MapKind kind, Method method, std::size_t column, std::size_t row)
{
    return fmt::format("{}/{}/{}/{}", map_info(kind).id, method_info(method).name, column, row);
}

std::string limit_id(MapKind kind, Method method, std::size_t column)
{
    return fmt::format("{}/{}/{}/limit", map_info(kind).id, method_info(method).name, column);
}

std::vector<SweepPoint> StabilityMaps::points() const
{
    std::vector<SweepPoint> points;
    for (const MapKind kind : kMapKinds)
        for (const Method method : methods_)
            for (std::size_t i = 0; i < x_values(kind).size(); ++i) {
                for (std::size_t j = 0; j < y_values(kind).size(); ++j)
                    points.push_back(
                        {cell_id(kind, method, i, j), [=, this] { return measure_cell(kind, method, i, j); }});
                if (is_explicit(method))
                    points.push_back({limit_id(kind, method, i), [=, this] { return measure_limit(kind, method, i); }});
            }
    return points;
}

namespace {

void count_cell(MapSummary& summary, const Json& cell)
{
    const std::string verdict = cell["verdict"];
    ++summary.cells;
    const bool blown_up = verdict == name_of(Verdict::blown_up);
    ++(blown_up ? summary.blown_up : verdict == name_of(Verdict::stable) ? summary.stable : summary.wrong);
    summary.lost += cell["lost_after"] >= 0;
    const double over = cell["over_limit"].is_null() ? 0 : cell["over_limit"].get<double>();
    if (std::abs(over - 1) <= kLimitBand)
        ++summary.near;
    else
        summary.wrong_side += blown_up != (over > 1);
}

}  // namespace

std::vector<MapSummary> summarise(const StabilityMaps& maps, const std::map<std::string, Json>& results)
{
    std::vector<MapSummary> summaries;
    for (const MapKind kind : kMapKinds)
        for (const Method method : maps.methods()) {
            MapSummary& summary = summaries.emplace_back(MapSummary{.kind = kind, .method = method});
            for (std::size_t i = 0; i < maps.x_values(kind).size(); ++i) {
                for (std::size_t j = 0; j < maps.y_values(kind).size(); ++j) {
                    const auto cell = results.find(cell_id(kind, method, i, j));
                    if (cell == results.end())
                        ++summary.missing;
                    else
                        count_cell(summary, cell->second);
                }
                const auto limit = results.find(limit_id(kind, method, i));
                if (limit == results.end()) continue;
                ++summary.limits;
                const Json& deviation = limit->second["deviation"];
                const bool is_number = deviation.is_number() && std::isfinite(deviation.get<double>());
                summary.deviation = std::max(summary.deviation, is_number ? std::abs(deviation.get<double>()) : 1.0);
            }
        }
    return summaries;
}

}  // namespace nuno
