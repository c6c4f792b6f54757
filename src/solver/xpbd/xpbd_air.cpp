// Air on faces, summed in vertices.
#include "solver/xpbd/xpbd_air.h"

namespace nuno {

XpbdAir::XpbdAir(const ClothModel& model)
    : faces_(model), x_(model.vertex_count()), v_(model.vertex_count()), accelerations_(model.vertex_count())
{
}

std::span<const glm::vec3> XpbdAir::accelerations(std::span<const glm::vec4> positions,
                                                  std::span<const glm::vec4> velocities, const SimParams& params,
                                                  double time_s, ThreadPool& pool)
{
    const auto count = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t v = 0; v < count; ++v) {
        x_.put(v, positions[v]);
        v_.put(v, velocities[v]);
    }
    FaceInputs in;
    in.wanted = face_forces(params);
    in.wanted.membrane = false;
    in.air = air_of(params);
    in.field = air_field(params, time_s);
    in.x = x_.lanes();
    in.v = v_.lanes();
    pool.run([&](int thread) { faces_.run(in, part_of(faces_.block_count(), 1, thread, pool.thread_count())); });
    for (int block = 0; block < faces_.block_count(); ++block) {
        const WideVec3 force = faces_.force_on_block(block);
        float x[kLanes], y[kLanes], z[kLanes];
        force.x.store(x);
        force.y.store(y);
        force.z.store(z);
        for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
            const std::uint32_t v = static_cast<std::uint32_t>(block * kLanes) + lane;
            if (v < count) accelerations_[v] = positions[v].w * glm::vec3(x[lane], y[lane], z[lane]);
        }
    }
    return accelerations_;
}

}  // namespace nuno
