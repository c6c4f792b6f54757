// EGL: finds a display that needs no window system, and makes a context on it.
#include "gl/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace nuno {
namespace {

bool has_extension(const char* list, std::string_view name)
{
    if (!list) return false;
    for (std::string_view rest = list; !rest.empty();) {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == name) return true;
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    return false;
}

// A display is shared by everything in the process that asks for the same one and EGL does not count its users, so
// it is never terminated here.
class EglContext final : public Context
{
  public:
    EglContext(EGLDisplay display, EGLContext context, EGLSurface surface)
        : display_(display), context_(context), surface_(surface)
    {
    }
    ~EglContext() override
    {
        if (eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void make_current() override
    {
        if (!eglMakeCurrent(display_, surface_, surface_, context_))
            throw Error(
                fmt::format("EGL: the context cannot be made current (error {:#x}); is it current on another thread?",
                            eglGetError()));
    }

  private:
    EGLDisplay display_;
    EGLContext context_;
    EGLSurface surface_;
};

struct Candidate
{
    EGLDisplay display;
    bool graphics_card;  // known not to be software
};

// Displays to try, best first: one without surfaces, then each device, then whatever is the default.
std::vector<Candidate> candidate_displays()
{
    std::vector<Candidate> candidates;
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display && has_extension(extensions, "EGL_MESA_platform_surfaceless"))
        candidates.push_back({get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), false});
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto query_string =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    if (get_display && query_devices && query_string && has_extension(extensions, "EGL_EXT_platform_device")) {
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (!query_devices(16, devices, &count)) count = 0;
        for (int i = 0; i < count; ++i)
            candidates.push_back(
                {get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
                 !has_extension(query_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")});
    }
    candidates.push_back({eglGetDisplay(EGL_DEFAULT_DISPLAY), false});
    return candidates;
}

EGLContext create_context(EGLDisplay display, EGLConfig config)
{
    std::vector<EGLint> wanted = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
#ifndef NDEBUG
    // Where asserts are on, so are the driver's own checks, if it has any.
    std::vector<EGLint> checked = wanted;
    checked.insert(checked.end() - 1, {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE});
    if (EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, checked.data())) return context;
#endif
    return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
}

struct Surface
{
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLSurface surface = EGL_NO_SURFACE;
};

// What a context of this display is made with: nothing at all where the driver allows that, else a pixel that is never
// drawn.
Surface choose_surface(EGLDisplay display)
{
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    const bool no_surface = has_extension(extensions, "EGL_KHR_surfaceless_context");
    const bool no_config = has_extension(extensions, "EGL_KHR_no_config_context");
    Surface chosen;
    if (no_surface && no_config) return chosen;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, no_surface ? 0 : EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &chosen.config, 1, &count) || count == 0) chosen.config = EGL_NO_CONFIG_KHR;
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    if (!no_surface) chosen.surface = eglCreatePbufferSurface(display, chosen.config, size);
    return chosen;
}

// The version and renderer of any context this display makes, for the message; empty where it makes none.
std::string describe_any_context(EGLDisplay display, const Surface& surface)
{
    const EGLContext context = eglCreateContext(display, surface.config, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT) return {};
    EglContext holder(display, context, EGL_NO_SURFACE);
    if (!eglMakeCurrent(display, surface.surface, surface.surface, context)) return {};
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(eglGetProcAddress("glGetString"));
    if (!get_string) return {};
    const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(get_string(name)); };
    return fmt::format("version {} of {}", text(GL_VERSION), text(GL_RENDERER));
}

// A current, loaded context on this display; null, with what was found instead appended to `found`, where it gives
// none.
std::unique_ptr<Context> try_display(EGLDisplay display, std::string& found)
{
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return nullptr;
    eglBindAPI(EGL_OPENGL_API);
    const Surface surface = choose_surface(display);
    const EGLContext context = create_context(display, surface.config);
    if (context == EGL_NO_CONTEXT) {
        if (found.empty()) found = describe_any_context(display, surface);
        if (surface.surface != EGL_NO_SURFACE) eglDestroySurface(display, surface.surface);
        return nullptr;
    }
    auto owner = std::make_unique<EglContext>(display, context, surface.surface);
    if (!eglMakeCurrent(display, surface.surface, surface.surface, context)) return nullptr;
    load_gl(reinterpret_cast<GLADloadfunc>(eglGetProcAddress));
    return owner;
}

}  // namespace

std::unique_ptr<Context> make_headless_context()
{
    const char* software = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const bool software_wanted = software && *software;
    std::unique_ptr<Context> slow;
    std::string found;
    for (const Candidate& candidate : candidate_displays()) {
        if (candidate.graphics_card ? software_wanted : slow != nullptr) continue;
        std::unique_ptr<Context> context = try_display(candidate.display, found);
        if (!context) continue;
        if (software_wanted || !gl_info().software) return context;
        if (!slow) slow = std::move(context);
    }
    if (slow) {
        slow->make_current();
        load_gl(reinterpret_cast<GLADloadfunc>(eglGetProcAddress));
        return slow;
    }
    if (!found.empty()) throw_gl_too_old(found);
    throw Error(
        "OpenGL: EGL offers no display; install a driver, or Mesa's software renderer "
        "(packages libegl1 and libgl1-mesa-dri)");
}

}  // namespace nuno
