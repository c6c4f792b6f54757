// `--log-actions`: one line on stderr for each thing the user did and for where each control is, so that a script can follow.
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

    // Notes the rectangle (left, top, width, height in window coordinates) of a control; tells it where it changed.
    void control(std::string_view name, const glm::ivec4& place);
    // The control is not on the screen.
    void no_control(std::string_view name);

  private:
    void write(const std::string& text) const;

    bool enabled_;
    int frame_ = 0;
    std::map<std::string, glm::ivec4, std::less<>> controls_;
};

}  // namespace nuno
