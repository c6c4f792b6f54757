// The comparison of many methods: a picture of ratios, and a page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/quantile.h"
#include "study/compare_plot.h"
#include "study/gnuplot.h"
#include "study/html.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

bool same_bits(const ComparePoint& p) { return p.substep_hashes_agree && p.frame_hashes_agree; }

std::string size_text(const ComparePoint& p) { return p.size > 0 ? std::to_string(p.size) : "mesh"; }

double largest_of(const ComparePoint& p)
{
    return *std::max_element(p.largest_difference_m.begin(), p.largest_difference_m.end());
}

bool is_lost(const ComparePoint& p)
{
    return std::any_of(p.largest_difference_m.begin(), p.largest_difference_m.end(), [](double d) { return d < 0; });
}

// Methods that points have, in the order of the program.
std::vector<std::string> methods_of(const std::vector<ComparePoint>& points)
{
    std::vector<std::string> methods;
    for (const std::string_view name : choice_names(Method{}))
        if (std::any_of(points.begin(), points.end(), [&](const ComparePoint& p) { return p.method_name() == name; }))
            methods.emplace_back(name);
    return methods;
}

std::string summary(const std::vector<ComparePoint>& points)
{
    int same = 0, bad = 0;
    double largest = 0;
    std::vector<double> ratios;
    for (const ComparePoint& p : points) {
        same += same_bits(p);
        bad += !p.failure.empty() || is_lost(p);
        largest = std::max(largest, largest_of(p));
        if (p.ratio() > 0) ratios.push_back(p.ratio());
    }
    std::string text = fmt::format(
        "<p>{} points. The same bits on both in <b>{}</b>; largest difference of a position, after up to {} substeps: "
        "<b>{:.2g} m</b>; gone bad: {}.",
        points.size(), same, kComparedSubsteps.back(), largest, bad);
    if (!ratios.empty()) {
        const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
        text += fmt::format(
            " A frame takes {:.2g} to {:.2g} times as long on the GPU as on the CPU, {:.2g} times in the "
            "median.",
            *least, *most, median(ratios));
    }
    return text + "</p>\n";
}

std::string cell_text(const ComparePoint& p)
{
    if (!p.failure.empty()) return "went bad";
    return fmt::format("{:.2f}{}", p.ratio(), same_bits(p) ? "" : fmt::format(" <b>({:.1e} m)</b>", largest_of(p)));
}

// A row a scene and size, a column a method.
std::string overview(const std::vector<ComparePoint>& points)
{
    const std::vector<std::string> methods = methods_of(points);
    std::vector<std::string> head{"scene", "vertices a side"};
    head.insert(head.end(), methods.begin(), methods.end());
    std::vector<std::vector<std::string>> rows;
    std::map<std::pair<std::string, int>, std::size_t> row_of;
    for (const ComparePoint& p : points) {
        const auto [entry, is_new] = row_of.emplace(std::pair(p.scene, p.size), rows.size());
        if (is_new) {
            rows.push_back({html_text(p.scene), size_text(p)});
            rows.back().resize(head.size());
        }
        const auto column = std::find(methods.begin(), methods.end(), p.method_name()) - methods.begin();
        rows[entry->second][std::size_t(column) + 2] = cell_text(p);
    }
    return "<h2>Time of a frame, GPU over CPU</h2><p>Where the two are not the same bit for bit, the largest difference "
           "of a position stands in brackets.</p>" +
           html_table(head, rows);
}

std::string all_points(const std::vector<ComparePoint>& points)
{
    std::vector<std::string> head{"scene",    "side",    "particles", "method",
                                  "substeps", "CPU, ms", "GPU, ms",   "GPU / CPU"};
    for (const int substeps : kComparedSubsteps) head.push_back(fmt::format("after {}, m", substeps));
    head.insert(head.end(), {"same bits", ""});
    std::vector<std::vector<std::string>> rows;
    for (const ComparePoint& p : points) {
        rows.push_back({html_text(p.scene), size_text(p), std::to_string(p.particles), std::string(p.method_name()),
                        std::to_string(p.substeps), fmt::format("{:.3f}", p.cpu.frame_ms),
                        fmt::format("{:.3f}", p.gpu.frame_ms), fmt::format("{:.2f}", p.ratio())});
        for (const double d : p.largest_difference_m)
            rows.back().push_back(d < 0 ? "no number" : fmt::format("{:.2g}", d));
        rows.back().insert(rows.back().end(), {same_bits(p) ? "yes" : "<b>no</b>", html_text(p.failure)});
    }
    return "<h2>All points</h2>" + html_table(head, rows);
}

}  // namespace

bool plot_ratios(const std::vector<ComparePoint>& points, bool software_gl, const std::filesystem::path& directory)
{
    const std::vector<std::string> methods = methods_of(points);
    std::string data = "$ratios << END\n", tics;
    for (std::size_t m = 0; m < methods.size(); ++m) tics += fmt::format("{}'{}' {}", m > 0 ? ", " : "", methods[m], m);
    int drawn = 0;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<const ComparePoint*> of_method;
        for (const ComparePoint& p : points)
            if (p.ratio() > 0 && p.method_name() == methods[m]) of_method.push_back(&p);
        for (std::size_t i = 0; i < of_method.size(); ++i, ++drawn)
            data += fmt::format("{} {} {}\n", double(m) - 0.35 + 0.7 * (double(i) + 0.5) / double(of_method.size()),
                                of_method[i]->ratio(), of_method[i]->particles);
    }
    if (drawn == 0) return false;
    return draw_with_gnuplot(
        directory, "compare",
        data +
            fmt::format(
                "END\nset logscale y\nset logscale cb\nset grid ytics lc '#dddddd'\nset key off\nset xtics ({}) noenhanced\n"
                "set xrange [-0.5:{}]\nset ylabel 'time of a frame, GPU over CPU'\nset cblabel 'particles'\n"
                "set palette defined (0 '#88ccee', 1 '#332288')\nset format y '%g'\n"
                "set title 'nuno: CPU threads against compute shaders{}, a point a scene'\n"
                "plot 1 with lines lc '#555555' dt 2, $ratios using 1:2:3 with points pt 7 ps 1.2 palette",
                tics, double(methods.size()) - 0.5, software_gl ? " (software OpenGL: times of a CPU)" : ""));
}

std::string compare_page(const std::vector<ComparePoint>& points, const std::vector<std::string>& left_out,
                         const Json& machine, const std::filesystem::path& directory)
{
    const std::string renderer = html_text(machine.value("gl_renderer", "")), cpu = html_text(machine.value("cpu", ""));
    std::string body =
        fmt::format("<p>CPU: {}, {} threads. GPU: {}.</p>\n", cpu, machine.value("threads", 0), renderer);
    if (machine.value("software_gl", false))
        body +=
            "<p><b>This GPU is software: the same CPU runs the compute shaders. Its times are times of a CPU, and the "
            "ratios say nothing about a graphics card.</b></p>\n";
    body += summary(points) + html_picture(directory / "compare.svg", "Below 1 the GPU is faster.") + overview(points) +
            all_points(points);
    if (!left_out.empty()) {
        body += "<h2>Left out</h2><ul>\n";
        for (const std::string& line : left_out) body += "<li>" + html_text(line) + "</li>\n";
        body += "</ul>\n";
    }
    return html_page("nuno: CPU against GPU", body);
}

}  // namespace nuno
