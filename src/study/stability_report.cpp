// Tables of a stability study.
#include "study/stability_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/oscillator.h"
#include "solver/method_table.h"
#include "study/html.h"
#include "study/stability_plot.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::string number(const Json& value) { return value.is_number() ? fmt::format("{:.4g}", value.get<double>()) : ""; }

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

std::string picture_name(const StabilityScene& scene, MapKind kind)
{
    return fmt::format("stability-{}-{}", scene.name(), map_info(kind).id);
}

// Outcomes of all methods and both ways to choose substeps, of one extreme.
struct ExtremeCount
{
    int cases = 0, missing = 0, as_expected = 0, unseen = 0, crashed = 0, too_long = 0, refused = 0, went_bad = 0;
};

ExtremeCount count_extremes(const StabilityScene& scene)
{
    ExtremeCount count;
    for (const ExtremeCase& c : scene.extremes) {
        const auto found = scene.results.find(c.id);
        ++count.cases;
        if (found == scene.results.end()) {
            ++count.missing;
            continue;
        }
        const std::string outcome = found->second["outcome"];
        count.as_expected += found->second["as_expected"].get<bool>();
        count.unseen += outcome == name_of(Outcome::unseen);
        count.crashed += outcome == name_of(Outcome::crashed);
        count.too_long += outcome == name_of(Outcome::too_long);
        count.refused += outcome == name_of(Outcome::refused);
        count.went_bad += outcome == name_of(Outcome::went_bad);
    }
    return count;
}

std::string extremes_line(const StabilityScene& scene)
{
    const ExtremeCount n = count_extremes(scene);
    return fmt::format(
        "{} extremes: {} measured, {} as expected ({} refused, {} went bad and said so), {} lost numbers unseen, {} "
        "hangs, {} crashes",
        n.cases, n.cases - n.missing, n.as_expected, n.refused, n.went_bad, n.unseen, n.too_long, n.crashed);
}

std::string deviation_text(const MapSummary& s) { return s.limits > 0 ? percent(s.deviation) : ""; }

}  // namespace

std::optional<bool> holds(const StabilityScene& scene)
{
    const std::vector<MapSummary> summaries = summarise(*scene.maps, scene.results);
    const ExtremeCount n = count_extremes(scene);
    if (n.as_expected + n.missing < n.cases ||
        !std::all_of(summaries.begin(), summaries.end(), [](const MapSummary& s) { return s.holds(); }))
        return false;
    const std::vector<SweepPoint> points = scene.maps->points();
    const bool is_whole = n.missing == 0 && std::all_of(points.begin(), points.end(), [&](const SweepPoint& point) {
                              return scene.results.count(point.id) > 0;
                          });
    return is_whole ? std::optional(true) : std::nullopt;
}

std::string stability_table(const StabilityScene& scene)
{
    std::string table =
        fmt::format("{:9} {:10} {:17} {:>5} {:>6} {:>6} {:>9} {:>5} {:>10} {:>10}\n", "scene", "map", "method", "cells",
                    "stable", "wrong", "blown up", "lost", "wrong side", "deviation");
    for (const MapSummary& s : summarise(*scene.maps, scene.results))
        table += fmt::format("{:9} {:10} {:17} {:>5} {:>6} {:>6} {:>9} {:>5} {:>10} {:>10}\n", scene.name(),
                             map_info(s.kind).id, method_info(s.method).name, s.cells, s.stable, s.wrong, s.blown_up,
                             s.lost, s.wrong_side, deviation_text(s));
    return table + scene.name() + ": " + extremes_line(scene) + "\n";
}

std::string stability_csv(const std::vector<StabilityScene>& scenes)
{
    std::string text =
        "scene,map,method,x,y,substep_s,omega,damping_ratio,over_limit,verdict,growth,error,substeps,lost_after\n";
    for (const StabilityScene& scene : scenes)
        for (const MapKind kind : kMapKinds)
            for (const Method method : scene.maps->methods())
                for (std::size_t i = 0; i < scene.maps->x_values(kind).size(); ++i)
                    for (std::size_t j = 0; j < scene.maps->y_values(kind).size(); ++j) {
                        const auto found = scene.results.find(cell_id(kind, method, i, j));
                        if (found == scene.results.end()) continue;
                        const Json& cell = found->second;
                        text += fmt::format("{},{},{}", scene.name(), map_info(kind).id, method_info(method).name);
                        for (const char* key : {"x", "y", "substep_s", "omega", "damping_ratio", "over_limit"})
                            text += fmt::format(",{}", number(cell[key]));
                        text += fmt::format(",{},{},{},{},{}\n", cell["verdict"].get<std::string>(),
                                            number(cell["growth"]), number(cell["error"]), cell["substeps"].get<int>(),
                                            cell["lost_after"].get<int>());
                    }
    return text;
}

