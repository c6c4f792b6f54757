// The log of actions.
#include "app/viewer_log.h"

#include <cstdio>

namespace nuno {

void ViewerLog::write(const std::string& text) const
{
    fmt::print(stderr, "view: frame {}: {}\n", frame_, text);
    std::fflush(stderr);
}

void ViewerLog::control(std::string_view name, const glm::ivec4& place)
{
    if (!enabled_) return;
    const auto found = controls_.find(name);
    if (found != controls_.end() && found->second == place) return;
    controls_.insert_or_assign(std::string(name), place);
    write(fmt::format("control {} at {} {} size {} {}", name, place.x, place.y, place.z, place.w));
}

void ViewerLog::no_control(std::string_view name)
{
    if (!enabled_) return;
    const auto found = controls_.find(name);
    if (found == controls_.end()) return;
    controls_.erase(found);
    write(fmt::format("control {} hidden", name));
}

}  // namespace nuno
