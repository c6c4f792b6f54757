// Drives the viewer.
#include "app/viewer_driver.h"

namespace nuno {
namespace {

constexpr double kPatienceS = 40;  // a loaded machine without a graphics card

}  // namespace

ViewerDriver::ViewerDriver(const std::vector<std::string>& words, int dpi, const std::filesystem::path& memory)
{
    if (dpi > 0) display_.set_dpi(dpi);
    // Small pictures of one sample: the tests are about input, not about the picture.
    ProgramStart start{{NUNO_PROGRAM, "view"},
                       {"DISPLAY=" + display_.name(),
                        "WAYLAND_DISPLAY=", "XDG_CACHE_HOME=" + (memory.empty() ? no_memory_.path() : memory).string()},
                       directory_.path()};
    start.words.insert(start.words.end(), words.begin(), words.end());
    for (const char* word : {"--log-actions", "--set", "samples=1"}) start.words.emplace_back(word);
    program_.emplace(start);
    program_->wait_for("control wind_strength at", kPatienceS);
    window_ = display_.xdotool("search --sync --onlyvisible --name '^nuno - '");
    while (!window_.empty() && window_.back() == '\n') window_.pop_back();
    // Without a window manager nobody else gives it the keyboard.
    display_.xdotool("windowfocus --sync " + window_);
}

ViewerDriver::Line ViewerDriver::wait_for(const std::string& pattern)
{
    std::vector<std::string> groups = program_->wait_for("^view: frame ([0-9]+): .*?" + pattern, kPatienceS);
    const int frame = std::stoi(groups[1]);
    groups.erase(groups.begin() + 1);
    return {frame, groups};
}

ControlPlace ViewerDriver::control(const std::string& name)
{
    const std::string place = " (at (-?[0-9]+) (-?[0-9]+) size ([0-9]+) ([0-9]+)|hidden)$";
    std::vector<std::string> found = program_->latest("control " + name + place);
    if (found.empty() || found[1] == "hidden")
        found = program_->wait_for("control " + name + " (at) (-?[0-9]+)", kPatienceS);
    found = program_->latest("control " + name + place);
    return {std::stoi(found[2]), std::stoi(found[3]), std::stoi(found[4]), std::stoi(found[5])};
}

void ViewerDriver::move(int x, int y)
{
    display_.xdotool("mousemove" + window_word() + std::to_string(x) + " " + std::to_string(y));
}

void ViewerDriver::press(int x, int y, int button)
{
    move(x, y);
    display_.xdotool("mousedown " + std::to_string(button));
}

void ViewerDriver::release(int button) { display_.xdotool("mouseup " + std::to_string(button)); }

void ViewerDriver::click(int x, int y, int button)
{
    move(x, y);
    display_.xdotool("click " + std::to_string(button));
}

void ViewerDriver::click_control(const std::string& name)
{
    const ControlPlace place = control(name);
    click(place.x(), place.y());
}

void ViewerDriver::drag(int from_x, int from_y, int to_x, int to_y, int button)
{
    constexpr int kSteps = 6;
    press(from_x, from_y, button);
    for (int i = 1; i <= kSteps; ++i)
        move(from_x + (to_x - from_x) * i / kSteps, from_y + (to_y - from_y) * i / kSteps);
    release(button);
}

void ViewerDriver::key(const std::string& names) { display_.xdotool("key " + names); }
void ViewerDriver::key_down(const std::string& name) { display_.xdotool("keydown " + name); }
void ViewerDriver::key_up(const std::string& name) { display_.xdotool("keyup " + name); }
void ViewerDriver::type(const std::string& text) { display_.xdotool("type --delay 40 '" + text + "'"); }

void ViewerDriver::resize(int width, int height)
{
    display_.xdotool("windowsize " + window_ + " " + std::to_string(width) + " " + std::to_string(height));
}

int ViewerDriver::quit()
{
    key("q");
    const int code = program_->wait_for_exit(kPatienceS);
    EXPECT_EQ(program_->transcript().find("view: OpenGL"), std::string::npos) << program_->transcript();
    return code;
}

}  // namespace nuno
