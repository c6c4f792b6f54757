// Work-precision diagrams.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

// Marks of the variants of a method: discs, rings, squares and so on of gnuplot.
constexpr int kMarks[] = {7, 6, 5, 4, 9, 8};

std::string block(std::string_view name, const std::vector<const TradePoint*>& points)
{
    std::string text = fmt::format("${} << END\n", name);
    for (const TradePoint* p : points) text += fmt::format("{} {}\n", 100 * p->error_share, p->ms_per_second);
    return text + "END\n";
}

// The points of the front by number, and in the legend what each is.
std::string numbers(const std::vector<const TradePoint*>& front)
{
    std::string text = ", \\\n     $front using 1:2 with points pt 7 ps 2.6 lc '#ffffff' notitle";
    text += ", \\\n     $front using 1:2 with points pt 6 ps 2.6 lw 1.3 lc '#000000' notitle";
    text += ", \\\n     $front using 1:2:($0 + 1) with labels font ',10' notitle";
    for (std::size_t i = 0; i < front.size(); ++i)
        text += fmt::format(", \\\n     NaN with points pt 6 ps 1.2 lc '#000000' title '{}: {} x{}'", i + 1,
                            gnuplot_quoted(front[i]->variant), front[i]->substeps);
    return text;
}

struct Range
{
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    void add(double value) { least = std::min(least, value), largest = std::max(largest, value); }
};

// Upright lines where a coarser mesh is wrong by so much itself.
std::string mesh_errors(const TradeScene& scene)
{
    std::string text;
    const auto found = scene.others.find("space");
    if (found == scene.others.end()) return text;
    for (const nlohmann::ordered_json& r : found->second)
        if (r.contains("error_share"))
            text += fmt::format(
                "set arrow from first {0:g}, graph 0 to first {0:g}, graph 1 nohead dt 2 lc '#999999' back\n"
                "set label 'mesh of {1} a side' at first {0:g}, graph 0.98 right rotate offset -0.7,0 font ',10' "
                "tc '#777777' noenhanced\n",
                100 * r["error_share"].get<double>(), r["set"]["resolution"].get<std::string>());
    return text;
}

// Axes, title and legend.
std::string frame(const TradeScene& scene, const std::vector<Curve>& curves)
{
    Range error, ms;
    for (const Curve& curve : curves)
        for (const TradePoint* point : curve.points) {
            error.add(point->error_share);
            ms.add(point->ms_per_second);
        }
    return fmt::format(
        "set logscale xy\nset grid lc '#dddddd'\nset key outside right top Left reverse samplen 3 spacing 1.15 font "
        "',11' noenhanced\nset title '{}: what accuracy costs' font ',14' noenhanced\n"
        "set xlabel 'error in time: rms distance from the converged run, percent of the size of the cloth'\n"
        "set ylabel 'cost: ms of one simulated second'\nset xtics format '%g'\nset ytics format '%g'\n"
        "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n",
        gnuplot_quoted(scene.name), 50 * error.least, 400 * error.largest, 0.6 * ms.least, 1.6 * ms.largest);
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

    std::string script = frame(scene, curves) + mesh_errors(scene) + block("front", front);
    std::string plot = "plot $front using 1:2 with lines lw 10 lc '#dddddd' title 'Pareto front'";
    std::map<std::string, std::size_t> methods, variants;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const std::size_t method = methods.emplace(curves[c].method, methods.size()).first->second;
        const std::size_t variant = variants[curves[c].method]++;
        script += block(fmt::format("curve{}", c), curves[c].points);
        plot +=
            fmt::format(", \\\n     $curve{} using 1:2 with linespoints lw 1.3 lc '{}' pt {} ps 0.8 dt {} title '{}'",
                        c, kColours[method % std::size(kColours)], kMarks[variant % std::size(kMarks)], variant + 1,
                        gnuplot_quoted(curves[c].variant));
    }
    return draw_with_gnuplot(directory, "trade-" + scene.name, script + plot + numbers(front), 1200, 760);
}

}  // namespace nuno
