// What a scene needs of all that it asks for: every part left out once, with what that changes and saves
// (docs/explain.md).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "study/scene_study.h"
#include "study/setting.h"
#include "study/sweep.h"

namespace nuno {

// A part that the scene has, left out.
struct LeftOut
{
    std::string part;
    Setting set;               // that leaves it out
    double change_share = 0;   // rms, of the size of the cloth: of positions over the horizon, or of the mean centre of
                               // the cloth over the second half of the whole scene, whichever is more
    double ms_per_frame = 0;   // median over the whole scene
    double intersections = 0;  // pairs of faces a pose
    double strain = 0;         // the largest of the whole scene
    std::string failure;       // it went bad without
    bool is_needed = true;     // the change is over the tolerance, layers intersect that did not, or it went bad
};

struct Explanation
{
    std::string scene;
    double tolerance_share = 0;
    double ms_per_frame = 0, intersections = 0, strain = 0;  // with everything
    std::vector<LeftOut> parts;
    std::vector<std::string> absent;  // what the scene does not ask for, and costs nothing
};

// `progress` is called before each part; where it is false, what is done is all there is. Error where the scene goes
// bad with everything.
Explanation explain_scene(SceneStudy& study, double tolerance_share, const SweepProgress& progress);

std::string explain_table(const Explanation& explanation);
nlohmann::ordered_json explain_json(const Explanation& explanation);

}  // namespace nuno
