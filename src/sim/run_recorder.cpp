// Gathers the frames of a run.
#include "sim/run_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/quantile.h"
#include "core/version.h"

namespace nuno {
namespace {

using Json = nlohmann::ordered_json;

Json counts_json(const CollisionCounts& count)
{
    return {{"pairs_tested", count.pairs_tested},
            {"pairs_culled", count.pairs_culled},
            {"contacts", count.contacts},
            {"impacts", count.impacts},
            {"zones", count.zones},
            {"rollbacks", count.rollbacks},
            {"standstills", count.standstills},
            {"largest_zone", count.largest_zone},
            {"held_back", count.held_back},
            {"lost_m", count.lost_m},
            {"touching", count.touching},
            {"unresolved", count.unresolved}};
}

// Null where nothing asked for a look at the start.
Json start_json(const StartCheck& start)
{
    if (!start.looked) return nullptr;
    const auto& done = start.untangling;
    return {{"crossing", start.tangled.crossing},
            {"touching", start.tangled.touching},
            {"pairs_before_untangle", done ? done->before.all() : start.tangled.all()},
            {"untangle_steps", done ? done->steps : 0},
            {"untangle_largest_move_m", done ? done->largest_move : 0.0f}};
}

// Null where there was no --check.
Json check_json(const CheckCounts& check)
{
    if (check.every == 0) return nullptr;
    return {{"every", check.every},
            {"poses", check.poses},
            {"crossing", check.crossing},
            {"touching", check.touching},
            {"passed_through", check.passed_through},
            {"first_frame", check.first_frame < 0 ? Json(nullptr) : Json(check.first_frame)}};
}

Json frame_json(const FrameRecord& record)
{
    const FrameStats& stats = record.stats;
    const Diagnostics& d = record.diagnostics;
    Json stages;
    for (const StageInfo& stage : kStages) stages[stage.name] = stats.stage_ms.*stage.ms;
    return {{"frame", stats.frame},
            {"time_s", stats.time_s},
            {"substeps", stats.substeps},
            {"stage_ms", stages},
            {"count", counts_json(stats.count)},
            {"energy_j", {{"kinetic", d.kinetic_j}, {"gravity", d.gravity_j}, {"elastic", d.elastic_j}}},
            {"max_strain", d.max_strain},
            {"max_speed", d.max_speed}};
}

// Null where the numbers went bad; a substep is null where any, or none, is stable.
Json stability_json(Simulation& simulation)
{
    const std::optional<PresentStability> stability = simulation.stability();
    if (!stability) return nullptr;
    const auto limit = [](double s) { return s > 0 && s < kAnySubstep ? Json(s) : Json(nullptr); };
    Json limits;
    for (std::size_t i = 0; i < kExplicitMethods.size(); ++i)
        limits[choice_names(Method{})[std::size_t(kExplicitMethods[i])]] = limit(stability->stable_substep_s[i]);
    return {{"omega_max", stability->omega_max},
            {"omega_bound_at_rest", stability->omega_bound},
            {"substep_s", double(substep_s(simulation.params()))},
            {"largest_stable_substep_s", limit(stability->largest_stable_substep_s)},
            {"largest_stable_substep_s_of", limits},
            {"least_stable_substeps", stability->least_substeps}};
}

Json summary_json(const RunRecorder& recorder, Simulation& simulation)
{
    Json stages;
    const auto add_stage = [&](std::string_view name, auto ms_of) {
        std::vector<double> ms;
        // The start, frame 0, simulates nothing.
        for (const FrameRecord& record : recorder.frames())
            if (record.stats.frame > 0) ms.push_back(ms_of(record.stats.stage_ms));
        stages[name] = {{"median", quantile(ms, 0.5)}, {"p95", quantile(ms, 0.95)}};
    };
    for (const StageInfo& stage : kStages) add_stage(stage.name, [&](const StageTimes& t) { return t.*stage.ms; });
    add_stage("simulation", simulation_ms);
    const RunMetrics metrics = recorder.metrics();
    std::uint64_t touching = 0;
    for (const FrameRecord& record : recorder.frames()) touching += record.stats.count.touching;
    return {{"frames", recorder.frames().size()},
            {"stage_ms", stages},
            {"worst_strain", metrics.peak_strain},
            {"total_contacts", static_cast<std::uint64_t>(metrics.contacts)},
            {"total_touching", touching},
            {"total_unresolved", static_cast<std::uint64_t>(metrics.passed_through)},
            {"tangled_at_start", start_json(simulation.start_check())},
            {"check", check_json(recorder.check)},
            {"stability", stability_json(simulation)},
            {"state_hash", hash_text(simulation.state())}};
}

}  // namespace

void RunRecorder::add(const FrameStats& stats, const Diagnostics& diagnostics)
{
    frames_.push_back({stats, diagnostics});
}

RunMetrics RunRecorder::metrics() const
{
    RunMetrics m;
    if (frames_.empty()) return m;
    m.frames = double(frames_.size());
    m.lowest = frames_.front().diagnostics.lowest.y;
    for (const FrameRecord& record : frames_) {
        const CollisionCounts& count = record.stats.count;
        m.contacts += double(count.contacts);
        m.peak_contacts = std::max(m.peak_contacts, double(record.stats.peak_contacts));
        m.passed_through += double(count.unresolved);
        m.peak_strain = std::max(m.peak_strain, record.diagnostics.max_strain);
        m.peak_speed = std::max(m.peak_speed, record.diagnostics.max_speed);
        m.lowest = std::min(m.lowest, record.diagnostics.lowest.y);
    }
    const Diagnostics& last = frames_.back().diagnostics;
    m.final_strain = last.max_strain;
    m.final_speed = last.max_speed;
    m.final_lowest = last.lowest.y;
    m.final_highest = last.highest.y;
    m.final_kinetic_j = last.kinetic_j;
    return m;
}

std::string cpu_name()
{
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

Json machine_json(const MachineInfo& machine)
{
    return {{"cpu", machine.cpu},
            {"threads", machine.threads},
            {"gl_vendor", machine.gl_vendor},
            {"gl_renderer", machine.gl_renderer},
            {"gl_version", machine.gl_version},
            {"software_gl", machine.software_gl}};
}

std::string hash_text(const ClothState& state) { return fmt::format("{:016x}", state_hash(state)); }

Json params_json(ParamTable table, const void* block)
{
    Json json = Json::object();
    for (const ParamInfo& info : table) {
        const double value = param_value(info, block);
        switch (info.type) {
        case ParamType::real: json[info.name] = value; break;
        case ParamType::integer: json[info.name] = static_cast<std::int64_t>(value); break;
        case ParamType::boolean: json[info.name] = value != 0; break;
        case ParamType::choice: json[info.name] = param_text(info, value); break;
        }
    }
    return json;
}

std::string frames_csv(const RunRecorder& recorder)
{
    std::string text;
    for (const FrameRecord& record : recorder.frames()) {
        std::vector<std::string> names, values;
        const Json frame = frame_json(record);
        for (const auto& [name, value] : frame.items()) {
            if (!value.is_object()) {
                names.push_back(name);
                values.push_back(value.dump());
                continue;
            }
            for (const auto& [inner, number] : value.items()) {
                names.push_back(fmt::format("{}.{}", name, inner));
                values.push_back(number.dump());
            }
        }
        if (text.empty()) text = fmt::format("{}\n", fmt::join(names, ","));
        text += fmt::format("{}\n", fmt::join(values, ","));
    }
    return text;
}

Json make_report(const RunRecorder& recorder, Simulation& simulation, const MachineInfo& machine,
                 const Json& view_params)
{
    Json params = params_json(sim_param_table(), &simulation.params());
    if (view_params.is_object()) params.update(view_params);
    Json frames = Json::array();
    for (const FrameRecord& record : recorder.frames()) frames.push_back(frame_json(record));
    return {{"program", {{"name", "nuno"}, {"version", kVersion}, {"commit", kCommit}}},
            {"machine", machine_json(machine)},
            {"scene", simulation.scene().name},
            {"params", params},
            {"frames", frames},
            {"summary", summary_json(recorder, simulation)}};
}

}  // namespace nuno
