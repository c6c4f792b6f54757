// What the pointer has taken of the scene: a vertex of the cloth, or a body.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/pick_view.h"
#include "app/point_drag.h"
#include "sim/simulation.h"

namespace nuno {

// What lies under a place of the picture.
struct UnderPointer
{
    std::optional<std::uint32_t> vertex;  // that is seen there, or within `reach` of the place
    std::optional<std::size_t> body;      // frontmost there, the cloth left out
    float body_depth = kBehind;
};
UnderPointer look_under(Simulation& simulation, const PickView& view, glm::vec2 place, float reach);

class ViewerGrip
{
  public:
    // Takes what is seen under the pointer, or the body whatever lies before it; none where there is nothing to take.
    // Error where a body cannot be moved now.
    static std::optional<ViewerGrip> take(Simulation& simulation, const PickView& view, glm::vec2 place,
                                          const UnderPointer& under, bool body_first);

    // Moves where it is wanted under the pointer.
    void follow(Simulation& simulation, const PickView& view, glm::vec2 place);
    void release(Simulation& simulation) const;

    std::string name() const;  // `vertex 12`, `body 0`
    // Where the point is that was taken, none where the cloth has no such vertex now, and where it is wanted [m].
    std::optional<glm::vec3> place(Simulation& simulation) const;
    glm::vec3 target() const { return drag_.target(); }

  private:
    ViewerGrip(Simulation& simulation, bool is_body, std::size_t number, const PointDrag& drag);
    bool hold(Simulation& simulation) const;

    bool is_body_;
    std::size_t number_;
    PointDrag drag_;
    glm::dvec3 start_way_{0, 0, 0};  // of a body when it was taken, from where the scene has it
};

}  // namespace nuno
