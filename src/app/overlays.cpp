// Which overlays are asked for.
#include "app/overlays.h"

#include "app/overlay_heat.h"
#include "app/overlay_marks.h"

namespace nuno {
namespace {

bool any_asked(const ViewParams& view)
{
    return view.heat != Heat::none || view.show_wireframe || view.show_springs || view.show_pins ||
           view.show_contacts || view.show_boxes || view.show_wind;
}

bool shows_tree(const ViewParams& view, const SimParams& params)
{
    return (view.show_boxes || view.heat == Heat::culled) && params.collision >= CollisionLevel::discrete;
}

}  // namespace

const Overlay* Overlays::gather(const ViewParams& view, Simulation& simulation)
{
    const bool asked = any_asked(view), with_tree = asked && shows_tree(view, simulation.params());
    if (!asked && legend_.empty()) return nullptr;
    overlay_ = {};
    legend_ = {};
    if (!asked || !view.show_wireframe) edges_ = {};
    if (!with_tree) tree_.reset();
    if (!asked) return nullptr;
    if (with_tree && !tree_) tree_ = std::make_unique<TreePicture>(simulation.model());
    overlay_.heat = heat_of(view, simulation, tree_.get(), legend_);
    gather_marks(view, simulation);
    return &overlay_;
}

void Overlays::gather_marks(const ViewParams& view, Simulation& simulation)
{
    const MarkSheet sheet{overlay_, legend_};
    const ClothModel& model = simulation.model();
    const SimParams& params = simulation.params();
    const std::span<const glm::vec4> positions = simulation.state().positions;
    if (view.show_wireframe) {
        if (edges_.empty()) edges_ = edges_of(model.faces);
        mark_wireframe(edges_, positions, sheet);
    }
    if (view.show_springs) mark_springs(model, params, positions, sheet);
    if (view.show_wind) mark_wind(params, simulation.time_s(), positions, sheet);
    if (view.show_boxes && tree_) mark_boxes(*tree_, view.box_depth, params, positions, sheet);
    if (view.show_boxes && !tree_) legend_.remarks.emplace_back("no boxes: collision here needs no tree");
    if (view.show_pins) mark_pins(model, positions, sheet);
    if (view.show_contacts) mark_contacts(simulation, positions, sheet);
}

}  // namespace nuno
