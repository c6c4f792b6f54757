// The page of a trade study.
#include "study/trade_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/html.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

// Two digits, and no powers of ten for what is large.
std::string plain(double value)
{
    return std::abs(value) < 99.5 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}
std::string percent(double share) { return plain(100 * share) + " %"; }
std::string code(std::string_view text) { return "<code>" + html_text(text) + "</code>"; }

std::string words(const Json& result)
{
    std::string text;
    for (const auto& [name, value] : result.at("set").items())
        text += (text.empty() ? "" : " ") + name + "=" + value.get<std::string>();
    return text;
}

// A number of a result, or a dash where it was not measured.
std::string number(const Json& result, const char* name, const char* format = "{:.3g}")
{
    return result.contains(name) ? fmt::format(fmt::runtime(format), result[name].get<double>()) : "-";
}

std::string reason(const Json& result)
{
    if (result.contains("failure")) return html_text(result["failure"].get<std::string>());
    return result.value("too_slow", false) ? "given up: too slow" : "";
}

std::string class_text(const Json& c)
{
    if (c.contains("failure"))
        return "<p>There is nothing to hold errors against, as a run of the reference went bad: " + reason(c) +
               "</p>\n";
    const double seconds = c.value("frames", 0) / c.value("frame_rate", 60.0);
    std::string text = fmt::format("<p>{} particles, {:.3g} m. Positions are compared over {} frames ({:.2g} s)",
                                   c.value("particles", 0), c.value("size_m", 0.0), c.value("frames", 0), seconds);
    text +=
        fmt::format("; a start shifted by a millionth of a metre, about what rounding does, ends {} away there{}",
                    percent(c.value("doubt_share", 0.0)),
                    c.value("chaotic", false) ? ", and further later: then only the statistics of the long runs say "
                                                "something."
                                              : ".");
    const int contact = c.value("first_contact_frame", 0);
    text += contact == 0 ? " Layers do not meet there."
                         : fmt::format(" Layers come near each other from frame {} on.", contact);
    return text + fmt::format(
                      " Self-collision of the points: {}. The reference changes by {:.1e} m (rms) with a tenth "
                      "of its tolerance.</p>\n",
                      code(c.value("collision", "none")), c.value("reference_error_m", 0.0));
}

std::string picks(const TradeScene& scene)
{
    std::vector<std::vector<std::string>> rows;
    for (const double target : kTradeTargets) {
        const TradePoint* p = scene.pick(target);
        if (p == nullptr)
            rows.push_back({percent(target), "-", "-", "-", "-", "none of those tried"});
        else
            rows.push_back({percent(target), percent(p->error_share), percent(p->largest_share),
                            fmt::format("{:.3g}", p->ms_per_second), plain(1000 / p->ms_per_second),
                            code(setting_text(p->set))});
    }
    return html_table({"error asked for", "measured, rms", "largest", "ms a second", "times real time", "setting"},
                      rows);
}

std::string all_points(const TradeScene& scene)
{
    std::vector<std::vector<std::string>> rows;
    for (const TradePoint& p : scene.time)
        if (p.is_measured)
            rows.push_back({code(setting_text(p.set)), fmt::format("{}", p.substeps),
                            fmt::format("{:.4g}", p.ms_per_second), percent(p.error_share), percent(p.largest_share),
                            percent(p.energy_share), percent(p.largest_strain), p.is_on_front ? "front" : ""});
        else
            rows.push_back({code(setting_text(p.set)), fmt::format("{}", p.substeps), "-", "-", "-", "-", "-",
                            html_text(p.failure)});
    return "<details><summary>All settings</summary>" +
           html_table({"setting", "substeps", "ms a second", "error, rms", "largest", "energy", "largest strain", ""},
                      rows) +
           "</details>\n";
}

const std::vector<Json>& of_kind(const TradeScene& scene, const std::string& kind)
{
    static const std::vector<Json> none;
    const auto found = scene.others.find(kind);
    return found == scene.others.end() ? none : found->second;
}

std::string other_errors(const TradeScene& scene)
{
    std::vector<std::vector<std::string>> rows;
    for (const char* kind : {"space", "model"})
        for (const Json& r : of_kind(scene, kind))
            rows.push_back(
                {kind, code(words(r)), r.contains("error_share") ? percent(r["error_share"]) : "-", reason(r)});
    if (rows.empty()) return "";
    return "<h3>Errors in space and of the model</h3><p>Each converged in time, against the mesh and the model of "
           "the scene, "
           "over the same frames.</p>" +
           html_table({"error", "with", "rms", ""}, rows);
}

// From the cheapest level to the surest.
std::vector<Json> by_level(std::vector<Json> results)
{
    const auto names = choice_names(CollisionLevel{});
    const auto rank = [&](const Json& r) {
        return std::find(names.begin(), names.end(), r["set"]["collision"].get<std::string>());
    };
    std::sort(results.begin(), results.end(), [&](const Json& a, const Json& b) { return rank(a) < rank(b); });
    return results;
}

