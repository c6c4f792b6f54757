// The keys 1 to 9 and 0, which turn overlays on and off.
#pragma once

#include "app/viewer_session.h"

namespace nuno {

// `key` as GLFW numbers it; any that is no such key does nothing.
void press_overlay_key(int key, ViewerSession& session);

}  // namespace nuno
