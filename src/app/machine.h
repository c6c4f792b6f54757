// What the program runs on: the OpenGL context of a headless command, and remarks on it.
#pragma once

#include <memory>
#include <optional>

#include "gl/context.h"
#include "sim/run_recorder.h"
#include "sim/simulation.h"

namespace nuno {

// A line for stderr where compute shaders run on a CPU: that --backend cpu is faster there, and by how much on this
// cloth.
std::optional<std::string> software_remark(const Simulation& simulation, const GlInfo& gl);

MachineInfo machine_info(const GlInfo* gl, int threads);

class Machine
{
  public:
    // Makes a headless context where `with_gl`. Error where there is no OpenGL 4.3.
    explicit Machine(bool with_gl);
    ~Machine();

    const std::optional<GlInfo>& gl() const { return gl_; }
    MachineInfo info(int threads) const;
    // Says on stderr what software_remark says, if the simulation runs on the gpu backend.
    void remark_on_backend(const Simulation& simulation) const;
    // Error where OpenGL has refused something since the context was made: what came out cannot be trusted then.
    void check_gl() const;

  private:
    std::unique_ptr<Context> context_;
    std::optional<GlInfo> gl_;
};

}  // namespace nuno
