// The start of a run: whether the cloth intersects itself there, and what was done about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "collision/tangle.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

struct StartCheck
{
    struct Untangling
    {
        TangleCounts before;
        int steps = 0;
        float largest_move = 0;  // [m]
    };

    bool looked = false;                   // only where the level of collision, or `untangle`, asks for it
    TangleCounts tangled;                  // as the run begins
    std::optional<Untangling> untangling;  // where there was something to do
    std::vector<std::string> places;       // of the first few
};

// Looks at the positions (xyz [m], w = 0 where pinned) if the level of collision is `speculative` or above; takes them
// apart first where `untangle` is set.
StartCheck check_start(const ClothModel& model, const SimParams& params, std::vector<glm::vec4>& positions,
                       ThreadPool& pool);

// What to tell the user, without the name of the scene; nothing where the start is clean and was.
std::vector<std::string> start_remarks(const StartCheck& check, const SimParams& params);

}  // namespace nuno
