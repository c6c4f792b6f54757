// Numbers of sheets and bodies are those of the scene's own text, so that none is rounded.
#include "scene/scene_writer.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "core/error.h"
#include "core/text.h"

namespace nuno {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return fs::weakly_canonical(fs::absolute(file)).parent_path(); }

// `path`, relative to the folder `from`, seen from the folder `to`.
std::string moved_path(const std::string& path, const fs::path& from, const fs::path& to)
{
    if (path.empty() || fs::path(path).is_absolute()) return path;
    return fs::weakly_canonical(from / path).lexically_proximate(to).generic_string();
}

// Every path in the table, and in the tables in it.
void move_paths(toml::table& table, const fs::path& from, const fs::path& to)
{
    for (auto&& [key, node] : table) {
        if (toml::table* inner = node.as_table()) move_paths(*inner, from, to);
        if (toml::array* list = node.as_array())
            for (toml::node& entry : *list)
                if (toml::table* inner = entry.as_table()) move_paths(*inner, from, to);
        const bool is_path = key == "mesh" || key == "texture" || key == "pin_file";
        if (toml::value<std::string>* text = node.as_string(); text && is_path)
            *text = moved_path(text->get(), from, to);
    }
}

// A number as short as it can be written; 12.0 rather than 12 where it is no whole one by its type.
void insert(toml::table& table, std::string_view name, const std::string& text, bool quoted, bool real)
{
    const std::optional<double> number = quoted ? std::nullopt : parse_number(text);
    if (!number && !quoted)
        table.insert_or_assign(name, text == "true");
    else if (!number)
        table.insert_or_assign(name, text);
    else if (real || *number != double(std::int64_t(*number)))
        table.insert_or_assign(name, *number);
    else
        table.insert_or_assign(name, std::int64_t(*number));
}

toml::table params_table(const SimParams& params)
{
    toml::table table;
    for (const ParamInfo& info : sim_param_table())
        insert(table, info.name, param_text(info, param_value(info, &params)), info.type == ParamType::choice,
               info.type == ParamType::real);
    return table;
}

}  // namespace

std::string saved_scene_text(const Scene& scene, const SceneChanges& changes, const fs::path& path)
{
    if (scene.text.empty())
        throw Error(
            fmt::format("{}: scene {} came from no file, so it cannot be written as one", path.string(), scene.name));
    toml::table root = toml::parse(scene.text, scene.path.string());
    root.erase("check");
    move_paths(root, folder_of(scene.path), folder_of(path));
    root.insert_or_assign("state", changes.state);
    root.insert_or_assign("params", params_table(changes.params));
    toml::table view;
    for (const ViewSetting& setting : changes.view) insert(view, setting.name, setting.text, setting.quoted, false);
    root.insert_or_assign("view", std::move(view));
    std::ostringstream text;
    text << root << "\n";
    return text.str();
}

}  // namespace nuno
