// The viewer under test: the real program on an X server without a screen, driven by real mouse and key events.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "support/program_run.h"
#include "support/running_program.h"
#include "support/virtual_display.h"

namespace nuno {

// A rectangle in the window.
struct ControlPlace
{
    int left, top, width, height;
    int x(double share = 0.5) const { return left + static_cast<int>(share * width); }
    int y() const { return top + height / 2; }
};

class ViewerDriver
{
  public:
    // Starts `nuno view WORDS... --log-actions` in a directory of its own, on a display of that many dots per inch (0:
    // not said), and waits until its panel is there. `memory`: where it remembers what it measures; empty: nothing is
    // remembered yet.
    explicit ViewerDriver(const std::vector<std::string>& words, int dpi = 0, const std::filesystem::path& memory = {});

    RunningProgram& program() { return *program_; }
    const std::filesystem::path& directory() const { return directory_.path(); }

    // Waits for the next line "view: frame N: TEXT" whose text holds `pattern`; the groups of the pattern, with the
    // whole line as [0], and N.
    struct Line
    {
        int frame;
        std::vector<std::string> groups;
    };
    Line wait_for(const std::string& pattern);

    // Where a control is now. Waits until it is on the screen.
    ControlPlace control(const std::string& name);

    void move(int x, int y);
    // Buttons: 1 left, 2 middle, 3 right, 4 and 5 the wheel.
    void press(int x, int y, int button = 1);
    void release(int button = 1);
    void click(int x, int y, int button = 1);
    void click_control(const std::string& name);
    // Press, moves in steps, release.
    void drag(int from_x, int from_y, int to_x, int to_y, int button = 1);
    void key(const std::string& names);
    void key_down(const std::string& name);
    void key_up(const std::string& name);
    void type(const std::string& text);
    void resize(int width, int height);

    // Ends the viewer with the key Q; its exit code.
    int quit();

  private:
    std::string window_word() const { return " --window " + window_ + " "; }

    VirtualDisplay display_;
    TemporaryDirectory directory_, no_memory_;
    std::optional<RunningProgram> program_;
    std::string window_;
};

// Skips where the machine has no Xvfb or xdotool.
class ViewerTest : public testing::Test
{
  protected:
    void SetUp() override
    {
        if (!VirtualDisplay::possible()) GTEST_SKIP() << "needs Xvfb and xdotool (packages xvfb, xdotool)";
    }
};

}  // namespace nuno
