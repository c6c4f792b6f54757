// Keys of overlays.
#include "app/overlay_keys.h"

#include <GLFW/glfw3.h>

#include <array>
#include <string_view>

namespace nuno {
namespace {

// A parameter, and its value where the key turns it on.
struct OverlayKey
{
    int key;
    std::string_view param;
    double on;
};

constexpr double kTrue = 1;
constexpr std::array kOverlayKeys{
    OverlayKey{GLFW_KEY_1, "show_wireframe", kTrue},      OverlayKey{GLFW_KEY_2, "show_springs", kTrue},
    OverlayKey{GLFW_KEY_3, "heat", double(Heat::strain)}, OverlayKey{GLFW_KEY_4, "heat", double(Heat::speed)},
    OverlayKey{GLFW_KEY_5, "show_contacts", kTrue},       OverlayKey{GLFW_KEY_6, "show_boxes", kTrue},
    OverlayKey{GLFW_KEY_7, "heat", double(Heat::culled)}, OverlayKey{GLFW_KEY_8, "heat", double(Heat::asleep)},
    OverlayKey{GLFW_KEY_9, "show_pins", kTrue},           OverlayKey{GLFW_KEY_0, "show_wind", kTrue}};

}  // namespace

void press_overlay_key(int key, ViewerSession& session)
{
    for (const OverlayKey& overlay : kOverlayKeys) {
        if (overlay.key != key) continue;
        const ParamInfo& info = *find_param(view_param_table(), overlay.param);
        const bool is_on = param_value(info, &session.view()) == overlay.on;
        session.set_view_param(info, is_on ? 0 : overlay.on);
        session.end_drag();
    }
}

}  // namespace nuno
