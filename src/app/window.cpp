// The viewer's window, by GLFW.
#include "app/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "core/error.h"

namespace nuno {
namespace {

// Why GLFW refused last, in its words.
std::string glfw_reason()
{
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

[[noreturn]] void throw_no_display()
{
    const char* display = std::getenv("DISPLAY");
    const std::string found = display && *display ? fmt::format("DISPLAY is {}", display) : "DISPLAY is not set";
    throw Error(
        fmt::format("view: no window can be opened ({}; {}); set DISPLAY to a running X server, make one with "
                    "`xvfb-run nuno view`, or draw without a window: `nuno render SCENE --frames N --out DIR`",
                    found, glfw_reason()));
}

// The version and renderer of whatever context this display gives, for the message.
std::string describe_any_context()
{
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* probe = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (!probe) return fmt::format("no OpenGL context ({})", glfw_reason());
    glfwMakeContextCurrent(probe);
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(glfwGetProcAddress("glGetString"));
    const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(get_string(name)); };
    std::string found = get_string ? fmt::format("version {} of {}", text(GL_VERSION), text(GL_RENDERER)) : "no OpenGL";
    glfwDestroyWindow(probe);
    return found;
}

// GLFW names keys by their place on a US keyboard; a letter is meant as it is printed.
int key_as_printed(int key, int scancode)
{
    const char* name = glfwGetKeyName(key, scancode);
    const bool letter = name && name[1] == 0 && std::isalpha(static_cast<unsigned char>(name[0]));
    return letter ? std::toupper(static_cast<unsigned char>(name[0])) : key;
}

Window& window_of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }

}  // namespace

Window::Window(const WindowSettings& settings)
{
    if (!glfwInit()) throw_no_display();
    try {
        open(settings);
    } catch (...) {
        glfwTerminate();
        throw;
    }
}

Window::~Window()
{
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

void Window::open(const WindowSettings& settings)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, settings.debug_context);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    handle_ = glfwCreateWindow(settings.size.x, settings.size.y, settings.title.c_str(), nullptr, nullptr);
    if (!handle_) throw_gl_too_old(describe_any_context());
    make_current();
    load_gl(reinterpret_cast<GLADloadfunc>(glfwGetProcAddress));
    glfwSwapInterval(settings.vsync ? 1 : 0);
    fit_to_monitor();
    glfwSetWindowUserPointer(handle_, this);
    watch_pointer();
    watch_keys_and_files();
    watch_changes();
}

// A window that scaling made larger than the screen could not be used to its edges.
void Window::fit_to_monitor()
{
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return;
    int left = 0, top = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitor, &left, &top, &width, &height);
    const glm::ivec2 wanted = size();
    if (width <= 0 || height <= 0 || (wanted.x <= width && wanted.y <= height)) return;
    glfwSetWindowSize(handle_, std::min(wanted.x, width), std::min(wanted.y, height));
    glfwSetWindowPos(handle_, left, top);
}

// An event has the place of the last move before it; the pointer itself may be somewhere else by now.
void Window::watch_pointer()
{
    double x = 0, y = 0;
    glfwGetCursorPos(handle_, &x, &y);
    pointer_place_ = {x, y};
    glfwSetCursorPosCallback(handle_, [](GLFWwindow* handle, double new_x, double new_y) {
        Window& window = window_of(handle);
        window.pointer_place_ = {new_x, new_y};
        window.input_.pointer.push_back({PointerEvent::Kind::move, -1, window.pointer_place_, 0});
        window.input_.any = true;
    });
    glfwSetMouseButtonCallback(handle_, [](GLFWwindow* handle, int button, int action, int mods) {
        Window& window = window_of(handle);
        const auto kind = action == GLFW_PRESS ? PointerEvent::Kind::press : PointerEvent::Kind::release;
        window.input_.pointer.push_back(
            {kind, button, window.pointer_place_, 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0});
        window.input_.any = true;
    });
    glfwSetScrollCallback(handle_, [](GLFWwindow* handle, double, double steps) {
        Window& window = window_of(handle);
        window.input_.pointer.push_back(
            {PointerEvent::Kind::scroll, -1, window.pointer_place_, static_cast<float>(steps)});
        window.input_.any = true;
    });
}

void Window::watch_keys_and_files()
{
    glfwSetKeyCallback(handle_, [](GLFWwindow* handle, int key, int scancode, int action, int mods) {
        WindowInput& input = window_of(handle).input_;
        input.any = true;
        if (action == GLFW_RELEASE || key < 0) return;
        const bool modified = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
        const bool control = (mods & GLFW_MOD_CONTROL) != 0, shift = (mods & GLFW_MOD_SHIFT) != 0;
        input.keys.push_back({key, key_as_printed(key, scancode), action == GLFW_REPEAT, modified, control, shift});
    });
    glfwSetDropCallback(handle_, [](GLFWwindow* handle, int count, const char** paths) {
        WindowInput& input = window_of(handle).input_;
        input.any = true;
        input.dropped_files.insert(input.dropped_files.end(), paths, paths + count);
    });
}

void Window::watch_changes()
{
    glfwSetCharCallback(handle_, [](GLFWwindow* handle, unsigned) { window_of(handle).input_.any = true; });
    glfwSetWindowFocusCallback(handle_, [](GLFWwindow* handle, int) { window_of(handle).input_.any = true; });
    glfwSetFramebufferSizeCallback(handle_, [](GLFWwindow* handle, int, int) { window_of(handle).input_.any = true; });
    glfwSetWindowRefreshCallback(handle_, [](GLFWwindow* handle) { window_of(handle).input_.any = true; });
    glfwSetWindowContentScaleCallback(handle_,
                                      [](GLFWwindow* handle, float, float) { window_of(handle).input_.any = true; });
}

void Window::make_current() { glfwMakeContextCurrent(handle_); }

glm::ivec2 Window::framebuffer_size() const
{
    glm::ivec2 size{0};
    glfwGetFramebufferSize(handle_, &size.x, &size.y);
    return glfwGetWindowAttrib(handle_, GLFW_ICONIFIED) ? glm::ivec2(0) : size;
}

glm::ivec2 Window::size() const
{
    glm::ivec2 size{0};
    glfwGetWindowSize(handle_, &size.x, &size.y);
    return size;
}

float Window::content_scale() const
{
    float x = 1, y = 1;
    glfwGetWindowContentScale(handle_, &x, &y);
    return std::clamp(std::max(x, y), 0.5f, 4.0f);
}

bool Window::should_close() const { return glfwWindowShouldClose(handle_) != 0; }
void Window::close() { glfwSetWindowShouldClose(handle_, GLFW_TRUE); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(handle_, title.c_str()); }

WindowInput Window::poll(double wait_s)
{
    if (wait_s > 0)
        glfwWaitEventsTimeout(wait_s);
    else
        glfwPollEvents();
    return std::exchange(input_, {});
}

void Window::swap() { glfwSwapBuffers(handle_); }

}  // namespace nuno
