// `nuno scenes` and `nuno params`.
#include "app/list_commands.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/sim_params.h"
#include "render/view_params.h"
#include "scene/scene.h"

namespace nuno {

int list_scenes()
{
    const std::vector<std::string> names = scene_names();
    std::size_t width = 0;
    for (const std::string& name : names) width = std::max(width, name.size());
    for (const std::string& name : names) fmt::print("{:{}}  {}\n", name, width, load_scene(name).title);
    return 0;
}

int list_params(bool markdown)
{
    if (markdown) {
        fmt::print(
            "# Parameters\n\nWritten by `nuno params --markdown` from the tables in src/model/sim_params.def and "
            "src/render/view_params.def. Each is a key of a scene's [params] or [view], a `--set name=value`, and a "
            "slider of the viewer. A later one wins: default, scene, flag, slider.\n\n## Simulation\n{}\n## View\n{}",
            param_docs(sim_param_table()), param_docs(view_param_table()));
        return 0;
    }
    for (const ParamTable table : {sim_param_table(), view_param_table()})
        for (const ParamInfo& info : table) fmt::print("{:22} {}. {}\n", info.name, param_range_text(info), info.help);
    return 0;
}

}  // namespace nuno
