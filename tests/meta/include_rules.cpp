// Checks an #include against the table of floors and the table of third-party libraries.
#include "meta/include_rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <span>

#include "meta/tree.h"

namespace nuno::meta {

namespace {

struct Folder
{
    std::string_view path;
    int floor;
    int step = 0;  // within a floor's folder: what its own folders may include of each other
};

constexpr std::array kFolders{
    Folder{"src/core/", 0},
    Folder{"shaders/shared/", 0},
    Folder{"src/model/", 1},
    Folder{"src/gl/", 1},
    Folder{"src/scene/", 2},
    Folder{"src/collision/ccd/", 2, 0},
    Folder{"src/collision/tree/", 2, 0},
    Folder{"src/collision/", 2, 1},
    Folder{"src/render/", 2},
    Folder{"src/solver/base/", 2, 0},
    Folder{"src/solver/explicit/", 2, 1},
    Folder{"src/solver/implicit/", 2, 1},
    Folder{"src/solver/vbd/", 2, 1},
    Folder{"src/solver/xpbd/", 2, 1},
    Folder{"src/solver/", 2, 2},
    Folder{"src/sim/", 3},
    Folder{"src/study/", 4},
    Folder{"src/app/", 5},
    Folder{"shaders/sim/", 1},
    Folder{"shaders/render/", 1},
};

// Where includes that start with `prefix` may stand: below one of the paths in `allowed`, where * is any folder, and
// nowhere else.
struct Confinement
{
    std::string_view prefix;
    std::array<std::string_view, 6> allowed;
};

constexpr std::array kConfinements{
    Confinement{"imgui", {"src/app/"}},
    Confinement{"backends/imgui", {"src/app/"}},
    Confinement{"GLFW/", {"src/app/"}},
    Confinement{"CLI/", {"src/app/"}},
    Confinement{"glad/", {"src/gl/", "src/render/", "src/solver/*gpu_", "src/app/"}},
    Confinement{"GL/", {"src/gl/", "src/render/", "src/solver/*gpu_", "src/app/"}},
    Confinement{"KHR/", {"src/gl/"}},
    Confinement{"EGL/", {"src/gl/"}},
    Confinement{"gl/", {"src/gl/", "src/render/", "src/solver/*gpu_", "src/sim/", "src/study/", "src/app/"}},
    Confinement{"toml++/", {"src/scene/"}},
    Confinement{"gtest/", {}},
    Confinement{"benchmark/", {}},
};

const Folder* folder_of(std::string_view path)
{
    const auto found = std::find_if(kFolders.begin(), kFolders.end(),
                                    [&](const Folder& folder) { return path.starts_with(folder.path); });
    return found == kFolders.end() ? nullptr : &*found;
}

bool lies_below(std::string_view file, std::string_view path)
{
    const std::size_t star = path.find('*');
    if (star == path.npos) return file.starts_with(path);
    const std::size_t name = file.rfind('/') + 1;
    return file.starts_with(path.substr(0, star)) && file.substr(name).starts_with(path.substr(star + 1));
}

bool may_stand_in(std::span<const std::string_view> allowed, std::string_view file)
{
    return std::any_of(allowed.begin(), allowed.end(),
                       [&](std::string_view path) { return !path.empty() && lies_below(file, path); });
}

// src/solver/ of src/solver/xpbd/cpu_xpbd.cpp.
std::string_view house_of(std::string_view folder) { return folder.substr(0, folder.find('/', 4)); }

// The path from the root that a quoted include of `file` names. Shaders may leave out "shaders/", a name without a
// folder lies beside the file.
std::string target_of(std::string_view file, const std::string& include)
{
    if (include.find('/') == std::string::npos) return std::string(file.substr(0, file.rfind('/') + 1)) + include;
    if (include.starts_with("shaders/")) return include;
    if (file.starts_with("shaders/") && folder_of("shaders/" + include)) return "shaders/" + include;
    return "src/" + include;
}

}  // namespace

std::vector<Include> read_includes(std::string_view text)
{
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^">]+)[">])");
    std::vector<Include> includes;
    int number = 0;
    for (const std::string& line : lines_of(text)) {
        ++number;
        std::smatch match;
        if (std::regex_search(line, match, pattern)) includes.push_back({number, match[2], match[1] == "<"});
    }
    return includes;
}

std::optional<std::string> include_breach(std::string_view file, const Include& include)
{
    const Folder* from = folder_of(file);
    if (!from) return "lies in no folder of the architecture";
    for (const Confinement& rule : kConfinements)
        if (include.path.starts_with(rule.prefix) && !may_stand_in(rule.allowed, file))
            return include.path + " may not be included here";
    if (include.angled) {
        if (file.starts_with("shaders/")) return "<" + include.path + "> is not GLSL";
        return std::nullopt;
    }

    // Text that the program makes from a parameter table when it compiles the shader.
    if (file.starts_with("shaders/") && include.path.starts_with("generated/")) return std::nullopt;

    const std::string target = target_of(file, include.path);
    const Folder* to = folder_of(target);
    if (!to) return "\"" + include.path + "\" starts with no folder of the architecture";
    // A parameter table is read as data by the shaders too.
    if (file.starts_with("shaders/") && target.starts_with("src/") && !target.ends_with(".def"))
        return "a shader includes C++ (" + include.path + ")";
    if (file.starts_with("src/") && target.starts_with("shaders/") && !target.starts_with("shaders/shared/"))
        return "C++ includes a shader (" + include.path + ")";
    if (to == from || to->floor < from->floor || target.ends_with(".def")) return std::nullopt;
    if (house_of(to->path) == house_of(from->path) && to->step < from->step) return std::nullopt;
    return include.path + " is on floor " + std::to_string(to->floor) + ", this file on floor " +
           std::to_string(from->floor);
}

}  // namespace nuno::meta
