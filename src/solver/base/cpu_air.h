// The force of moving air on every vertex, for methods that take it in by itself.
#pragma once

#include <algorithm>

#include "solver/base/cpu_faces.h"
#include "solver/base/team.h"

namespace nuno {

class CpuAir
{
  public:
    explicit CpuAir(const ClothModel& model)
        : vertex_count_(model.vertex_count()), faces_(model), x_(vertex_count_), v_(vertex_count_)
    {
    }

    // Calls take(vertex, force) for this thread's part of the vertices: the force [N] at a time where every vertex has
    // the formulas::Motion motion_of(vertex). To be called by all of the team; it returns once all have taken theirs.
    template <class MotionOf, class Take>
    void run(const SimParams& params, double time_s, const Team& team, const MotionOf& motion_of, const Take& take)
    {
        const Range blocks = team.part(faces_.block_count());
        const auto begin = static_cast<std::uint32_t>(blocks.begin * kLanes);
        const std::uint32_t end = std::min(static_cast<std::uint32_t>(blocks.end * kLanes), vertex_count_);
        for (std::uint32_t vertex = begin; vertex < end; ++vertex) {
            const formulas::Motion m = motion_of(vertex);
            x_.put(vertex, glm::vec4(m.position, 0));
            v_.put(vertex, glm::vec4(m.velocity, 0));
        }
        team.wait();
        faces_.run(inputs(params, time_s), blocks);
        team.wait();
        for (std::uint32_t vertex = begin; vertex < end; vertex += kLanes) {
            const WideVec3 force = faces_.force_on_block(static_cast<int>(vertex / kLanes));
            for (std::uint32_t lane = 0; lane < kLanes && vertex + lane < end; ++lane)
                take(vertex + lane, glm::vec3(force.x.lanes[lane], force.y.lanes[lane], force.z.lanes[lane]));
        }
        team.wait();
    }

  private:
    FaceInputs inputs(const SimParams& params, double time_s)
    {
        FaceInputs in{.wanted = face_forces(params),
                      .air = air_of(params),
                      .field = air_field(params, time_s),
                      .x = x_.lanes(),
                      .v = v_.lanes()};
        in.wanted.membrane = false;
        return in;
    }

    const std::uint32_t vertex_count_;
    CpuFaces faces_;
    VertexLanes3 x_, v_;
};

}  // namespace nuno
