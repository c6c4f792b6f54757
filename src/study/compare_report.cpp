// The comparison as a table and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/compare.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

double collision_ms(const StageTimes& t) { return t.refit + t.query + t.respond; }
double transfer_ms(const StageTimes& t) { return t.readback + t.upload; }

Json cost_json(const BackendCost& cost)
{
    Json stages;
    for (const StageInfo& stage : kStages) stages[stage.name] = cost.stage_ms.*stage.ms;
    return {{"frame_ms", cost.frame_ms},
            {"stage_ms", stages},
            {"ns_per_particle_and_substep", cost.ns_per_particle_and_substep}};
}

}  // namespace

std::string compare_table(const std::vector<ComparePoint>& points, bool software_gl)
{
    std::string table =
        fmt::format("{:9} {:>5} {:16} {:>8} | {:^31} | {:^31} | {:>7} | {:^35} | {}\n", "", "", "", "substeps",
                    "CPU, ms a frame", software_gl ? "GPU (software: a CPU's), ms" : "GPU, ms a frame", "GPU/CPU",
                    "largest difference after, m", "hashes");
    const char* stages = "frame   solve   move collide";
    table += fmt::format("{:9} {:>5} {:16} {:>8} | {:>31} | {:>31} | {:>7} |", "scene", "size", "method", "a frame",
                         stages, stages, "frame");
    for (const int substeps : kComparedSubsteps) table += fmt::format(" {:>8}", substeps);
    table += " | agree\n";
    for (const ComparePoint& p : points) {
        table += fmt::format("{:9} {:>5} {:16} {:>8} |", p.scene, p.size > 0 ? std::to_string(p.size) : "mesh",
                             p.method_name(), p.substeps);
        for (const BackendCost* c : {&p.cpu, &p.gpu})
            table += fmt::format(" {:8.3f} {:7.3f} {:6.3f} {:7.3f} |", c->frame_ms, c->stage_ms.solve,
                                 transfer_ms(c->stage_ms), collision_ms(c->stage_ms));
        table += fmt::format(" {:7.2f} |", p.ratio());
        for (const double d : p.largest_difference_m) table += d < 0 ? " no number" : fmt::format(" {:8.2g}", d);
        table += p.substep_hashes_agree && p.frame_hashes_agree ? " | yes\n" : " | NO\n";
    }
    return table;
}

Json compare_json(const std::vector<ComparePoint>& points)
{
    Json list = Json::array();
    for (const ComparePoint& p : points) {
        Json differences;
        for (std::size_t k = 0; k < kComparedSubsteps.size(); ++k)
            differences[std::to_string(kComparedSubsteps[k])] = p.largest_difference_m[k];
        list.push_back({{"scene", p.scene},
                        {"size", p.size},
                        {"particles", p.particles},
                        {"method", p.method_name()},
                        {"substeps", p.substeps},
                        {"timed_frames", p.timed_frames},
                        {"cpu", cost_json(p.cpu)},
                        {"gpu", cost_json(p.gpu)},
                        {"gpu_over_cpu", p.ratio()},
                        {"largest_difference_m_after_substeps", differences},
                        {"failure", p.failure},
                        {"substep_hashes_agree", p.substep_hashes_agree},
                        {"frame_hashes_agree", p.frame_hashes_agree}});
    }
    return list;
}

namespace {

BackendCost cost_of(const Json& json)
{
    BackendCost cost;
    for (const StageInfo& stage : kStages) cost.stage_ms.*stage.ms = json.at("stage_ms").at(stage.name);
    cost.frame_ms = json.at("frame_ms");
    cost.ns_per_particle_and_substep = json.at("ns_per_particle_and_substep");
    return cost;
}

}  // namespace

ComparePoint compare_point_of(const Json& json)
{
    ComparePoint p;
    p.scene = json.at("scene");
    p.size = json.at("size");
    p.particles = json.at("particles");
    const auto names = choice_names(Method{});
    p.method = Method(std::find(names.begin(), names.end(), json.at("method").get<std::string>()) - names.begin());
    p.substeps = json.at("substeps");
    p.timed_frames = json.at("timed_frames");
    p.cpu = cost_of(json.at("cpu"));
    p.gpu = cost_of(json.at("gpu"));
    for (std::size_t k = 0; k < kComparedSubsteps.size(); ++k)
        p.largest_difference_m[k] =
            json.at("largest_difference_m_after_substeps").at(std::to_string(kComparedSubsteps[k]));
    p.failure = json.at("failure");
    p.substep_hashes_agree = json.at("substep_hashes_agree");
    p.frame_hashes_agree = json.at("frame_hashes_agree");
    return p;
}

}  // namespace nuno
