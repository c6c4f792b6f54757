// Fonts, colours and backends of Dear ImGui.
#include "app/viewer_ui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/error.h"

namespace nuno {
namespace {

constexpr float kFontPixels = 15;

// Where distributions keep a plain font; the first that is there is taken.
constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                  "/usr/share/fonts/noto/NotoSans-Regular.ttf",
                                  "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                                  "/System/Library/Fonts/Helvetica.ttc"};

// Latin, and the turned arrow of the buttons that take a change back.
constexpr ImWchar kGlyphs[] = {0x20, 0xff, 0x21ba, 0x21ba, 0};

// ImGui's own font is a bitmap of 13 pixels, legible only at whole multiples.
void add_font(float content_scale)
{
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    for (const char* path : kFonts) {
        std::error_code status;
        if (!std::filesystem::is_regular_file(path, status)) continue;
        if (fonts.AddFontFromFileTTF(path, std::round(kFontPixels * content_scale), nullptr, kGlyphs)) return;
    }
    ImFontConfig config;
    config.SizePixels = 13 * std::max(1.0f, std::round(content_scale));
    fonts.AddFontDefault(&config);
}

void set_colours(ImVec4* colours)
{
    const ImVec4 accent(0.24f, 0.46f, 0.72f, 1), dim(0.21f, 0.24f, 0.29f, 1), bright(0.27f, 0.32f, 0.39f, 1);
    colours[ImGuiCol_Text] = {0.90f, 0.91f, 0.93f, 1};
    colours[ImGuiCol_TextDisabled] = {0.56f, 0.59f, 0.64f, 1};
    colours[ImGuiCol_WindowBg] = {kPanelColour.r, kPanelColour.g, kPanelColour.b, kPanelColour.a};
    colours[ImGuiCol_PopupBg] = {0.13f, 0.14f, 0.165f, 1};
    colours[ImGuiCol_Border] = {0.24f, 0.27f, 0.31f, 1};
    colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] =
        colours[ImGuiCol_TitleBgCollapsed] = {0.145f, 0.16f, 0.19f, 1};
    colours[ImGuiCol_FrameBg] = {0.17f, 0.19f, 0.225f, 1};
    colours[ImGuiCol_FrameBgHovered] = dim;
    colours[ImGuiCol_FrameBgActive] = bright;
    colours[ImGuiCol_Button] = dim;
    colours[ImGuiCol_ButtonHovered] = bright;
    colours[ImGuiCol_ButtonActive] = accent;
    colours[ImGuiCol_Header] = {0.155f, 0.175f, 0.21f, 1};
    colours[ImGuiCol_HeaderHovered] = dim;
    colours[ImGuiCol_HeaderActive] = bright;
    colours[ImGuiCol_SliderGrab] = accent;
    colours[ImGuiCol_SliderGrabActive] = colours[ImGuiCol_CheckMark] = {0.36f, 0.62f, 0.92f, 1};
    colours[ImGuiCol_Separator] = colours[ImGuiCol_Border];
    colours[ImGuiCol_ScrollbarBg] = colours[ImGuiCol_ResizeGrip] = {0, 0, 0, 0};
}

ImGuiStyle base_style()
{
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    set_colours(style.Colors);
    style.WindowRounding = style.PopupRounding = 6;
    style.FrameRounding = style.GrabRounding = 4;
    style.WindowBorderSize = 0;
    style.WindowPadding = {10, 10};
    style.FramePadding = {7, 3};
    style.ItemSpacing = {7, 5};
    style.ScrollbarSize = 11;
    style.GrabMinSize = 11;
    return style;
}

}  // namespace

ViewerUi::ViewerUi(Window& window) : window_(window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    // Closing the viewer leaves nothing behind.
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().LogFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 430 core");
}

ViewerUi::~ViewerUi()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ViewerUi::apply_scale(float content_scale, float pixels_per_unit)
{
    if (content_scale == content_scale_ && pixels_per_unit == pixels_per_unit_) return;
    const bool is_first = content_scale_ == 0;
    content_scale_ = content_scale;
    pixels_per_unit_ = pixels_per_unit;
    scale_ = content_scale / pixels_per_unit;
    ImGui::GetStyle() = base_style();
    ImGui::GetStyle().ScaleAllSizes(scale_);
    add_font(content_scale);
    ImGui::GetIO().FontGlobalScale = 1 / pixels_per_unit;
    if (is_first) return;  // the first frame of the backend makes the texture
    // The texture alone: the backend would go on with the sizes of the buffers that it had (Dear ImGui 1.86).
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

// ImGui asks which keys are down once a frame, so a key pressed and released between two frames has to be held for one.
void ViewerUi::press_keys(std::span<const KeyEvent> keys)
{
    bool* down = ImGui::GetIO().KeysDown;
    for (const int place : std::exchange(short_presses_, {})) down[place] = false;
    for (const KeyEvent& key : keys) {
        if (down[key.place]) continue;
        down[key.place] = true;
        short_presses_.push_back(key.place);
    }
}

void ViewerUi::begin_frame(std::span<const KeyEvent> keys)
{
    const glm::ivec2 pixels = window_.framebuffer_size(), size = window_.size();
    // The two sizes may change one after the other; the ratio itself is a round number.
    const float ratio = pixels.x > 0 && size.x > 0 ? static_cast<float>(pixels.x) / static_cast<float>(size.x) : 1.0f;
    const float pixels_per_unit = std::max(0.25f, std::round(4 * ratio) / 4);
    apply_scale(window_.content_scale(), pixels_per_unit);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    press_keys(keys);
    ImGui::NewFrame();
}

void ViewerUi::draw()
{
    ImGui::Render();
    // The backend puts back the program that was in use; a change of scene on the panel may have deleted it.
    glUseProgram(0);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool ViewerUi::wants_keys() const
{
    const ImGuiPopupFlags any = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
    return ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen(nullptr, any);
}

}  // namespace nuno
