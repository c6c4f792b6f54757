// Reads scenes from .toml files.
#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "core/version.h"
#include "scene/body_tables.h"
#include "scene/toml_table.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

fs::path scene_directory() { return root_directory() / "assets" / "scenes"; }

// A path in a scene file is relative to the folder of that file.
fs::path beside(const fs::path& scene_path, const std::string& text)
{
    return text.empty() ? fs::path() : (scene_path.parent_path() / text).lexically_normal();
}

PinSpec read_pins(TomlTable& table, const fs::path& scene_path)
{
    PinSpec spec;
    spec.file = beside(scene_path, table.text("pin_file", ""));
    const toml::array* pins = table.array("pins");
    spec.where = table.where("pins");
    if (!pins) return spec;
    for (const toml::node& pin : *pins) {
        if (const auto place = pin.value_exact<std::string>())
            spec.places.push_back(*place);
        else if (const auto vertex = pin.value_exact<std::int64_t>(); vertex && *vertex >= 0 && *vertex <= 0xffffffff)
            spec.vertices.push_back(static_cast<std::uint32_t>(*vertex));
        else
            table.fail("pins",
                       "a list of vertex numbers, and of places (top_left, top, left, ...) or groups of the mesh");
    }
    return spec;
}

// handles = [{ name = "left", pins = ["left"] }]
void read_handles(TomlTable& table, const std::string& file_name, const fs::path& scene_path, SheetSpec& sheet)
{
    const toml::array* list = table.array("handles");
    if (!list) return;
    for (const toml::node& node : *list) {
        if (!node.is_table()) table.fail("handles", "a list of { name = \"...\", pins = [...] }");
        TomlTable entry(*node.as_table(), file_name);
        const std::string handle = entry.text("name", "");
        sheet.pins.push_back(read_pins(entry, scene_path));
        sheet.pins.back().handle = handle;
        entry.finish();
        if (handle.empty()) entry.fail("name", "the name of a [[handle]]");
        if (!entry.has("pins") && !entry.has("pin_file"))
            entry.fail("pins", "a list of the vertices that the handle carries");
    }
}

SheetSpec read_sheet(TomlTable table, const std::string& file_name, const fs::path& scene_path)
{
    SheetSpec sheet;
    sheet.where = table.where();
    sheet.name = table.text("name", "cloth");
    sheet.mesh = beside(scene_path, table.text("mesh", ""));
    sheet.texture = beside(scene_path, table.text("texture", ""));
    sheet.columns = table.whole("columns", 0);
    sheet.rows = table.whole("rows", sheet.columns);
    sheet.origin = table.vector("origin", {0, 0, 0});
    sheet.across = table.vector("across", {1, 0, 0});
    sheet.down = table.vector("down", {0, -1, 0});
    sheet.pleats = table.whole("pleats", 0);
    sheet.pleat_angle = static_cast<float>(table.number("pleat_angle", 60));
    sheet.pins.push_back(read_pins(table, scene_path));
    read_handles(table, file_name, scene_path, sheet);
    table.finish();
    if (!(sheet.pleat_angle >= 0 && sheet.pleat_angle < 90))
        table.fail("pleat_angle", "0 or more and less than 90 degrees");
    if (sheet.mesh.empty() == (sheet.columns == 0) || (sheet.pleats > 0 && sheet.columns == 0))
        throw Error(fmt::format("{}: a sheet needs either columns (and rows) of a grid or a mesh file", sheet.where));
    const auto side_fits = [](int count) { return count >= 2 && count <= 2048; };
    if (sheet.mesh.empty() && (!side_fits(sheet.columns) || !side_fits(sheet.rows)))
        throw Error(fmt::format("{}: a grid of {} x {} vertices is not possible; give 2 to 2048 for columns and rows",
                                sheet.where, sheet.columns, sheet.rows));
    return sheet;
}

