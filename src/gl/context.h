// An OpenGL context: who provides it, what it is, and what it has complained of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gl/gl.h"

namespace nuno {

// A context of 4.3 core or newer, destroyed with the object. Current on at most one thread at a time.
class Context
{
  public:
    virtual ~Context() = default;
    virtual void make_current() = 0;
};

struct GlInfo
{
    std::string vendor, renderer, version;
    bool software;  // the renderer is a CPU, so times are times of a CPU
};

// What the current context is.
GlInfo gl_info();

// True where a renderer's name is that of a software rasterizer.
bool is_software_renderer(std::string_view renderer);

// Loads the functions of the context that is current and turns the log of its errors on.
// Error naming the version and the renderer found where it is older than 4.3.
void load_gl(GLADloadfunc load);

// Error: `found` (version and renderer, or why there is none) is not the OpenGL that nuno needs.
[[noreturn]] void throw_gl_too_old(const std::string& found);

// The errors of the current context since the last call, in the driver's words; empty where there was none.
// Complete only in a debug context; in any other, a driver may tell just the codes of glGetError.
std::vector<std::string> take_gl_errors();

}  // namespace nuno
