// Wireframe, springs, pins and boxes.
#include "app/overlay_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace nuno {
namespace {

// Of M. Okabe and K. Ito, Color Universal Design, 2008: told apart by all eyes.
constexpr glm::vec3 kBlue{0.00f, 0.45f, 0.70f}, kGreen{0.00f, 0.62f, 0.45f}, kOrange{0.90f, 0.62f, 0.00f};
constexpr glm::vec3 kYellow{0.94f, 0.89f, 0.26f}, kPurple{0.80f, 0.47f, 0.65f};
constexpr glm::vec3 kInk{0.08f, 0.09f, 0.11f}, kWhite{1.0f, 1.0f, 1.0f};

Mark stroke(const glm::vec4& from, const glm::vec4& to, float width, glm::vec4 colour)
{
    return {glm::vec3(from), width, glm::vec3(to), width, colour};
}

// A dot with a dark rim.
void append_dot(std::vector<Mark>& marks, const glm::vec4& place, float width, glm::vec3 colour)
{
    marks.push_back(stroke(place, place, width, glm::vec4(kInk, 1)));
    marks.push_back(stroke(place, place, width - 3, glm::vec4(colour, 1)));
}

struct SpringLook
{
    const char* name;
    glm::vec3 colour;
    float width, opacity;
};

// By group. Bend springs of a grid lie along two threads: wider, so that they are seen beside them.
constexpr std::array<SpringLook, kSpringGroupCount> kSpringLooks{
    {{"threads", kBlue, 1.5f, 1.0f}, {"shear springs", kGreen, 1.2f, 1.0f}, {"bend springs", kOrange, 4.0f, 0.7f}}};

void append_box(std::vector<Mark>& marks, const FaceBox& box)
{
    const auto corner = [&](int i) {
        return glm::vec4((i & 1) ? box.hi.x : box.lo.x, (i & 2) ? box.hi.y : box.lo.y, (i & 4) ? box.hi.z : box.lo.z,
                         1);
    };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if (!(i & axis)) marks.push_back(stroke(corner(i), corner(i | axis), 1.2f, glm::vec4(kPurple, 0.85f)));
}

}  // namespace

std::vector<glm::uvec2> edges_of(std::span<const glm::uvec3> faces)
{
    std::vector<glm::uvec2> edges;
    for (const glm::uvec3& face : faces)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = face[k], b = face[(k + 1) % 3];
            edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    const auto before = [](const glm::uvec2& a, const glm::uvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(edges.begin(), edges.end(), before);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

void mark_wireframe(std::span<const glm::uvec2> edges, std::span<const glm::vec4> positions, const MarkSheet& sheet)
{
    // Dark lines are lost on dark colours.
    const bool on_colours = !sheet.overlay.heat.values.empty();
    const glm::vec3 colour = on_colours ? kWhite : kInk;
    const glm::vec4 paint(colour, on_colours ? 0.45f : 0.7f);
    for (const glm::uvec2& ends : edges)
        sheet.overlay.on_cloth.push_back(stroke(positions[ends.x], positions[ends.y], 1, paint));
    sheet.legend.rows.push_back({colour, fmt::format("edges of faces ({})", edges.size())});
}

void mark_springs(const ClothModel& model, const SimParams& params, std::span<const glm::vec4> positions,
                  const MarkSheet& sheet)
{
    // The wide ones first, so that the narrow ones lie over them.
    for (int group = kSpringGroupCount - 1; group >= 0; --group) {
        // In its place there is a membrane of triangles.
        if (group < 2 && params.internal_model == InternalModel::continuum) continue;
        const SpringLook& look = kSpringLooks[std::size_t(group)];
        std::size_t count = 0;
        for (const Spring& spring : model.springs) {
            if (spring_group(spring.kind) != group) continue;
            sheet.overlay.on_cloth.push_back(
                stroke(positions[spring.a], positions[spring.b], look.width, glm::vec4(look.colour, look.opacity)));
            ++count;
        }
        if (count > 0) sheet.legend.rows.push_back({look.colour, fmt::format("{} ({})", look.name, count)});
    }
    if (params.internal_model == InternalModel::continuum)
        sheet.legend.remarks.emplace_back("threads and shear: a membrane of triangles, no springs");
}

void mark_pins(const ClothModel& model, std::span<const glm::vec4> positions, const MarkSheet& sheet)
{
    const auto on_handle = [&](std::uint32_t v) {
        return std::binary_search(model.handle_pins.begin(), model.handle_pins.end(), HandlePin{v, 0},
                                  [](const HandlePin& a, const HandlePin& b) { return a.vertex < b.vertex; });
    };
    std::array<std::size_t, 2> counts{};
    for (std::uint32_t v = 0; v < model.vertex_count(); ++v) {
        if (!model.pinned[v]) continue;
        const bool moves = on_handle(v);
        append_dot(sheet.overlay.through, positions[v], 9, moves ? kYellow : kWhite);
        ++counts[std::size_t{moves}];
    }
    if (counts[0] > 0) sheet.legend.rows.push_back({kWhite, fmt::format("pins ({})", counts[0])});
    if (counts[1] > 0) sheet.legend.rows.push_back({kYellow, fmt::format("pins on handles ({})", counts[1])});
    if (counts[0] + counts[1] == 0) sheet.legend.remarks.emplace_back("no pins in this scene");
}

void mark_boxes(TreePicture& tree, int depth, const SimParams& params, std::span<const glm::vec4> positions,
                const MarkSheet& sheet)
{
    const int shown = std::min(depth, tree.depth());
    const std::vector<FaceBox> found = tree.boxes(positions, params.thickness, shown);
    for (const FaceBox& box : found) append_box(sheet.overlay.through, box);
    sheet.legend.rows.push_back(
        {kPurple, fmt::format("tree boxes, level {} of {} ({})", shown, tree.depth(), found.size())});
}

}  // namespace nuno