EndCheck read_check(TomlTable table)
{
    EndCheck check;
    check.frames = table.whole("frames", 0);
    if (check.frames == 0) table.fail("frames", "the frame at which the check applies, 1 or more");
    for (const MetricInfo& metric : metric_table()) {
        const toml::array* bounds = table.array(metric.name);
        if (!bounds) continue;
        MetricBound bound{&metric, 0, 0, table.where(metric.name)};
        const auto low = bounds->size() == 2 ? bounds->get(0)->value<double>() : std::nullopt;
        const auto high = bounds->size() == 2 ? bounds->get(1)->value<double>() : std::nullopt;
        if (!low || !high || !(*low <= *high)) table.fail(metric.name, "two numbers, [least, most]; inf is possible");
        bound.min = *low;
        bound.max = *high;
        check.bounds.push_back(bound);
    }
    table.finish();
    return check;
}

constexpr int kFormat = 1;  // of scene files; a higher one says what this program does not know

// Before anything else is read, for a newer file has keys that would be told to be misspelt.
void check_format(TomlTable& file)
{
    const int format = file.whole("format", kFormat);
    if (format == 0) file.fail("format", fmt::format("{}", kFormat));
    if (format > kFormat)
        throw Error(
            fmt::format("{}: the scene has format {}, from a newer nuno; this one ({}) knows format {}: run it "
                        "with a newer nuno, or write it anew for this one",
                        file.where("format"), format, kVersion, kFormat));
}

Scene read_scene(const toml::table& root, const fs::path& path)
{
    const std::string file_name = path.string();
    TomlTable file(root, file_name);
    Scene scene;
    scene.name = path.stem().string();
    scene.path = path;
    check_format(file);
    scene.title = file.text("title", "");
    scene.state = beside(path, file.text("state", ""));
    if (const toml::table* params = file.table("params"))
        TomlTable(*params, file_name).read_params(sim_param_table(), &scene.params);
    if (const toml::table* view = file.table("view"))
        for (const TomlTable::Entry& entry : TomlTable(*view, file_name).entries())
            scene.view.push_back({entry.name, entry.text, entry.where, entry.quoted});
    file.for_each_table("sheet",
                        [&](TomlTable t) { scene.sheets.push_back(read_sheet(std::move(t), file_name, path)); });
    scene.bodies = read_bodies(file, file_name, path);
    if (const toml::table* check = file.table("check")) scene.check = read_check(TomlTable(*check, file_name));
    file.finish();
    if (scene.sheets.empty()) throw Error(fmt::format("{}: a scene needs at least one [[sheet]]", file_name));
    return scene;
}

}  // namespace

std::vector<std::string> scene_names()
{
    std::vector<std::string> names;
    std::error_code status;
    for (const fs::directory_entry& entry : fs::directory_iterator(scene_directory(), status))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    if (status)
        throw Error(fmt::format("{}: cannot be listed ({}); set NUNO_ROOT to nuno's folder", scene_directory().string(),
                                status.message()));
    std::sort(names.begin(), names.end());
    return names;
}

Scene load_scene(std::string_view name_or_path)
{
    fs::path path(name_or_path);
    if (path.extension() != ".toml") {
        const std::vector<std::string> names = scene_names();
        if (std::find(names.begin(), names.end(), name_or_path) == names.end()) {
            const std::vector<std::string_view> views(names.begin(), names.end());
            throw Error(
                fmt::format("scene {}: there is none of that name; the nearest is {}; possible are {}, or the path of "
                            "a .toml file",
                            name_or_path, nearest_name(name_or_path, views), join_choices(views)));
        }
        path = scene_directory() / (std::string(name_or_path) + ".toml");
    }
    const std::string text = read_text(path);
    try {
        Scene scene = read_scene(toml::parse(text, path.string()), path);
        scene.text = text;
        return scene;
    } catch (const toml::parse_error& error) {
        throw Error(
            fmt::format("{}:{}: is not TOML: {}", path.string(), error.source().begin.line, error.description()));
    }
}

}  // namespace nuno
