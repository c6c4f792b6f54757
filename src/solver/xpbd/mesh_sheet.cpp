// Substeps of a sheet in colours.
#include "solver/xpbd/mesh_sheet.h"

#include <map>

namespace nuno {

MeshSheet::MeshSheet(const ClothModel& model, const Sheet& sheet, bool in_stars, int lanes)
    : model_(model), sheet_(sheet), in_stars_(in_stars), lanes_(lanes), constraints_(model, sheet)
{
    const std::size_t padded = (sheet.vertex_count + kMeshBlock - 1) / kMeshBlock * kMeshBlock;
    positions_.resize(padded + kSparePlaces);
    velocities_.resize(padded);
    last_positions_.resize(padded);
    last_velocities_.resize(padded);
    predicted_.resize(padded);
}

void MeshSheet::upload(const ClothState& state)
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v) {
        positions_[place(v)] = state.positions[v];
        velocities_[place(v)] = state.velocities[v];
    }
    masses_changed_ = true;
    last_is_known_ = false;
}

// For the next substep to begin at this vertex without a past.
void MeshSheet::forget_last(std::size_t place)
{
    if (!made_for_) return;
    const formulas::Motion last = assumed_past(*made_for_, glm::vec3(positions_[place]), glm::vec3(velocities_[place]));
    last_positions_[place] = glm::vec4(last.position, 0);
    last_velocities_[place] = glm::vec4(last.velocity, 0);
}

void MeshSheet::upload_positions(std::span<const glm::vec4> positions)
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v)
        positions_[place(v)] = glm::vec4(glm::vec3(positions[v]), positions_[place(v)].w);
}

void MeshSheet::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v)
        if (glm::vec3(velocities[v]) != glm::vec3(velocities_[place(v)])) {
            velocities_[place(v)] = velocities[v];
            forget_last(place(v));
        }
}

void MeshSheet::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    if (vertex - sheet_.first_vertex >= sheet_.vertex_count) return;
    glm::vec4& x = positions_[place(vertex)];
    masses_changed_ = masses_changed_ || x.w != position.w;
    x = position;
    velocities_[place(vertex)] = glm::vec4(0);
    forget_last(place(vertex));
}

void MeshSheet::move_vertices(std::span<const VertexMove> moves)
{
    for (const VertexMove& move : moves) {
        if (move.vertex - sheet_.first_vertex >= sheet_.vertex_count) continue;
        const std::size_t at = place(move.vertex);
        const glm::vec4 before = velocities_[at];
        positions_[at] = glm::vec4(move.position, positions_[at].w);
        velocities_[at] += glm::vec4(move.velocity_gain, 0);
        if (velocities_[at] != before) forget_last(at);
    }
}

void MeshSheet::place_tethers(std::span<const Tether> all)
{
    constexpr float no_tether = 1e18f;
    tethers_.clear();
    anchor_places_.clear();
    if (all.empty()) return;
    std::map<std::uint32_t, std::uint32_t> known;
    for (std::size_t slot = 0; slot < std::size_t(kTethersPerVertex); ++slot) {
        MeshTethers& to = tethers_.emplace_back();
        to.anchor_of.assign(velocities_.size(), 0);
        to.lengths.assign(velocities_.size(), no_tether);
        for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v) {
            const Tether& tether = all[slot * model_.vertex_count() + v];
            if (tether.anchor == Tether::kNone) continue;
            const auto [at, added] = known.emplace(tether.anchor, static_cast<std::uint32_t>(anchor_places_.size()));
            if (added) anchor_places_.push_back(static_cast<std::uint32_t>(place(tether.anchor)));
            const auto lanes = static_cast<std::size_t>(lanes_);
            const std::size_t slot_place = place(v) / lanes * lanes + run_lane(lanes_, place(v) % lanes);
            to.anchor_of[slot_place] = 4 * at->second;
            to.lengths[slot_place] = tether.length;
        }
    }
    if (anchor_places_.empty()) tethers_.clear();
}

void MeshSheet::prepare(const XpbdStep& step)
{
    const SimParams& p = step.input.params;
    const XpbdChanges changes = xpbd_changes(made_for_, p);
    const bool limited = p.strain_limit > 0;
    const bool weights_changed = step.weights_changed || !made_for_ || (made_for_->strain_limit > 0) != limited;
    if (weights_changed) {
        using Layout = MeshConstraints::Layout;
        const Layout layout = limited ? Layout::limited_springs : in_stars_ ? Layout::stars : Layout::springs;
        constraints_.choose(step.weights, static_cast<std::uint32_t>(velocities_.size()), layout);
    }
    if (weights_changed || masses_changed_ || changes.shares)
        constraints_.set_numbers(SubstepTimes(p).step, 2 * sweep_pairs(p), p.strain_limit, positions_);
    if (step.tethers_changed) place_tethers(step.tethers);
    if (changes.times) last_is_known_ = false;
    masses_changed_ = false;
    made_for_ = p;
    if (!last_is_known_)
        for (std::size_t place = 0; place < velocities_.size(); ++place) forget_last(place);
    last_is_known_ = true;
}

