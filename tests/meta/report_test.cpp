// Reports are what docs/report.md and its JSON schemas say.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "core/files.h"
#include "meta/markdown.h"
#include "meta/tree.h"
#include "model/sim_params.h"
#include "render/view_params.h"
#include "study/compare.h"
#include "support/program_run.h"

namespace nuno::meta {
namespace {

using Json = nlohmann::json;
using valijson::adapters::NlohmannJsonAdapter;

constexpr const char* kReportSchema = "docs/report.schema.json";
constexpr const char* kCompareSchema = "docs/compare.schema.json";

// What the schema has against a report, one line each; empty where it fits.
std::string complaints(const Json& report, const char* schema_file)
{
    const Json schema_json = Json::parse(read_file(schema_file));
    valijson::Schema schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(NlohmannJsonAdapter(schema_json), schema);
    valijson::ValidationResults results;
    valijson::Validator().validate(schema, NlohmannJsonAdapter(report), &results);
    std::string text;
    for (const valijson::ValidationResults::Error& error : results) {
        for (const std::string& part : error.context) text += part;
        text += " " + error.description + "\n";
    }
    return text;
}

Json short_report()
{
    const TemporaryDirectory directory;
    const std::string path = (directory.path() / "report.json").string();
    const ProgramResult run =
        run_program({"render", "seed", "--frames", "3", "--no-images", "--backend", "cpu", "--quiet", "--json", path});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(read_text(path));
}

TEST(Report, of_a_run_fits_its_schema)
{
    const Json report = short_report();
    EXPECT_EQ(complaints(report, kReportSchema), "");
    EXPECT_EQ(report.at("frames").size(), 3u);
    std::set<std::string> told, declared;
    for (const auto& [name, value] : report.at("params").items()) told.insert(name);
    for (const ParamTable table : {sim_param_table(), view_param_table()})
        for (const ParamInfo& info : table) declared.emplace(info.name);
    EXPECT_EQ(told, declared);
}

TEST(Report, that_is_broken_does_not_fit)
{
    const Json report = short_report();
    const auto broken = [&](auto change) {
        Json copy = report;
        change(copy);
        return complaints(copy, kReportSchema);
    };
    EXPECT_NE(broken([](Json& r) { r.erase("summary"); }), "");
    EXPECT_NE(broken([](Json& r) { r["remark"] = 1; }), "");
    EXPECT_NE(broken([](Json& r) { r["machine"].erase("software_gl"); }), "");
    EXPECT_NE(broken([](Json& r) { r["frames"][1]["time_s"] = "0.1"; }), "");
    EXPECT_NE(broken([](Json& r) { r["frames"][1]["count"]["contacts"] = -1; }), "");
    EXPECT_NE(broken([](Json& r) { r["frames"][2]["stage_ms"].erase("solve"); }), "");
    EXPECT_NE(broken([](Json& r) { r["summary"]["state_hash"] = "xyz"; }), "");
    EXPECT_NE(broken([](Json& r) { r["params"]["damping"] = nullptr; }), "");
}

TEST(Report, of_a_comparison_fits_its_schema)
{
    ComparePoint point;
    point.scene = "seed";
    point.cpu.frame_ms = point.gpu.frame_ms = 1;
    const Json machine = {{"cpu", "c"},         {"threads", 2},        {"gl_vendor", "v"},
                          {"gl_renderer", "r"}, {"gl_version", "4.3"}, {"software_gl", true}};
    Json report = {{"program", {{"name", "nuno"}, {"version", "0.1.0"}, {"commit", "unknown"}}},
                   {"machine", machine},
                   {"points", Json::parse(compare_json({point}).dump())}};
    EXPECT_EQ(complaints(report, kCompareSchema), "");
    report["points"][0].erase("gpu_over_cpu");
    EXPECT_NE(complaints(report, kCompareSchema), "");
}

// The names of all properties that a schema declares, wherever.
void collect_properties(const Json& schema, std::set<std::string>& names)
{
    if (schema.is_object() && schema.contains("properties"))
        for (const auto& [name, value] : schema.at("properties").items()) names.insert(name);
    for (const Json& part : schema)
        if (part.is_structured()) collect_properties(part, names);
}

TEST(Report, every_field_is_on_its_page)
{
    const std::pair<const char*, const char*> documents[] = {{kReportSchema, "docs/report.md"},
                                                             {kCompareSchema, "docs/compare.md"}};
    for (const auto& [schema, page] : documents) {
        std::set<std::string> fields;
        collect_properties(Json::parse(read_file(schema)), fields);
        EXPECT_GT(fields.size(), 10u);
        const std::vector<std::string> words = code_words(read_file(page));
        for (const std::string& field : fields)
            EXPECT_NE(std::find(words.begin(), words.end(), field), words.end()) << page << " does not tell " << field;
    }
}

}  // namespace
}  // namespace nuno::meta
