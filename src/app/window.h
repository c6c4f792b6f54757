// The viewer's window: an OpenGL context on a screen, its sizes, and what its user did since the last look.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "gl/context.h"

struct GLFWwindow;

namespace nuno {

// One thing done with the mouse, with the place where it was done.
struct PointerEvent
{
    enum class Kind
    {
        press,
        release,
        move,
        scroll
    };
    Kind kind;
    int button;       // GLFW's number, of press and release
    glm::vec2 place;  // in window coordinates, from the top left
    float steps;      // of the wheel, positive away from the user
    bool shift = false, control = false;
};

// A key that went down, or that its keyboard repeats.
struct KeyEvent
{
    int place;    // GLFW's name of the key
    int printed;  // the same, but of a letter as the keyboard's layout has it
    bool repeated;
    bool modified;  // Ctrl, Alt or Super was down
    bool control, shift;
};

struct WindowInput
{
    std::vector<KeyEvent> keys;
    std::vector<PointerEvent> pointer;
    std::vector<std::string> dropped_files;
    bool any = false;  // anything happened at all, redraw requests of the window system included
};

struct WindowSettings
{
    std::string title;
    glm::ivec2 size{1280, 720};  // in units of a screen of content scale 1
    bool vsync = true;
    bool debug_context = false;
};

class Window final : public Context
{
  public:
    // Opens the window and makes its context, current and loaded, without samples of its own.
    // Error saying what to do where there is no display, and what was found where there is no OpenGL 4.3.
    explicit Window(const WindowSettings& settings);
    ~Window() override;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void make_current() override;
    GLFWwindow* handle() const { return handle_; }

    glm::ivec2 framebuffer_size() const;  // pixels; 0, 0 while minimised
    glm::ivec2 size() const;              // window coordinates, those of the pointer
    float content_scale() const;          // 2 where texts should have twice the pixels

    bool should_close() const;
    void close();
    void set_title(const std::string& title);

    // What happened since the last call; waits up to `wait_s` for something where nothing has.
    WindowInput poll(double wait_s);
    void swap();

  private:
    void open(const WindowSettings& settings);
    void fit_to_monitor();
    void watch_pointer();
    void watch_keys_and_files();
    void watch_changes();

    GLFWwindow* handle_ = nullptr;
    WindowInput input_;
    glm::vec2 pointer_place_{0};
};

}  // namespace nuno
