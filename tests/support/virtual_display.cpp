// Xvfb and xdotool.
#include "support/virtual_display.h"

namespace nuno {

bool VirtualDisplay::possible() { return has_program("Xvfb") && has_program("xdotool"); }

// The server writes the number that it chose, and nothing else of that form, once it takes connections.
VirtualDisplay::VirtualDisplay()
    : server_({{"Xvfb", "-displayfd", "2", "-noreset", "-nolisten", "tcp", "-screen", "0", "1280x800x24"}, {}, {}}),
      name_(":" + server_.wait_for("^([0-9]+)$")[1])
{
}

std::string VirtualDisplay::xdotool(const std::string& words) const
{
    return run_shell("DISPLAY=" + name_ + " timeout 30 xdotool " + words);
}

void VirtualDisplay::set_dpi(int dpi) const
{
    run_shell("printf 'Xft.dpi:\\t" + std::to_string(dpi) + "\\n' | DISPLAY=" + name_ +
              " xargs -0 xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER");
}

}  // namespace nuno
