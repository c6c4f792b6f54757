// `--log-actions`: one line on stderr for each thing the user did and for where each control is, so that a script can
// follow.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>

#include <glm/vec4.hpp>

namespace nuno {

class ViewerLog
{
  public:
    explicit ViewerLog(bool enabled) : enabled_(enabled) {}
    bool enabled() const { return enabled_; }

    // Frame that the lines from now on are of.
    void set_frame(int frame) { frame_ = frame; }

    // "view: frame 57: wind_strength = 3.2"
    template <class... Args>
    void action(fmt::format_string<Args...> format, Args&&... args)
    {
        if (enabled_) write(fmt::format(format, std::forward<Args>(args)...));
    }

    // Notes the rectangle (left, top, width, height in window coordinates) that a control has in the frame being drawn.
    void control(std::string_view name, const glm::ivec4& place);
    // The frame is drawn: tells the controls that came to rest at a new place, and those that were not drawn again.
    void end_controls();

  private:
    struct Control
    {
        glm::ivec4 place;
        bool drawn, moved, told;
    };
    void write(const std::string& text) const;

    bool enabled_;
    int frame_ = 0;
    std::map<std::string, Control, std::less<>> controls_;
};

}  // namespace nuno
