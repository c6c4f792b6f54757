// The log of actions.
#include "app/viewer_log.h"

#include <cstdio>
#include <utility>

namespace nuno {

void ViewerLog::write(const std::string& text) const
{
    fmt::print(stderr, "view: frame {}: {}\n", frame_, text);
    std::fflush(stderr);
}

void ViewerLog::control(std::string_view name, const glm::ivec4& place)
{
    if (!enabled_) return;
    const auto [found, is_new] = controls_.try_emplace(std::string(name), Control{place, true, true, false});
    Control& control = found->second;
    control.drawn = true;
    control.moved = is_new || control.place != place;
    if (control.moved) control.told = false;
    control.place = place;
}

void ViewerLog::end_controls()
{
    for (auto entry = controls_.begin(); entry != controls_.end();) {
        auto& [name, control] = *entry;
        if (!control.drawn) {
            if (control.told) write(fmt::format("control {} hidden", name));
            entry = controls_.erase(entry);
            continue;
        }
        // A window that fits its contents moves for a frame or two.
        if (!control.moved && !std::exchange(control.told, true))
            write(fmt::format("control {} at {} {} size {} {}", name, control.place.x, control.place.y, control.place.z,
                              control.place.w));
        control.drawn = false;
        ++entry;
    }
}

}  // namespace nuno
