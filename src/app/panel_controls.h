// Pieces that several panels draw.
#pragma once

#include <string>

#include "app/viewer_log.h"

namespace nuno {

// Tells the log where the last item is.
void note_control(ViewerLog& log, const std::string& name);

// A button named in the log by its text.
bool button(ViewerLog& log, const char* text, const char* tooltip, float width = 0);

}  // namespace nuno