std::string levels(const TradeScene& scene)
{
    std::vector<std::vector<std::string>> rows;
    for (const Json& r : by_level(of_kind(scene, "level")))
        rows.push_back({code(words(r)), number(r, "ms_per_frame"), number(r, "poses_looked_at", "{:.0f}"),
                        number(r, "poses_that_intersect", "{:.0f}"), number(r, "intersections_per_pose", "{:.1f}"),
                        r.contains("largest_strain") ? percent(r["largest_strain"]) : "-", reason(r)});
    if (rows.empty()) return "";
    return "<h3>Self-collision</h3><p>With the scene's own settings to its end; intersecting pairs of faces are "
           "counted "
           "exactly.</p>" +
           html_table({"level", "ms a frame", "poses", "that intersect", "pairs a pose", "largest strain", ""}, rows);
}

std::string machine_costs(const TradeScene& scene, bool software_gl)
{
    std::vector<std::vector<std::string>> rows;
    for (const char* kind : {"threads", "backend"})
        for (const Json& r : of_kind(scene, kind)) {
            const std::string setting = words(r);
            const bool of_cpu = software_gl && setting == "backend=gpu";
            rows.push_back(
                {code(setting), number(r, "ms_per_frame"), of_cpu ? "software OpenGL: a CPU's time" : reason(r)});
        }
    if (rows.empty()) return "";
    return "<h3>Threads and backend</h3>" + html_table({"with", "ms a frame", ""}, rows);
}

std::string with_deviation(const Json& r, const char* name)
{
    if (!r.contains(name)) return "-";
    const double deviation = r[name]["deviation"];
    const std::string mean = fmt::format("{:.4g}", r[name]["mean"].get<double>());
    return deviation > 0 ? fmt::format("{} +- {:.2g}", mean, deviation) : mean;
}

std::string long_runs(const TradeScene& scene)
{
    std::vector<std::vector<std::string>> rows;
    for (const Json& r : of_kind(scene, "long"))
        rows.push_back({code(words(r)), number(r, "runs", "{:.0f}"), number(r, "ms_per_second"),
                        with_deviation(r, "centre_x_share"), with_deviation(r, "centre_y_share"),
                        with_deviation(r, "centre_z_share"), with_deviation(r, "kinetic_j"),
                        with_deviation(r, "largest_strain"), number(r, "kinetic_share_at_the_end", "{:.1e}"),
                        reason(r)});
    if (rows.empty()) return "";
    return "<h3>Long runs</h3><p>To the end of the scene with nuno's own number of substeps. Means over the second "
           "half of a "
           "run: the centre of the cloth over its size, kinetic energy; largest strain of the run. Where motion is "
           "chaotic, "
           "of an ensemble of jittered starts, with its standard deviation.</p>" +
           html_table({"setting", "runs", "ms a second", "centre x", "y", "z", "kinetic, J", "strain",
                       "kinetic energy left", ""},
                      rows);
}

}  // namespace

std::string trade_page(const std::vector<TradeScene>& scenes, const SweepState& sweep,
                       const std::filesystem::path& directory)
{
    const Json machine = sweep.header.value("machine", Json::object());
    const bool software = machine.value("software_gl", false);
    std::string body = html_missing(sweep.missing, sweep.count);
    body += fmt::format(
        "<p>Measured on {} ({} threads) by nuno {}. Costs are the least of some runs after a first one, of solver and "
        "collision, on the CPU with {} thread(s) unless said. They are times of this machine.</p>\n",
        html_text(machine.value("cpu", "an unknown CPU")), machine.value("threads", 0),
        html_text(sweep.header.value("version", "")), sweep.header.value("threads", 1));
    body +=
        "<p>The <b>error in time</b> is the root mean square distance of all vertices in all frames from a "
        "converged run of "
        "the same springs on the same mesh, in percent of the longest side of the cloth. What a finer mesh or "
        "another "
        "model would change stands apart.</p>\n";
    for (const TradeScene& scene : scenes) {
        body += "<h2>" + html_text(scene.name) + "</h2>\n";
        if (!scene.scene_class.is_null()) body += class_text(scene.scene_class);
        body += "<h3>What to pick</h3>" + picks(scene);
        body += html_picture(
            directory / ("trade-" + scene.name + ".svg"),
            "Error against cost, a curve a method; further left is more exact, further down cheaper. On the grey line "
            "nothing is both; its points are numbered, and named with their substeps a frame. Upright lines: what a coarser mesh is wrong by, however exact in time.");
        body +=
            all_points(scene) + other_errors(scene) + levels(scene) + machine_costs(scene, software) + long_runs(scene);
    }
    return html_page("nuno: how fast, how wrong", body);
}

}  // namespace nuno
