// A linked program of shaders, and its loose uniforms by explicit location.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/gl.h"
#include "gl/shader_source.h"

namespace nuno {

class Program
{
  public:
    Program() = default;                      // no program: id 0
    explicit Program(GLuint id) : id_(id) {}  // owns it from now on
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    GLuint id() const { return id_; }
    void use() const { glUseProgram(id_); }

    // Sets a uniform declared `layout(location = ...)`; the program need not be in use.
    void set(GLint location, float value) const;
    void set(GLint location, std::int32_t value) const;
    void set(GLint location, std::uint32_t value) const;
    void set(GLint location, const glm::vec2& value) const;
    void set(GLint location, const glm::vec3& value) const;
    void set(GLint location, const glm::vec4& value) const;
    void set(GLint location, const glm::mat4& value) const;

  private:
    GLuint id_ = 0;
};

// A program of one kernel, shaders/<file>. Error naming file and line, with the driver's log, where it does not compile
// or link.
Program compute_program(std::string_view file, const std::vector<Define>& defines = {},
                        const std::vector<GeneratedInclude>& generated = {});

// A program that draws; both files get all defines.
Program draw_program(std::string_view vertex_file, std::string_view fragment_file,
                     const std::vector<Define>& defines = {}, const std::vector<GeneratedInclude>& generated = {});

}  // namespace nuno
