// Loading OpenGL, and the log of its errors.
#include "gl/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/error.h"

namespace nuno {
namespace {

std::string gl_string(GLenum name)
{
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "unknown";
}

// The messages go to the context's own log, which holds few (Mesa: 10): only errors may enter it.
void log_errors_only()
{
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    glEnable(GL_DEBUG_OUTPUT);
    if (flags & GL_CONTEXT_FLAG_DEBUG_BIT) glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_HIGH, 0, nullptr, GL_TRUE);
    // A program that does not compile is thrown as an Error with its log.
    glDebugMessageControl(GL_DEBUG_SOURCE_SHADER_COMPILER, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
}

const char* error_name(GLenum code)
{
    switch (code) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "unknown";
    }
}

}  // namespace

GlInfo gl_info()
{
    GlInfo info{gl_string(GL_VENDOR), gl_string(GL_RENDERER), gl_string(GL_VERSION), false};
    info.software = is_software_renderer(info.renderer);
    return info;
}

bool is_software_renderer(std::string_view renderer)
{
    std::string lower(renderer);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "swiftshader", "lavapipe", "software", "gdi generic"})
        if (lower.find(name) != std::string::npos) return true;
    return false;
}

void load_gl(GLADloadfunc load)
{
    const int version = gladLoadGL(load);
    if (version == 0) throw_gl_too_old("no OpenGL context");
    if (version < GLAD_MAKE_VERSION(4, 3)) {
        const GlInfo info = gl_info();
        throw_gl_too_old(fmt::format("version {} of {}", info.version, info.renderer));
    }
    log_errors_only();
}

void throw_gl_too_old(const std::string& found)
{
    throw Error(
        fmt::format("OpenGL: {} was found, but 4.3 core is needed; install a newer driver, or Mesa's software "
                    "renderer (package libgl1-mesa-dri) and set LIBGL_ALWAYS_SOFTWARE=1",
                    found));
}

std::vector<std::string> take_gl_errors()
{
    std::vector<std::string> errors;
    GLchar text[4096];
    GLsizei length = 0;
    while (glGetDebugMessageLog(1, sizeof text, nullptr, nullptr, nullptr, nullptr, &length, text) == 1)
        errors.emplace_back(text);
    // A lost context answers an error for ever.
    for (int i = 0; i < 16; ++i) {
        const GLenum code = glGetError();
        if (code == GL_NO_ERROR) break;
        errors.push_back(fmt::format("glGetError: {} ({:#x})", error_name(code), code));
    }
    return errors;
}

}  // namespace nuno
