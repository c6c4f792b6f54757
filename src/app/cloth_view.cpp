// The view of a simulation.
#include "app/cloth_view.h"

namespace nuno {

SceneView make_scene_view(const Simulation& simulation)
{
    const ClothModel& model = simulation.model();
    std::vector<DrawnSheet> sheets;
    for (std::size_t i = 0; i < model.sheets.size(); ++i)
        sheets.push_back(
            {model.sheets[i].first_face, model.sheets[i].face_count, simulation.scene().sheets[i].texture});
    return SceneView({model.vertex_count(), model.faces, model.uvs, sheets, model.rest_positions, &model.seams});
}

}  // namespace nuno