void MeshSheet::move_pins(const XpbdStep& step, int substep)
{
    const std::span<const HandlePin> pins = step.bodies.steps().pins();
    for (std::size_t n = 0; n < pins.size(); ++n) {
        if (pins[n].vertex - sheet_.first_vertex >= sheet_.vertex_count) continue;
        const PinStep& pin = step.bodies.steps().pin_steps(substep)[n];
        positions_[place(pins[n].vertex)] = glm::vec4(glm::vec3(pin.position), 0);
        velocities_[place(pins[n].vertex)] = pin.velocity;
    }
    anchors_.clear();
    for (const std::uint32_t at : anchor_places_) anchors_.push_back(positions_[at]);
}

void MeshSheet::sweep_pair(const Team& team)
{
    float* const positions = &positions_[0].x;
    const bool limited = made_for_->strain_limit > 0;
    const ConstraintColours &springs = constraints_.springs(), &plates = constraints_.plates();
    const StarSprings* const stars = constraints_.stars();
    const int star_colours = stars ? stars->colour_count() : 0, spring_colours = springs.colour_count();
    // Colours of stars, then of springs, then of plates.
    const auto sweep = [&](int colour, bool back) {
        if (colour < star_colours)
            stars->project(colour, back, positions, lanes_, team);
        else if (colour - star_colours < spring_colours)
            project_springs(springs, team.part(springs.batches(colour - star_colours)), limited, positions, lanes_);
        else
            project_plates(plates, team.part(plates.batches(colour - star_colours - spring_colours)), positions,
                           lanes_);
        team.wait();
    };
    const int colour_count = star_colours + spring_colours + plates.colour_count();
    for (int colour = 0; colour < colour_count; ++colour) sweep(colour, false);
    for (int colour = colour_count - 1; colour >= 0; --colour) sweep(colour, true);
}

void MeshSheet::run_thread(const XpbdStep& step, MeshMotion motion, const Team& team)
{
    const SimParams& p = step.input.params;
    const Range blocks = team.part(static_cast<int>(velocities_.size()) / kMeshBlock);
    BodyContacts contacts = step.bodies.contacts(0, p);
    for (int k = step.first_substep; k < step.first_substep + step.substep_count; ++k) {
        contacts.bodies = step.bodies.steps().bodies(k);
        motion.bodies = contacts.bodies.empty() ? nullptr : &contacts;
        motion.common = common_acceleration(p, step.input.start_time_s + k * double(motion.times.h));
        if (team.leads()) move_pins(step, k);
        team.wait();
        motion.anchors = anchors_.empty() ? nullptr : &anchors_[0].x;
        predict_blocks(motion, blocks);
        team.wait();
        for (int pair = 0; pair < sweep_pairs(p); ++pair) sweep_pair(team);
        finish_blocks(motion, blocks);
        team.wait();
    }
}

void MeshSheet::carry(Archive& archive, const SimParams& params)
{
    bool known = last_is_known_ && !xpbd_changes(made_for_, params).times;
    archive.value(known);
    last_is_known_ = known;
    if (archive.reads()) made_for_ = params;
    if (!known) return;
    for (Vec4s* values : {&last_positions_, &last_velocities_}) archive.values(std::span(*values));
}

void MeshSheet::step(const XpbdStep& step)
{
    prepare(step);
    if (!step.accelerations.empty()) {
        accelerations_.resize(velocities_.size());
        for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v)
            accelerations_[place(v)] = glm::vec4(step.accelerations[v], 0);
    }
    const auto numbers = [](Vec4s& a) { return a.empty() ? nullptr : &a[0].x; };
    const MeshMotion motion{.positions = numbers(positions_),
                            .velocities = numbers(velocities_),
                            .last_positions = numbers(last_positions_),
                            .last_velocities = numbers(last_velocities_),
                            .predicted = numbers(predicted_),
                            .acceleration = step.accelerations.empty() ? nullptr : numbers(accelerations_),
                            .common = {},
                            .times = SubstepTimes(step.input.params),
                            .tethers = tethers_,
                            .anchors = nullptr,
                            .bodies = nullptr,
                            .lanes = lanes_};
    run_team(step.pool, team_size(step.pool, sheet_.vertex_count),
             [&](const Team& team) { run_thread(step, motion, team); });
}

void MeshSheet::download_positions(std::span<glm::vec4> positions) const
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v)
        positions[v] = positions_[place(v)];
}

void MeshSheet::download_velocities(std::span<glm::vec4> velocities) const
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v)
        velocities[v] = glm::vec4(glm::vec3(velocities_[place(v)]), model_.areas[v]);
}

}  // namespace nuno
