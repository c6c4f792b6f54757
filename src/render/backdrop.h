// What stands around cloth and bodies, without their shadow: a picture that is kept for as long as it stays what it is,
// since a camera that rests sees the same floor and background in every frame.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "render/view_block.h"
#include "render/view_params.h"

namespace nuno {

class Backdrop
{
  public:
    // All that it depends on.
    struct Key
    {
        ViewBlock block;
        Look look = Look::gouraud;
        bool floor = false;
        glm::ivec2 size{0};
        bool operator==(const Key& other) const;
    };

    // Whether the picture before was of this key too; it is remembered as that from now on. A backdrop of another is
    // dropped.
    bool repeats(const Key& key);

    bool is_drawn() const { return is_drawn_; }
    // What is drawn from now on is the backdrop, of the size of the key.
    void begin();
    // Copies it to all of a framebuffer of that size, which stays bound.
    void copy_to(GLuint framebuffer) const;

  private:
    std::optional<Key> key_;
    std::optional<Framebuffer> picture_;
    bool is_drawn_ = false;
};

}  // namespace nuno
