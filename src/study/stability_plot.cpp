// Heat maps by gnuplot.
#include "study/stability_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/oscillator.h"
#include "solver/method_table.h"
#include "study/gnuplot.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;
using Results = std::map<std::string, Json>;

struct Colour
{
    double r, g, b;
};

int rgb_between(const Colour& a, const Colour& b, double share)
{
    const double s = std::clamp(share, 0.0, 1.0);
    const auto part = [&](double from, double to) { return static_cast<int>(std::lround(from + s * (to - from))); };
    return part(a.r, b.r) * 65536 + part(a.g, b.g) * 256 + part(a.b, b.b);
}

// Errors from 0.5 % to 50 %, beyond that up to a thousandfold; growth from a thousandth to tenfold a substep.
int stable_rgb(double error) { return rgb_between({20, 88, 120}, {190, 226, 230}, std::log10(error / 0.005) / 2); }
int wrong_rgb(double error) { return rgb_between({255, 224, 130}, {230, 150, 30}, std::log10(error / 0.5) / 3); }
int blown_up_rgb(double growth) { return rgb_between({240, 140, 120}, {110, 0, 30}, std::log10(growth / 1e-3) / 3.36); }

int cell_rgb(const Json& cell)
{
    const std::string verdict = cell["verdict"];
    const double error = cell["error"].is_null() ? 1e9 : std::max(cell["error"].get<double>(), 1e-9);
    if (verdict == name_of(Verdict::stable)) return stable_rgb(error);
    if (verdict == name_of(Verdict::wrong)) return wrong_rgb(error);
    return blown_up_rgb(std::max(cell["growth"].get<double>(), 1e-9));
}

// Half of the way from one value to the next.
double half_step(const std::vector<double>& values) { return std::sqrt(values[1] / values[0]); }

// Axes in structural stiffness are shown in N/m, not as factors of it.
struct Units
{
    double x = 1, y = 1;
};

class Panels
{
  public:
    Panels(const StabilityMaps& maps, MapKind kind, const Results& results)
        : maps_(maps), kind_(kind), results_(results)
    {
        if (kind == MapKind::stiffness) units_.x = maps.structural_stiffness();
        if (kind == MapKind::mass) units_.y = maps.structural_stiffness();
    }

    std::string script(const std::string& scene) const
    {
        const MapInfo& info = map_info(kind_);
        const auto frame = [](const std::vector<double>& values, double unit) {
            const double half = half_step(values);
            return fmt::format("[{}:{}]", values.front() * unit / half, values.back() * unit * half);
        };
        std::string text = fmt::format(
            "set multiplot layout 3,3 title '{}: {}' font ',15' noenhanced\nset logscale xy\nset format xy '10^{{%T}}'\n"
            "set xrange {}\nset yrange {}\nset xlabel '{}' offset 0,0.4\nset ylabel '{}' offset 1,0\nset tics out nomirror\n"
            "set key off\nset style fill solid 1 noborder\n",
            gnuplot_quoted(scene), info.title, frame(maps_.x_values(kind_), units_.x),
            frame(maps_.y_values(kind_), units_.y), info.x_label, info.y_label);
        for (const Method method : maps_.methods()) text += panel(method);
        return text + legend() + "unset multiplot\n";
    }

  private:
    std::string panel(Method method) const
    {
        const std::string name(method_info(method).name), number = std::to_string(int(method));
        std::string text = cells(method, "$cells" + number) + lines(method, "$limits" + number);
        text += fmt::format(
            "set title '{}' noenhanced offset 0,-0.6\nplot $cells{} using 1:2:3:4:5:6:7 with boxxyerror "
            "fillcolor rgb variable",
            name, number);
        if (has_limits(method))
            text += fmt::format(
                ", $limits{0} using 1:2 with lines lw 4 lc rgb 'white', '' using 1:2 with lines lw 2 lc rgb 'black', "
                "'' using 1:3 with lines lw 1.5 dt 2 lc rgb 'black', "
                "'' using 1:4 with points pt 7 ps 0.7 lc rgb 'white', '' using 1:4 with points pt 6 ps 0.7 lc rgb 'black'",
                number);
        return text + "\n";
    }

    bool has_limits(Method method) const { return results_.count(limit_id(kind_, method, 0)) > 0; }

    std::string cells(Method method, const std::string& block) const
    {
        const std::vector<double>&xs = maps_.x_values(kind_), &ys = maps_.y_values(kind_);
        const double dx = half_step(xs), dy = half_step(ys);
        std::string text = block + " << EOD\n";
        for (std::size_t i = 0; i < xs.size(); ++i)
            for (std::size_t j = 0; j < ys.size(); ++j) {
                const auto cell = results_.find(cell_id(kind_, method, i, j));
                const double x = xs[i] * units_.x, y = ys[j] * units_.y;
                const int rgb = cell == results_.end() ? 0xeeeeee : cell_rgb(cell->second);
                text += fmt::format("{} {} {} {} {} {} {}\n", x, y, x / dx, x * dx, y / dy, y * dy, rgb);
            }
        return text + "EOD\n";
    }

    std::string lines(Method method, const std::string& block) const
    {
        if (!has_limits(method)) return "";
        std::string text = block + " << EOD\n";
        for (std::size_t i = 0; i < maps_.x_values(kind_).size(); ++i) {
            const auto found = results_.find(limit_id(kind_, method, i));
            if (found == results_.end()) continue;
            const Json& limit = found->second;
            const double measured = limit["measured"].is_null() ? NAN : limit["measured"].get<double>();
            text += fmt::format("{} {} {} {}\n", maps_.x_values(kind_)[i] * units_.x,
                                limit["predicted"].get<double>() * units_.y, limit["safe"].get<double>() * units_.y,
                                measured * units_.y);
        }
        return text + "EOD\n";
    }

    static std::string legend()
    {
        std::string text =
            "unset logscale\nset xrange [0:1]\nset yrange [0:1]\nunset xlabel\nunset ylabel\nunset tics\nunset border\n"
            "set title ''\nset key at graph 0,1 left top reverse Left samplen 2 spacing 1.25 font ',11' noenhanced\nplot ";
        const auto box = [&](int rgb, const char* title) {
            text += fmt::format("NaN with boxes fillcolor rgb {} title '{}', ", rgb, title);
        };
        box(stable_rgb(0.005), "stable, error under 0.5 %");
        box(stable_rgb(0.05), "stable, error 5 %");
        box(stable_rgb(0.5), "stable, error 50 %");
        box(wrong_rgb(0.5), "bounded but wrong, error over 50 %");
        box(wrong_rgb(500), "bounded but wrong, error over 500-fold");
        box(blown_up_rgb(0.01), "blown up, growth 1 % a substep");
        box(blown_up_rgb(0.3), "blown up, 30 %");
        box(blown_up_rgb(2.3), "blown up, tenfold");
        return text +
               "NaN with lines lw 2 lc rgb 'black' title 'limit predicted at the highest frequency', "
               "NaN with lines lw 1.5 dt 2 lc rgb 'black' title 'limit at the bound on it', "
               "NaN with points pt 6 ps 0.7 lc rgb 'black' title 'limit measured by halving'\n"
               "set border\nset tics\n";
    }

    const StabilityMaps& maps_;
    MapKind kind_;
    const Results& results_;
    Units units_;
};

}  // namespace

bool plot_stability(const StabilityMaps& maps, MapKind kind, const Results& results,
                    const std::filesystem::path& directory, const std::string& name)
{
    return draw_with_gnuplot(directory, name, Panels(maps, kind, results).script(maps.name()), 1500, 1200);
}

}  // namespace nuno
