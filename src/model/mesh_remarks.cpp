// Looks at the faces of every edge.
#include "model/mesh_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

namespace nuno {
namespace {

// A side of a face, from its lesser vertex to its greater one.
struct Side
{
    std::uint32_t low, high, face;
    bool forwards;  // as the face runs
};

std::vector<Side> sides_by_edge(const ClothModel& model, const Sheet& sheet)
{
    std::vector<Side> sides;
    for (std::uint32_t f = 0; f < sheet.face_count; ++f) {
        const glm::uvec3 face = model.faces[sheet.first_face + f] - sheet.first_vertex;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = face[k], b = face[(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return sides;
}

// Edges of one kind.
struct Found
{
    int count = 0;
    std::string first;

    void add(std::span<const Side> sides)
    {
        if (count++ > 0) return;
        std::vector<std::uint32_t> faces;
        for (const Side& side : sides) faces.push_back(side.face);
        first = fmt::format("vertices {} and {} (faces {})", sides[0].low, sides[0].high, fmt::join(faces, ", "));
    }
};

}  // namespace

std::vector<std::string> mesh_remarks(const ClothModel& model)
{
    std::vector<std::string> lines;
    for (const Sheet& sheet : model.sheets) {
        if (sheet.is_grid()) continue;
        Found crowded, twisted;
        const std::vector<Side> sides = sides_by_edge(model, sheet);
        for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
            while (next < sides.size() && sides[next].low == sides[i].low && sides[next].high == sides[i].high) ++next;
            const auto around = std::span(sides).subspan(i, next - i);
            if (around.size() > 2) crowded.add(around);
            if (around.size() == 2 && around[0].forwards == around[1].forwards) twisted.add(around);
        }
        if (crowded.count > 0)
            lines.push_back(fmt::format(
                "sheet {}: more than two faces meet at {} of its edges, first between {}; cloth bends freely there",
                sheet.name, crowded.count, crowded.first));
        if (twisted.count > 0)
            lines.push_back(fmt::format(
                "sheet {}: two faces turn opposite sides up at {} of its edges, first between {}; the light is wrong "
                "there, so turn the faces of the mesh the same way",
                sheet.name, twisted.count, twisted.first));
    }
    return lines;
}

}  // namespace nuno
