// An X server without a screen, and a mouse and a keyboard on it.
#pragma once

#include <string>

#include "support/running_program.h"

namespace nuno {

class VirtualDisplay
{
  public:
    // Whether the programs that it needs are installed: Xvfb and xdotool.
    static bool possible();

    // Starts an X server of 1280 x 800 pixels on a free number; it ends with the object.
    VirtualDisplay();

    const std::string& name() const { return name_; }  // for DISPLAY

    // Real input events through XTest, as `xdotool WORDS` makes them. std::runtime_error where xdotool fails.
    std::string xdotool(const std::string& words) const;

    // Sets the dots per inch that programs started from now on find: 192 asks them for twice the size. Needs xprop.
    void set_dpi(int dpi) const;

  private:
    RunningProgram server_;
    std::string name_;
};

}  // namespace nuno
