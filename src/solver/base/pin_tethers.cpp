// Tethers of all sheets.
#include "solver/base/pin_tethers.h"

#include <algorithm>

namespace nuno {

void PinTethers::upload(const ClothState& state)
{
    for (std::uint32_t v = 0; v < model_.vertex_count(); ++v) set_vertex(v, state.positions[v]);
}

void PinTethers::set_vertex(std::uint32_t vertex, const glm::vec4& position)
{
    const bool held = position.w == 0;
    held_changed_ = held_changed_ || (held_[vertex] != 0) != held;
    held_[vertex] = held;
}

bool PinTethers::refresh(const SimParams& params)
{
    const bool wanted = params.tethers != Tethers::none;
    const bool changed = wanted != wanted_ || (wanted && (held_changed_ || params.tether_stretch != stretch_));
    if (!changed) return false;
    wanted_ = wanted;
    stretch_ = params.tether_stretch;
    held_changed_ = held_changed_ && !wanted;
    tethers_.clear();
    if (!wanted || std::count(held_.begin(), held_.end(), 0) == std::ptrdiff_t(held_.size())) return true;
    if (geodesics_.empty())
        for (const Sheet& sheet : model_.sheets) geodesics_.emplace_back(model_, sheet);
    tethers_.resize(std::size_t(kTethersPerVertex) * model_.vertex_count());
    for (std::size_t n = 0; n < geodesics_.size(); ++n) {
        const Sheet& sheet = model_.sheets[n];
        const std::vector<Tether> own = geodesics_[n].pin_tethers(held_);
        for (std::size_t k = 0; k < kTethersPerVertex; ++k)
            for (std::uint32_t v = 0; v < sheet.vertex_count; ++v) {
                Tether tether = own[k * sheet.vertex_count + v];
                if (tether.anchor != Tether::kNone) tether.length = tether.length * (1 + stretch_);
                tethers_[k * model_.vertex_count() + sheet.first_vertex + v] = tether;
            }
    }
    return true;
}

}  // namespace nuno
