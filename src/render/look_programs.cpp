// Each look's own shader of cloth, and how it has the others compiled.
#include "render/look_programs.h"

namespace nuno {
namespace {

Program make_cloth_program(Look look, const std::vector<Define>& defines)
{
    switch (look) {
    case Look::gouraud: return draw_program("render/cloth_gouraud.vert", "render/cloth_gouraud.frag");
    case Look::phong: return draw_program("render/cloth_phong.vert", "render/cloth_phong.frag");
    case Look::cloth: return draw_program("render/cloth_fabric.vert", "render/cloth_fabric.frag", defines);
    }
    return {};
}

}  // namespace

LookPrograms make_look_programs(Look look)
{
    std::vector<Define> defines;
    if (look == Look::cloth) defines = {{"TONE_MAPPED", "1"}, {"SOFT_SHADOWS", "1"}};
    return {make_cloth_program(look, defines), draw_program("render/body.vert", "render/body.frag", defines),
            draw_program("render/floor.vert", "render/floor.frag", defines),
            draw_program("render/whole_picture.vert", "render/background.frag", defines)};
}

}  // namespace nuno