Json stability_json(const std::vector<StabilityScene>& scenes)
{
    Json list = Json::array();
    for (const StabilityScene& scene : scenes) {
        Json maps = Json::array(), extremes;
        for (const MapSummary& s : summarise(*scene.maps, scene.results))
            maps.push_back({{"map", map_info(s.kind).id},
                            {"method", method_info(s.method).name},
                            {"cells", s.cells},
                            {"missing", s.missing},
                            {"stable", s.stable},
                            {"wrong", s.wrong},
                            {"blown_up", s.blown_up},
                            {"lost", s.lost},
                            {"wrong_side", s.wrong_side},
                            {"within_band", s.near},
                            {"largest_deviation", s.limits > 0 ? Json(s.deviation) : Json()}});
        for (const ExtremeCase& c : scene.extremes) {
            const auto found = scene.results.find(c.id);
            if (found != scene.results.end()) extremes[c.id] = found->second;
        }
        list.push_back({{"scene", scene.name()},
                        {"holds", holds(scene) ? Json(*holds(scene)) : Json()},
                        {"maps", maps},
                        {"extremes", extremes}});
    }
    return list;
}

bool draw_stability(const StabilityScene& scene, const fs::path& directory)
{
    bool drawn = true;
    for (const MapKind kind : kMapKinds)
        drawn = plot_stability(*scene.maps, kind, scene.results, directory, picture_name(scene, kind)) && drawn;
    return drawn;
}

namespace {

std::string maps_section(const StabilityScene& scene, const fs::path& directory)
{
    std::vector<std::vector<std::string>> rows;
    for (const MapSummary& s : summarise(*scene.maps, scene.results))
        rows.push_back({std::string(map_info(s.kind).title), std::string(method_info(s.method).name),
                        std::to_string(s.cells), std::to_string(s.stable), std::to_string(s.wrong),
                        std::to_string(s.blown_up), std::to_string(s.lost), std::to_string(s.wrong_side),
                        deviation_text(s)});
    std::string text = html_table({"map", "method", "cells", "stable", "bounded but wrong", "blown up", "lost a number",
                                   "on the wrong side", "largest deviation of a limit"},
                                  rows);
    for (const MapKind kind : kMapKinds) {
        std::string caption(map_info(kind).title);
        if (kind == MapKind::mass) {
            caption += ", at a substep of";
            for (const Method method : scene.maps->methods())
                caption +=
                    fmt::format(" {:.3g} ms ({})", 1e3 * scene.maps->fixed_substep_s(method), method_info(method).name);
        }
        text += html_picture(directory / (picture_name(scene, kind) + ".svg"), html_text(caption));
    }
    return text;
}

std::string extremes_section(const StabilityScene& scene)
{
    std::vector<std::vector<std::string>> rows;
    for (const ExtremeCase& c : scene.extremes) {
        const auto found = scene.results.find(c.id);
        if (found == scene.results.end()) continue;
        const Json& r = found->second;
        const std::string outcome = r["outcome"];
        rows.push_back({html_text(c.what), std::string(method_info(c.method).name),
                        c.chosen_substeps ? "chosen by nuno" : "as given", c.expected(),
                        r["as_expected"].get<bool>() ? outcome : fmt::format("<b>{}</b>", outcome),
                        number(r["max_strain"]), number(r["max_speed"]), html_text(r["said"].get<std::string>())});
    }
    return fmt::format("<p>{}.</p>\n", html_text(extremes_line(scene))) +
           html_table({"asked for", "method", "substeps", "expected", "happened", "largest strain",
                       "highest speed, m/s", "said"},
                      rows);
}

constexpr std::string_view kHowToRead =
    "<p>Each cell is a run of its own: the cloth at rest is set in motion, in all its modes, with one substep and one "
    "set of parameters. <b>Stable</b>: no number is lost, motion does not grow, and over one period of the slowest "
    "motion of the whole sheet the run is within half of the motion from a fine run of the same start. <b>Bounded but "
    "wrong</b>: finite, but further off. <b>Blown up</b>: motion grows, by the share a substep that the colour says, "
    "or a number was lost. The black line is the limit that nuno predicts from the highest frequency of the cloth "
    "there, dashed the one from the safe bound on it; circles are limits measured by halving. Methods without a line "
    "have no limit.</p>\n";

}  // namespace

std::string stability_page(const std::vector<StabilityScene>& scenes, const SweepState& sweep,
                           const fs::path& directory)
{
    std::string body = html_missing(sweep.missing, sweep.count) + std::string(kHowToRead);
    for (const StabilityScene& scene : scenes)
        body += fmt::format("<h2>{}</h2>\n<h3>Maps</h3>\n{}<h3>Extremes</h3>\n{}", html_text(scene.name()),
                            maps_section(scene, directory), extremes_section(scene));
    body += "<h2>How it was measured</h2>\n<pre>" + html_text(sweep.header.dump(1)) + "</pre>\n";
    return html_page("nuno: stability", body);
}

}  // namespace nuno
