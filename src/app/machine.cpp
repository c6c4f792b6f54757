// What the program runs on.
#include "app/machine.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/egl_context.h"
#include "study/backend_probe.h"

namespace nuno {

std::optional<std::string> software_remark(const Simulation& simulation, const GlInfo& gl)
{
    if (!gl.software || simulation.params().backend != Backend::gpu) return std::nullopt;
    const BackendSpeed speed = probe_backends(simulation.model(), simulation.bodies(), simulation.params());
    return fmt::format(
        "{} is a software renderer, so compute shaders run on the CPU; --backend cpu is {:.1f} times as fast here",
        gl.renderer, speed.gpu_ns / speed.cpu_ns);
}

MachineInfo machine_info(const GlInfo* gl, int threads)
{
    MachineInfo info{cpu_name(), threads, {}, {}, {}, false};
    if (gl) {
        info.gl_vendor = gl->vendor;
        info.gl_renderer = gl->renderer;
        info.gl_version = gl->version;
        info.software_gl = gl->software;
    }
    return info;
}

Machine::Machine(bool with_gl)
{
    if (!with_gl) return;
    context_ = make_headless_context();
    gl_ = gl_info();
}

Machine::~Machine() = default;

MachineInfo Machine::info(int threads) const { return machine_info(gl_ ? &*gl_ : nullptr, threads); }

void Machine::check_gl() const
{
    if (!gl_) return;
    const std::vector<std::string> errors = take_gl_errors();
    if (!errors.empty())
        throw Error(fmt::format("{}: OpenGL reports {} ({} in all); try --backend cpu, or a smaller resolution or size",
                                gl_->renderer, errors.front(), errors.size()));
}

void Machine::remark_on_backend(const Simulation& simulation) const
{
    if (!gl_) return;
    if (const auto remark = software_remark(simulation, *gl_)) fmt::print(stderr, "{}\n", *remark);
}

}  // namespace nuno
