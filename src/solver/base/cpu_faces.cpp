// Forces on faces on CPU threads.
#include "solver/base/cpu_faces.h"

namespace nuno {

using F = formulas_wide;

namespace {

constexpr std::uint32_t padded(std::size_t count)
{
    return static_cast<std::uint32_t>((count + kLanes - 1) / kLanes * kLanes);
}

constexpr int kRestNumbers = 6;  // of FaceRest

// What the loop over blocks needs, as plain pointers.
struct FaceKernel
{
    const FaceInputs& in;
    const std::uint32_t* vertices;
    const float* rest;
    Lanes3 forces;
    std::int32_t face_count;  // padded

    NUNO_WIDE_INLINE WideVec3 air_velocity(const WideVec3& centre) const
    {
        const WideVec3 wind = wide(in.field.wind);
        if (!in.wanted.gusts) return wind;
        const WideVec3 q = F::gust_place(centre, wide(in.field.offset), WideFloat(in.field.per_size));
        return F::gusty_air(wind, WideFloat(in.field.gust_speed), q, F::Bits{} + in.field.seed);
    }

    NUNO_WIDE_INLINE F::CornerForces membrane(const WideVec3* x, const WideVec3* v, const F::FaceRest& at_rest) const
    {
        const formulas::MembraneConstants& c = in.membrane;
        return F::membrane_forces(
            x[1] - x[0], x[2] - x[0], v[1] - v[0], v[2] - v[0], at_rest,
            {WideFloat(c.warp), WideFloat(c.weft), WideFloat(c.cross), WideFloat(c.shear), WideFloat(c.damping)});
    }

    NUNO_WIDE_INLINE void block(int block) const
    {
        WideVec3 x[3], v[3];
        for (int corner = 0; corner < 3; ++corner) {
            x[corner] = gather(in.x, vertices + (block * 3 + corner) * kLanes);
            v[corner] = gather(in.v, vertices + (block * 3 + corner) * kLanes);
        }
        const float* r = rest + block * kRestNumbers * kLanes;
        const F::FaceRest at_rest{WideFloat(r),
                                  WideFloat(r + kLanes),
                                  WideFloat(r + 2 * kLanes),
                                  WideFloat(r + 3 * kLanes),
                                  WideFloat(r + 4 * kLanes),
                                  WideFloat(r + 5 * kLanes)};
        F::CornerForces inner{WideVec3(0.0f), WideVec3(0.0f)};
        WideVec3 outer(0.0f);
        if (in.wanted.membrane) inner = membrane(x, v, at_rest);
        if (in.wanted.air) {
            const WideVec3 u =
                F::relative_air(air_velocity(F::face_mean(x[0], x[1], x[2])), F::face_mean(v[0], v[1], v[2]));
            const formulas::Air& a = in.air;
            outer = F::third_of(F::face_air_force(x[1] - x[0], x[2] - x[0], u, at_rest.mass_area,
                                                  {WideFloat(a.density), WideFloat(a.pressure), WideFloat(a.skin),
                                                   WideFloat(a.areal_density), WideFloat(a.h)}));
        }
        const std::int32_t i = block * kLanes;
        store(forces, i, outer - (inner.on_1 + inner.on_2));
        store(forces, i + face_count, outer + inner.on_1);
        store(forces, i + 2 * face_count, outer + inner.on_2);
    }
};

NUNO_SIMD_CLONES void run_blocks_of_faces(const FaceKernel& kernel, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) kernel.block(block);
}

}  // namespace

CpuFaces::CpuFaces(const ClothModel& model)
    : vertex_block_count_(static_cast<int>(padded(model.vertex_count()) / kLanes)),
      face_block_count_(static_cast<int>(padded(model.faces.size()) / kLanes)),
      forces_(3 * padded(model.faces.size()) + 1)
{
    const std::size_t faces = model.faces.size(), face_count = padded(faces);
    const std::vector<formulas::FaceRest> rests = face_rests(model);
    vertices_.resize(3 * face_count);
    rest_.resize(kRestNumbers * face_count);
    for (std::size_t face = 0; face < faces; ++face) {
        const std::size_t block = face / kLanes, lane = face % kLanes;
        for (std::size_t corner = 0; corner < 3; ++corner)
            vertices_[(block * 3 + corner) * kLanes + lane] = model.faces[face][static_cast<int>(corner)];
        const formulas::FaceRest& r = rests[face];
        const float numbers[] = {r.warp_1, r.warp_2, r.weft_1, r.weft_2, r.area, r.mass_area};
        for (std::size_t k = 0; k < kRestNumbers; ++k) rest_[(block * kRestNumbers + k) * kLanes + lane] = numbers[k];
    }

    const CornerTable table = make_corner_table(model);
    slot_count_ = table.slot_count;
    const auto nothing = static_cast<std::uint32_t>(3 * face_count);
    corners_.assign(static_cast<std::size_t>(vertex_block_count_ * slot_count_ * kLanes), nothing);
    for (std::size_t i = 0; i < table.corners.size(); ++i) {
        if (table.corners[i] == 3 * table.face_count) continue;
        const std::size_t slot = i / table.vertex_count, vertex = i % table.vertex_count;
        const std::size_t block = vertex / kLanes, lane = vertex % kLanes;
        corners_[(block * std::size_t(slot_count_) + slot) * kLanes + lane] = static_cast<std::uint32_t>(
            table.corners[i] / table.face_count * face_count + table.corners[i] % table.face_count);
    }
}

void CpuFaces::run(const FaceInputs& in, Range blocks) const
{
    const auto first = [&](int vertex_block) {
        return static_cast<int>(std::int64_t(face_block_count_) * vertex_block / vertex_block_count_);
    };
    const FaceKernel kernel{in, vertices_.data(), rest_.data(), forces_.lanes(), face_block_count_ * kLanes};
    run_blocks_of_faces(kernel, {first(blocks.begin), first(blocks.end)});
}

}  // namespace nuno
