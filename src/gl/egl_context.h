// An OpenGL context without a window or a display server.
#pragma once

#include <memory>

#include "gl/context.h"

namespace nuno {

// A 4.3 core context through EGL, current on the calling thread and loaded; it has no default framebuffer.
// A graphics card is preferred to software unless LIBGL_ALWAYS_SOFTWARE is set.
// Error naming what was found, or what to install, where there is none.
std::unique_ptr<Context> make_headless_context();

}  // namespace nuno
