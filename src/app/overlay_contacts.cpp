// Contacts and impacts as marks.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include "app/overlay_marks.h"
#include "model/formulas.h"

namespace nuno {
namespace {

constexpr glm::vec3 kContact{0.94f, 0.55f, 0.05f}, kImpact{0.86f, 0.05f, 0.36f}, kInk{0.08f, 0.09f, 0.11f};
constexpr float kDot = 6;              // [pixels]
constexpr float kLeastNormal = 0.01f;  // [m]

// A place with a direction of unit length.
struct Meeting
{
    glm::vec3 place, normal;
};

class Meetings
{
  public:
    Meetings(std::span<const glm::vec4> positions, float normal_length)
        : positions_(positions), normal_length_(normal_length)
    {
    }

    // Between the closest points of the two sides, where they are now.
    Meeting of_elements(bool vertex_face, const glm::uvec4& v, glm::vec3 normal) const
    {
        const glm::vec3 x0 = at(v.x), x1 = at(v.y), x2 = at(v.z), x3 = at(v.w);
        const formulas::ClosestPoints c =
            vertex_face ? formulas::closest_vertex_face(x0, x1, x2, x3) : formulas::closest_edge_edge(x0, x1, x2, x3);
        const glm::vec3 on_a = vertex_face ? x0 : c.w0 * x0 + c.w1 * x1;
        return {on_a - 0.5f * c.separation, normal};
    }
    Meeting of_vertices(std::uint32_t a, std::uint32_t b) const
    {
        const glm::vec3 way = at(a) - at(b);
        return {0.5f * (at(a) + at(b)), way / std::max(glm::length(way), 1e-12f)};
    }
    glm::vec3 at(std::uint32_t vertex) const { return glm::vec3(positions_[vertex]); }

    void append(const Meeting& meeting, glm::vec3 colour, std::vector<Mark>& marks) const
    {
        const glm::vec3 end = meeting.place + normal_length_ * meeting.normal;
        marks.push_back({meeting.place, 2, end, 2, glm::vec4(colour, 1)});
        marks.push_back({meeting.place, kDot, meeting.place, kDot, glm::vec4(kInk, 1)});
        marks.push_back({meeting.place, kDot - 2, meeting.place, kDot - 2, glm::vec4(colour, 1)});
    }

  private:
    std::span<const glm::vec4> positions_;
    float normal_length_;
};

std::size_t append_contacts(const LastPass& pass, std::span<const glm::uvec3> faces, const Meetings& meetings,
                            std::vector<Mark>& marks)
{
    for (const Contact& c : pass.contacts) {
        const glm::uvec3& f = faces[c.face];
        meetings.append(meetings.of_elements(true, {c.vertex, f.x, f.y, f.z}, c.normal), kContact, marks);
    }
    for (const VertexPair& pair : pass.sphere_pairs)
        meetings.append(meetings.of_vertices(pair.a, pair.b), kContact, marks);
    for (const LayerContact& c : pass.foreseen)
        meetings.append(meetings.of_elements(c.kind == CONTACT_VERTEX_FACE, c.vertices, c.normal), kContact, marks);
    return pass.contacts.size() + pass.sphere_pairs.size() + pass.foreseen.size();
}

// Each pair once, however many rounds it came back in.
std::size_t append_impacts(const LastPass& pass, const Meetings& meetings, std::vector<Mark>& marks)
{
    std::set<std::tuple<PairKind, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>> seen;
    for (const Impact& impact : pass.impacts) {
        const glm::uvec4& v = impact.pair.vertices;
        if (!seen.emplace(impact.pair.kind, v.x, v.y, v.z, v.w).second) continue;
        meetings.append(meetings.of_elements(impact.pair.kind == PairKind::vertex_face, v, glm::vec3(impact.normal)),
                        kImpact, marks);
    }
    return seen.size();
}

const char* contact_text(CollisionLevel level)
{
    if (level == CollisionLevel::spheres) return "spheres that overlap";
    return level == CollisionLevel::discrete ? "contacts" : "contacts foreseen";
}

}  // namespace

void mark_contacts(const Simulation& simulation, std::span<const glm::vec4> positions, const MarkSheet& sheet)
{
    const LastPass pass = simulation.last_pass();
    const SimParams& params = simulation.params();
    if (params.collision == CollisionLevel::none)
        return sheet.legend.remarks.emplace_back("collision is none: layers pass through each other"), void();
    const Meetings meetings(positions, std::max(params.thickness, kLeastNormal));
    std::vector<Mark>& marks = sheet.overlay.through;
    const std::size_t contacts = append_contacts(pass, simulation.model().faces, meetings, marks);
    sheet.legend.rows.push_back({kContact, fmt::format("{} ({})", contact_text(params.collision), contacts)});
    if (params.collision >= CollisionLevel::continuous)
        sheet.legend.rows.push_back({kImpact, fmt::format("impacts ({})", append_impacts(pass, meetings, marks))});
    if (pass.level == CollisionLevel::none) sheet.legend.remarks.emplace_back("no pass since the start");
    if (simulation.is_asleep()) sheet.legend.remarks.emplace_back("asleep: contacts are those of the last pass");
}

}  // namespace nuno
