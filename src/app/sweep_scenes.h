// The scenes of a sweep, as the header of its points keeps them: whoever joins parts of it makes them again from there.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line.h"

namespace nuno {

struct SweepScene
{
    std::string source;  // name or path, as given
    Scene scene;
    SimParams params;
};

// Error where two scenes have one name.
void require_distinct(const std::vector<SweepScene>& scenes);

// By name: source, text of the file, parameters.
nlohmann::ordered_json scenes_json(const std::vector<SweepScene>& scenes);

// The same from a header's "scenes". Error where a scene cannot be read or is another one here.
std::vector<SweepScene> scenes_of(const nlohmann::ordered_json& header);

// "0.1.0 (commit)", as headers have it; and an error where one has another, whose points may mean something else.
std::string sweep_version();
void require_this_version(const nlohmann::ordered_json& header);

}  // namespace nuno
