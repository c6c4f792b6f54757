// Lays tethers out in lanes.
#include "solver/base/cpu_tethers.h"

#include <utility>

namespace nuno {

CpuTethers::CpuTethers(const ClothModel& model, std::vector<std::uint32_t> places, std::uint32_t place_count)
    : pins_(model),
      places_(std::move(places)),
      vertex_count_(model.vertex_count()),
      stride_((place_count + kLanes - 1) / kLanes * kLanes)
{
}

void CpuTethers::refresh(const SimParams& params)
{
    if (!pins_.refresh(params)) return;
    anchors_.resize(kTethersPerVertex * stride_);
    for (std::size_t i = 0; i < anchors_.size(); ++i) anchors_[i] = static_cast<std::uint32_t>(i % stride_);
    lengths_.assign(anchors_.size(), Tether{}.length);
    const auto place = [&](std::size_t vertex) {
        return places_.empty() ? static_cast<std::uint32_t>(vertex) : places_[vertex];
    };
    for (std::size_t i = 0; i < pins_.tethers().size(); ++i) {
        const Tether& tether = pins_.tethers()[i];
        if (tether.anchor == Tether::kNone) continue;
        const std::size_t to = i / vertex_count_ * stride_ + place(i % vertex_count_);
        anchors_[to] = place(tether.anchor);
        lengths_[to] = tether.length;
    }
}

TetherLanes CpuTethers::lanes() const
{
    return {pins_.any() ? anchors_.data() : nullptr, lengths_.data(), static_cast<std::int32_t>(stride_)};
}

}  // namespace nuno
