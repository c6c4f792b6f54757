// Work-precision diagrams.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "study/gnuplot.h"
#include "study/trade_report.h"

namespace nuno {
namespace {

constexpr const char* kColours[] = {"#4477aa", "#ee6677", "#228833", "#ccbb44",
                                    "#66ccee", "#aa3377", "#ee7733", "#777777"};

struct Curve
{
    std::string variant, method;
    std::vector<const TradePoint*> points;
};

std::vector<Curve> curves_of(const TradeScene& scene)
{
    std::map<std::string, Curve> curves;
    for (const TradePoint& point : scene.time) {
        if (!point.is_measured || point.error_share <= 0) continue;
        Curve& curve = curves[point.variant];
        curve.variant = point.variant;
        curve.method = point.set.front().second;
        curve.points.push_back(&point);
    }
    std::vector<Curve> list;
    for (auto& [variant, curve] : curves) list.push_back(std::move(curve));
    return list;
}

std::string block(std::string_view name, const std::vector<const TradePoint*>& points)
{
    std::string text = fmt::format("${} << END\n", name);
    for (const TradePoint* p : points)
        text += fmt::format("{} {} \"{} {}\"\n", 100 * p->error_share, p->ms_per_second, p->set.front().second,
                            p->substeps);
    return text + "END\n";
}

}  // namespace

bool plot_trade(const TradeScene& scene, const std::filesystem::path& directory)
{
    const std::vector<Curve> curves = curves_of(scene);
    if (curves.empty()) return false;
    std::vector<const TradePoint*> front;
    for (const TradePoint& point : scene.time)
        if (point.is_on_front && point.error_share > 0) front.push_back(&point);
    std::sort(front.begin(), front.end(),
              [](const TradePoint* a, const TradePoint* b) { return a->error_share < b->error_share; });

    std::vector<double> errors, costs;
    for (const Curve& curve : curves)
        for (const TradePoint* point : curve.points) {
            errors.push_back(point->error_share);
            costs.push_back(point->ms_per_second);
        }
    const auto [least_error, largest_error] = std::minmax_element(errors.begin(), errors.end());
    const auto [least_ms, largest_ms] = std::minmax_element(costs.begin(), costs.end());
    std::string script = fmt::format(
        "set logscale xy\nset grid\nset key outside right top Left reverse samplen 2 font ',10' noenhanced\nset "
        "title 'nuno trade: {}'  noenhanced\n"
        "set xlabel 'error in time: rms distance from the converged run, percent of the size of the cloth'\n"
        "set ylabel 'cost: ms of one simulated second'\nset xtics format '%g'\nset ytics format '%g'\n"
        "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n",
        gnuplot_quoted(scene.name), 50 * *least_error, 800 * *largest_error, 0.6 * *least_ms, 1.6 * *largest_ms);
    script += block("front", front);
    std::string plot = "plot $front using 1:2 with lines lw 8 lc '#dddddd' title 'Pareto front'";
    std::map<std::string, std::size_t> methods;
    std::map<std::string, int> variants;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const std::size_t method = methods.emplace(curves[c].method, methods.size()).first->second;
        script += block(fmt::format("curve{}", c), curves[c].points);
        plot += fmt::format(", \\\n     $curve{} using 1:2 with linespoints lc '{}' pt 7 ps 0.6 dt {} title '{}'", c,
                            kColours[method % std::size(kColours)], ++variants[curves[c].method],
                            gnuplot_quoted(curves[c].variant));
    }
    plot += ", \\\n     $front using 1:2 with points pt 6 ps 1.6 lc '#000000' notitle";
    plot += ", \\\n     $front using 1:2:3 with labels left offset 1,0.4 font ',9' noenhanced notitle";
    return draw_with_gnuplot(directory, "trade-" + scene.name, script + plot, 1200, 700);
}

}  // namespace nuno
