// Which body the pointer is on.
#pragma once

#include <cstddef>
#include <optional>

#include "app/pick_view.h"
#include "model/body.h"

namespace nuno {

struct BodyHit
{
    std::size_t body;  // in the order of placed_bodies()
    float depth;       // as project() has it
};

// The frontmost body at `place`, as it is drawn at a time; planes are left out.
std::optional<BodyHit> pick_body(const Bodies& bodies, double time_s, const PickView& view, glm::vec2 place);

}  // namespace nuno
