// Intersections of poses, and vertices that went through faces between two frames.
#include "sim/pose_check.h"

#include <fmt/format.h>

#include "collision/pass_through.h"
#include "model/cloth_state.h"
#include "sim/tangle_text.h"

namespace nuno {
namespace {

constexpr std::size_t kMostLines = 20;  // of a frame and a kind

}  // namespace

std::string findings_text(const CheckCounts& counts, bool one_pass)
{
    if (counts.intersections() + counts.passed_through == 0) return "nothing";
    std::string text = fmt::format("{} pairs of faces that cross, {} that touch, {} vertices that went through a face",
                                   counts.crossing, counts.touching, counts.passed_through);
    if (counts.passed_through > 0 && !one_pass)
        text += " on the straight way of a frame, which with several passes is not the way that was taken";
    return text;
}

PoseCheck::PoseCheck(const ClothModel& model, int every, int threads)
    : model_(model),
      every_(every),
      pool_(threads),
      search_(model),
      query_(model.rest_positions, model.faces, model.sheets, ElementKinds::vertex_face)
{
    counts_.every = every;
}

std::vector<std::string> PoseCheck::look(int frame, const std::vector<glm::vec4>& positions)
{
    std::vector<std::string> lines;
    const auto add_rest = [&](std::size_t all) {
        if (all > kMostLines) lines.push_back(fmt::format("frame {}: and {} more", frame, all - kMostLines));
    };
    if (frame % every_ == 0 && !first_lost(positions)) {
        ++counts_.poses;
        const std::vector<Tangle> tangles = search_.find(positions, pool_);
        const TangleCounts found = count_of(tangles);
        counts_.crossing += found.crossing;
        counts_.touching += found.touching;
        for (std::size_t i = 0; i < std::min(kMostLines, tangles.size()); ++i)
            lines.push_back(fmt::format("frame {}: {}", frame, tangle_text(model_, tangles[i])));
        add_rest(tangles.size());
        if (before_frame_ >= 0 && before_frame_ + 1 == frame) {
            const std::vector<VertexFace> passed = find_pass_through(query_, before_, positions, pool_);
            counts_.passed_through += passed.size();
            for (std::size_t i = 0; i < std::min(kMostLines, passed.size()); ++i)
                lines.push_back(
                    fmt::format("frame {}: {}", frame,
                                pass_through_text(model_, passed[i], glm::vec3(positions[passed[i].vertex]))));
            add_rest(passed.size());
        }
        if (!lines.empty() && counts_.first_frame < 0) counts_.first_frame = frame;
    }
    before_ = positions;
    before_frame_ = frame;
    return lines;
}

}  // namespace nuno
