// Compiling and linking.
#include "gl/program.h"

#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

#include "core/error.h"
#include "gl/context.h"

namespace nuno {
namespace {

using ParameterQuery = void (*)(GLuint, GLenum, GLint*);
using LogQuery = void (*)(GLuint, GLsizei, GLsizei*, GLchar*);

std::string info_log(GLuint object, ParameterQuery parameter, LogQuery query)
{
    GLint length = 0;
    parameter(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    GLsizei written = 0;
    if (length > 0) query(object, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

// A compiled shader that is deleted with the object.
class Shader
{
  public:
    Shader(GLenum stage, std::string_view file, const ShaderSource& source) : id_(glCreateShader(stage))
    {
        const char* text = source.text.c_str();
        glShaderSource(id_, 1, &text, nullptr);
        glCompileShader(id_);
        GLint compiled = 0;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        if (compiled) return;
        const std::string log = name_files(source, info_log(id_, glad_glGetShaderiv, glad_glGetShaderInfoLog));
        glDeleteShader(id_);
        throw Error(fmt::format("shaders/{}: does not compile as GLSL 4.30 on {}:\n{}", file, gl_info().renderer, log));
    }
    ~Shader() { glDeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint id() const { return id_; }

  private:
    GLuint id_;
};

Program link(std::initializer_list<GLuint> shaders, std::string_view files)
{
    Program program(glCreateProgram());
    for (const GLuint shader : shaders) glAttachShader(program.id(), shader);
    glLinkProgram(program.id());
    for (const GLuint shader : shaders) glDetachShader(program.id(), shader);
    GLint linked = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
    if (!linked)
        throw Error(fmt::format("{}: does not link on {}:\n{}", files, gl_info().renderer,
                                info_log(program.id(), glad_glGetProgramiv, glad_glGetProgramInfoLog)));
    return program;
}

}  // namespace

Program::~Program() { glDeleteProgram(id_); }

Program::Program(Program&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Program& Program::operator=(Program&& other) noexcept
{
    std::swap(id_, other.id_);
    return *this;
}

void Program::set(GLint location, float value) const { glProgramUniform1f(id_, location, value); }
void Program::set(GLint location, std::int32_t value) const { glProgramUniform1i(id_, location, value); }
void Program::set(GLint location, std::uint32_t value) const { glProgramUniform1ui(id_, location, value); }
void Program::set(GLint location, const glm::vec2& value) const
{
    glProgramUniform2fv(id_, location, 1, glm::value_ptr(value));
}
void Program::set(GLint location, const glm::vec3& value) const
{
    glProgramUniform3fv(id_, location, 1, glm::value_ptr(value));
}
void Program::set(GLint location, const glm::vec4& value) const
{
    glProgramUniform4fv(id_, location, 1, glm::value_ptr(value));
}
void Program::set(GLint location, const glm::mat4& value) const
{
    glProgramUniformMatrix4fv(id_, location, 1, GL_FALSE, glm::value_ptr(value));
}

Program compute_program(std::string_view file, const std::vector<Define>& defines,
                        const std::vector<GeneratedInclude>& generated)
{
    const Shader kernel(GL_COMPUTE_SHADER, file, expand_shader(file, defines, generated));
    return link({kernel.id()}, fmt::format("shaders/{}", file));
}

Program draw_program(std::string_view vertex_file, std::string_view fragment_file, const std::vector<Define>& defines,
                     const std::vector<GeneratedInclude>& generated)
{
    const Shader vertex(GL_VERTEX_SHADER, vertex_file, expand_shader(vertex_file, defines, generated));
    const Shader fragment(GL_FRAGMENT_SHADER, fragment_file, expand_shader(fragment_file, defines, generated));
    return link({vertex.id(), fragment.id()}, fmt::format("shaders/{} and shaders/{}", vertex_file, fragment_file));
}

}  // namespace nuno
