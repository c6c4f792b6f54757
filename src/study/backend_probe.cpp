// A quick look at how fast each backend runs one cloth.
#include "study/backend_probe.h"

#include <algorithm>
#include <limits>

#include "core/stopwatch.h"
#include "solver/method_table.h"

namespace nuno {
namespace {

constexpr int kRuns = 4;  // the first warms up
constexpr int kSubsteps = 20;

}  // namespace

BackendSpeed probe_backends(const ClothModel& model, const Bodies& bodies, const SimParams& params)
{
    ThreadPool pool(params.threads);
    const ClothState start = start_state(model, params);
    SimParams on_cpu = params, on_gpu = params;
    on_cpu.backend = Backend::cpu;
    on_gpu.backend = Backend::gpu;
    const auto cpu = make_solver(model, bodies, on_cpu, pool), gpu = make_solver(model, bodies, on_gpu, pool);

    const auto time_ns = [&](ClothSolver& solver) {
        solver.upload(start);
        Stopwatch watch;
        solver.step({params, 0, kSubsteps});
        solver.finish();
        return watch.elapsed_ms() * 1e6 / (kSubsteps * double(model.vertex_count()));
    };
    BackendSpeed best{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    for (int run = 0; run < kRuns; ++run) {
        const double cpu_ns = time_ns(*cpu), gpu_ns = time_ns(*gpu);
        if (run == 0) continue;
        best = {std::min(best.cpu_ns, cpu_ns), std::min(best.gpu_ns, gpu_ns)};
    }
    return best;
}

}  // namespace nuno
