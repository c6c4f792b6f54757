// Vertex block descent on CPU threads.
#include "solver/vbd/cpu_vbd.h"

#include <utility>

namespace nuno {

// What the kernels of one substep read and write, all by place.
struct CpuVbd::Substep
{
    const VbdTerms& terms;
    ForceTerms forces;  // at the start, where x and v are read
    BodyContacts bodies;
    Lanes3 x, v;  // x: first the start of the descent, in the end the new state; v: the new state
    Lanes3 moves, targets;
    float* mobility;
    TetherLanes tethers;
};

namespace {

using Formulas = formulas_wide;

// Where each vertex would go without springs: the target, from which the descent starts.
NUNO_SIMD_CLONES void predict_blocks(const CpuVbd::Substep& s, Range blocks)
{
    const WideFloat h(s.terms.h);
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(s.forces.x, i), v = load(s.forces.v, i);
        const WideFloat area(s.forces.area + i), inverse_mass(s.forces.inverse_mass + i);
        const WideVec3 faces = s.forces.faces ? s.forces.faces->force_on_block(block) : WideVec3(0.0f);
        const WideVec3 a =
            Formulas::acceleration(inverse_mass, area * WideFloat(s.forces.areal_density), wide(s.forces.gravity),
                                   WideFloat(0.0f), v, faces, area * WideFloat(s.forces.wind));
        const WideFloat keep = Formulas::vbd_keep(inverse_mass, area * WideFloat(s.forces.damping), h);
        const Formulas::Motion free = Formulas::vbd_free_motion(x, v, a, keep, h);
        const WideVec3 to = select_positive(inverse_mass, within_tethers(s.tethers, s.forces.x, i, free.position), x);
        const WideVec3 target = h * free.velocity + select_positive(inverse_mass, to - free.position, WideVec3(0.0f));
        store(s.x, i, to);
        store(s.moves, i, target);
        store(s.targets, i, target);
        (h * h * inverse_mass * keep).store(s.mobility + i);
    }
}

NUNO_SIMD_CLONES void descend_blocks(const CpuVbd::Substep& s, Range blocks)
{
    const SpringBlocks& springs = s.forces.springs;
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(s.x, i), move = load(s.moves, i);
        Formulas::VertexBlock sum = Formulas::empty_block();
        const auto b = static_cast<std::size_t>(block);
        for (std::uint32_t slot = springs.first_slot[b]; slot < springs.first_slot[b + 1]; ++slot) {
            const WideVec3 d = load_neighbours(springs, slot, s.x) - x;
            const WideFloat tension(&springs.tension[slot * kLanes]), axial(&springs.axial[slot * kLanes]);
            sum = Formulas::with_spring(sum, d, WideFloat(&springs.stiffness[slot * kLanes]), tension, axial);
            if (s.terms.stiffer > 0)
                sum = Formulas::with_limit(sum, d, tension, axial, WideFloat(s.terms.longest),
                                           WideFloat(s.terms.stiffer));
            if (s.terms.damper > 0) {
                const WideVec3 w = load_neighbours(springs, slot, s.moves) - move;
                sum = Formulas::with_damper(sum, d, w, WideFloat(s.terms.damper) * axial);
            }
        }
        const WideVec3 step = Formulas::newton_step(sum, load(s.targets, i), move, WideFloat(s.mobility + i));
        store(s.moves, i, move + step);
        store(s.x, i, x + step);
    }
}

NUNO_SIMD_CLONES void finish_blocks(const CpuVbd::Substep& s, Range blocks)
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const std::int32_t i = block * kLanes;
        const WideVec3 x = load(s.x, i), v = WideFloat(s.terms.inverse_h) * load(s.moves, i);
        const Formulas::Motion held = push_out_of_bodies<kLanes>(s.bodies, load(s.forces.x, i), {x, v}).motion;
        const WideFloat inverse_mass(s.forces.inverse_mass + i);
        store(s.x, i, select_positive(inverse_mass, held.position, x));
        store(s.v, i, select_positive(inverse_mass, held.velocity, load(s.forces.v, i)));
    }
}

}  // namespace

CpuVbd::CpuVbd(const ClothModel& model, const Bodies& bodies, const SimParams&, ThreadPool& pool)
    : CpuVbd(model, bodies, colour_vertices(model, kLanes), pool)
{
}

CpuVbd::CpuVbd(const ClothModel& model, const Bodies& bodies, VertexColours colours, ThreadPool& pool)
    : CpuSolver(colours.places, colours.place_count(), pool),
      model_(model),
      colours_(std::move(colours)),
      placed_(placed_model(model, colours_)),
      forces_(placed_, kVbdSprings),
      bodies_(bodies, placed_),
      moves_(place_count_),
      targets_(place_count_),
      mobility_(place_count_),
      tethers_(model, colours_.places, place_count_)
{
}

void CpuVbd::upload(const ClothState& state)
{
    CpuSolver::upload(state);
    tethers_.pins().upload(state);
}

void CpuVbd::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    CpuSolver::set_vertex(vertex, position);
    tethers_.pins().set_vertex(vertex, position);
}

void CpuVbd::refresh(const SimParams& params)
{
    forces_.refresh(params);
    if (!terms_for_ || !same_params(*terms_for_, params)) terms_ = vbd_terms(model_, params);
    terms_for_ = params;
    tethers_.refresh(params);
}

void CpuVbd::step(const StepInput& input)
{
    if (input.substep_count <= 0) return;
    refresh(input.params);
    bodies_.plan(input);
    run_substeps(input.substep_count, [&](int k, const Team& team) { run_substep(substep_at(input, k), k, team); });
}

CpuVbd::Substep CpuVbd::substep_at(const StepInput& input, int k)
{
    const int from = (current_ + k) % 2;
    const StateLanes next = state(1 - from);
    return {.terms = terms_,
            .forces = forces_.terms(input.params, input.start_time_s + k * double(terms_.h), state(from)),
            .bodies = bodies_.contacts(k, input.params),
            .x = next.x,
            .v = next.v,
            .moves = moves_.lanes(),
            .targets = targets_.lanes(),
            .mobility = mobility_.first(),
            .tethers = tethers_.lanes()};
}

void CpuVbd::run_substep(const Substep& s, int k, const Team& team)
{
    const Range blocks = team.part(block_count());
    if (!placed_.handle_pins.empty()) {
        bodies_.place_pins(k, blocks, s.forces.x, s.forces.v);
        team.wait();
    }
    run_face_pass(s.forces, blocks, team);
    predict_blocks(s, blocks);
    team.wait();
    // The way there and back over the colours: its exact reverse keeps a sweep from pumping energy into the cloth.
    const int last = colours_.colour_count() - 1;
    for (int iteration = 0; iteration < terms_.iterations; ++iteration)
        for (int turn = iteration == 0 ? 0 : 1; turn <= 2 * last; ++turn) {
            const auto colour = static_cast<std::size_t>(turn <= last ? turn : 2 * last - turn);
            descend_blocks(s, team.part({static_cast<int>(colours_.first_place[colour]) / kLanes,
                                         static_cast<int>(colours_.first_place[colour + 1]) / kLanes}));
            team.wait();
        }
    finish_blocks(s, blocks);
    team.wait();
}

}  // namespace nuno
