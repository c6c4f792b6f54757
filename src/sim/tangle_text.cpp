// Sheets by name, vertices and faces by number.
#include "sim/tangle_text.h"

#include <fmt/format.h>

namespace nuno {
namespace {

std::string place_text(const glm::vec3& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p.x, p.y, p.z); }

const Sheet& sheet_of_face(const ClothModel& model, std::uint32_t face)
{
    for (const Sheet& sheet : model.sheets)
        if (face - sheet.first_face < sheet.face_count) return sheet;
    return model.sheets.front();
}

const Sheet& sheet_of_vertex(const ClothModel& model, std::uint32_t vertex)
{
    for (const Sheet& sheet : model.sheets)
        if (vertex - sheet.first_vertex < sheet.vertex_count) return sheet;
    return model.sheets.front();
}

}  // namespace

std::string tangle_text(const ClothModel& model, const Tangle& tangle)
{
    const FacePair pair = tangle.faces;
    const std::string place = place_text(tangle.place);
    if (tangle.meeting.crossing_count == 0)
        return fmt::format("face {} of sheet {} touches face {} of sheet {} at {}", pair.a,
                           sheet_of_face(model, pair.a).name, pair.b, sheet_of_face(model, pair.b).name, place);
    const Crossing& crossing = tangle.meeting.crossings[0];
    const std::uint32_t with_edge = crossing.edge_of_first ? pair.a : pair.b, other = pair.a + pair.b - with_edge;
    return fmt::format("edge {} {} of sheet {} goes through face {} of sheet {} at {}",
                       edge_vertex(tangle, crossing, 0, model.faces), edge_vertex(tangle, crossing, 1, model.faces),
                       sheet_of_face(model, with_edge).name, other, sheet_of_face(model, other).name, place);
}

std::string pass_through_text(const ClothModel& model, VertexFace pair, glm::vec3 place)
{
    return fmt::format("vertex {} of sheet {} went through face {} of sheet {}, to {}", pair.vertex,
                       sheet_of_vertex(model, pair.vertex).name, pair.face, sheet_of_face(model, pair.face).name,
                       place_text(place));
}

}  // namespace nuno
