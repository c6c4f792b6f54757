// Substeps of a sheet in strips.
#include "solver/xpbd/strip_sheet.h"

#include <algorithm>
#include <cmath>

namespace nuno {
namespace {

// Rows that a thread takes through prediction and sweep while they are in its cache.
constexpr int kChunkRows = 8;
// Blocks of rows sweep side by side; the rows between two of them wait for both. Their number depends on the sheet
// alone.
constexpr int kLeastBlockRows = 24, kMostBlocks = 8;
// Springs of a row reach this many rows further.
constexpr int kReachRows = 2;
// Masses that differ by less than this share are rounding of the mesh.
constexpr float kAlikeMass = 5e-4f;

int block_count_of(const StripLayout& layout)
{
    const int count = std::min(layout.rows / kLeastBlockRows, kMostBlocks);
    return std::max(count / 2 * 2, 1);
}

// Rows whose springs stay within the block: all but the last two, which are a seam; the last block has no seam.
Range inner_rows(Range rows, bool last) { return {rows.begin, last ? rows.end : rows.end - kReachRows}; }

}  // namespace

StripSheet::StripSheet(const ClothModel& model, const Sheet& sheet, int lanes)
    : model_(model),
      sheet_(sheet),
      layout_(make_strip_layout(sheet.columns, sheet.rows)),
      lanes_(lanes),
      block_count_(block_count_of(layout_)),
      places_(sheet.vertex_count),
      lane_of_(sheet.vertex_count),
      positions_(layout_.vec3_floats()),
      velocities_(layout_.vec3_floats()),
      last_positions_(layout_.vec3_floats()),
      last_velocities_(layout_.vec3_floats()),
      predicted_(layout_.vec3_floats()),
      mobility_(layout_.lane_floats()),
      sticking_(layout_.lane_floats()),
      inverse_masses_(sheet.vertex_count)
{
    for (int j = 0; j < layout_.rows; ++j)
        for (int i = 0; i < layout_.columns; ++i) {
            const std::uint32_t v = layout_.vertex(sheet, i, j) - sheet.first_vertex;
            places_[v] = layout_.vec3(i, j);
            lane_of_[v] = layout_.lane(i, j);
        }
    for (std::size_t n = 0; n < model.handle_pins.size(); ++n) {
        const std::uint32_t v = model.handle_pins[n].vertex - sheet.first_vertex;
        if (v < sheet.vertex_count) moving_pins_.push_back({n, places_[v]});
    }
}

void StripSheet::put(StripLanes& to, std::uint32_t vertex, const glm::vec3& a)
{
    float* const place = to.data() + places_[vertex - sheet_.first_vertex];
    for (int axis = 0; axis < 3; ++axis) place[axis * kStrips] = a[axis];
}

glm::vec3 StripSheet::at(const StripLanes& from, std::uint32_t vertex) const
{
    const float* const place = from.data() + places_[vertex - sheet_.first_vertex];
    return {place[0], place[kStrips], place[2 * kStrips]};
}

// For the next substep to begin at this vertex without a past.
void StripSheet::forget_last(std::uint32_t vertex)
{
    if (!made_for_) return;
    const formulas::Motion last = assumed_past(*made_for_, at(positions_, vertex), at(velocities_, vertex));
    put(last_positions_, vertex, last.position);
    put(last_velocities_, vertex, last.velocity);
}

void StripSheet::upload(const ClothState& state)
{
    for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v) {
        const std::uint32_t vertex = sheet_.first_vertex + v;
        put(positions_, vertex, glm::vec3(state.positions[vertex]));
        put(velocities_, vertex, glm::vec3(state.velocities[vertex]));
        inverse_masses_[v] = state.positions[vertex].w;
    }
    std::fill(sticking_.begin(), sticking_.end(), 0.0f);
    // Padding is a flat cloth of its own, like the sheet's first cell.
    const auto corner = [&](int i, int j) { return model_.rest_positions[layout_.vertex(sheet_, i, j)]; };
    const glm::vec3 origin = corner(0, 0), across = corner(1, 0) - origin, down = corner(0, 1) - origin;
    for (int j = 0; j < layout_.rows; ++j)
        for (int i = layout_.columns; i < layout_.width * kStrips; ++i) {
            const glm::vec3 x = origin + float(i) * across + float(j) * down;
            for (int axis = 0; axis < 3; ++axis) positions_[layout_.vec3(i, j) + std::size_t(axis * kStrips)] = x[axis];
        }
    masses_changed_ = true;
    last_is_known_ = false;
}

void StripSheet::upload_positions(std::span<const glm::vec4> positions)
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v)
        put(positions_, v, glm::vec3(positions[v]));
}

void StripSheet::upload_velocities(std::span<const glm::vec4> velocities)
{
    for (std::uint32_t v = sheet_.first_vertex; v < sheet_.first_vertex + sheet_.vertex_count; ++v) {
        const glm::vec3 velocity(velocities[v]);
        if (velocity == at(velocities_, v)) continue;
        put(velocities_, v, velocity);
        forget_last(v);
    }
}

void StripSheet::set_vertex(std::uint32_t vertex, glm::vec4 position)
{
    if (vertex - sheet_.first_vertex >= sheet_.vertex_count) return;
    put(positions_, vertex, glm::vec3(position));
    put(velocities_, vertex, glm::vec3(0));
    forget_last(vertex);
    float& inverse_mass = inverse_masses_[vertex - sheet_.first_vertex];
    masses_changed_ = masses_changed_ || inverse_mass != position.w;
    inverse_mass = position.w;
}

void StripSheet::move_vertices(std::span<const VertexMove> moves)
{
    for (const VertexMove& move : moves) {
        if (move.vertex - sheet_.first_vertex >= sheet_.vertex_count) continue;
        const glm::vec3 before = at(velocities_, move.vertex), velocity = before + move.velocity_gain;
        put(positions_, move.vertex, move.position);
        put(velocities_, move.vertex, velocity);
        if (velocity != before) forget_last(move.vertex);
    }
}

void StripSheet::place_tethers(std::span<const Tether> all)
{
    tethers_.clear();
    for (std::size_t first = sheet_.first_vertex; first < all.size(); first += model_.vertex_count())
        tethers_.add(layout_, sheet_, all.subspan(first, sheet_.vertex_count));
}

// Masses that most vertices have, or nearly, become a mobility of 1.
void StripSheet::take_masses()
{
    std::vector<float> free;
    std::copy_if(inverse_masses_.begin(), inverse_masses_.end(), std::back_inserter(free),
                 [](float w) { return w > 0; });
    const auto middle = free.begin() + std::ptrdiff_t(free.size() / 2);
    std::nth_element(free.begin(), middle, free.end());
    inverse_mass_ = free.empty() ? 1.0f : *middle;
    for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v) {
        const float mobility = inverse_masses_[v] / inverse_mass_;
        mobility_[lane_of_[v]] = std::abs(mobility - 1) < kAlikeMass ? 1.0f : mobility;
    }
}

void StripSheet::prepare(const XpbdStep& step)
{
    const SimParams& p = step.input.params;
    const XpbdChanges changes = xpbd_changes(made_for_, p);
    if (step.weights_changed || !made_for_) stiffnesses_ = strip_stiffnesses(model_, sheet_, layout_, step.weights);
    if (masses_changed_) take_masses();
    if (step.weights_changed || masses_changed_ || changes.shares)
        shares_.make(layout_, mobility_.data(), inverse_mass_, stiffnesses_, SubstepTimes(p).step, 2 * sweep_pairs(p),
                     p.strain_limit);
    if (changes.times) last_is_known_ = false;
    if (step.tethers_changed || !made_for_ || made_for_->tethers != p.tethers) place_tethers(step.tethers);
    masses_changed_ = false;
    made_for_ = p;
    if (!last_is_known_)
        for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v) forget_last(sheet_.first_vertex + v);
    last_is_known_ = true;
    tethers_.follow(positions_.data());
    if (p.tethers == Tethers::contacts && step.first_substep == 0 && step.bodies.steps().body_count() > 0) {
        const GridSpacing spacing{layout_.columns, layout_.rows, stiffnesses_.springs[kAcross].rest_length,
                                  stiffnesses_.springs[kDown].rest_length};
        tethers_.set_contacts(layout_, spacing, sticking_.data(), positions_.data(), 1 + p.tether_stretch);
    }
}

Range StripSheet::block_rows(int block) const
{
    return {layout_.rows * block / block_count_, layout_.rows * (block + 1) / block_count_};
}

// The last rows of block `seam`, whose springs reach into the next block.
Range StripSheet::seam_rows(int seam) const
{
    const int end = block_rows(seam).end;
    return {end - kReachRows, end};
}

// Rows of a block that no spring of a seam's rows touches.
Range StripSheet::rows_of_no_seam(int block) const
{
    const Range rows = block_rows(block);
    return {block == 0 ? rows.begin : rows.begin + kReachRows, inner_rows(rows, block + 1 == block_count_).end};
}

void StripSheet::sweep_blocks(const Work& work, const StripMotion& motion, MoveRows before, Range blocks) const
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const Range rows = inner_rows(block_rows(block), block + 1 == block_count_);
        for (int end = rows.end; end > rows.begin; end -= kChunkRows) {
            const Range chunk{std::max(end - kChunkRows, rows.begin), end};
            if (before) before(motion, {std::max(chunk.begin, rows_of_no_seam(block).begin), chunk.end});
            sweep_rows(work.sweep, chunk);
        }
    }
}

void StripSheet::sweep_blocks_back(const Work& work, const StripMotion& motion, MoveRows after, Range blocks) const
{
    for (int block = blocks.begin; block < blocks.end; ++block) {
        const Range rows = inner_rows(block_rows(block), block + 1 == block_count_);
        for (int begin = rows.begin; begin < rows.end; begin += kChunkRows) {
            const Range chunk{begin, std::min(begin + kChunkRows, rows.end)};
            sweep_rows_back(work.sweep, chunk);
            if (after) after(motion, {std::max(chunk.begin, rows_of_no_seam(block).begin), chunk.end});
        }
    }
}

// The springs of a seam are swept between the blocks on both of its sides, which go on to move it. Lightly once more
// before all and after all, they end with no more excess than others.
void StripSheet::move_seams(const Work& work, const StripMotion& motion, MoveRows move, Range seams) const
{
    for (int seam = seams.begin; seam < seams.end; ++seam) {
        const Range rows = seam_rows(seam);
        if (move != predict_rows) sweep_lightly_back(work.sweep, rows);
        move(motion, {rows.begin, rows.end + kReachRows});
        if (move != finish_rows) sweep_lightly(work.sweep, rows);
    }
}

void StripSheet::move_pins(const XpbdStep& step, int substep)
{
    const std::span<const PinStep> pins = step.bodies.steps().pin_steps(substep);
    for (const MovingPin& pin : moving_pins_)
        for (int axis = 0; axis < 3; ++axis) {
            positions_[pin.place + std::size_t(axis * kStrips)] = pins[pin.number].position[axis];
            velocities_[pin.place + std::size_t(axis * kStrips)] = pins[pin.number].velocity[axis];
        }
    tethers_.follow(positions_.data());
}

void StripSheet::run_thread(const Work& work, const Team& team)
{
    const SimParams& p = work.step.input.params;
    const Range blocks = team.part(block_count_), seams = team.part(block_count_ - 1);
    BodyContacts contacts = work.step.bodies.contacts(0, p), last_contacts = contacts;
    StripMotion motion = work.motion;
    const auto start = [&](int k) {
        contacts.bodies = work.step.bodies.steps().bodies(k);
        motion.bodies = contacts.bodies.empty() ? nullptr : &contacts;
        motion.common = common_acceleration(p, work.step.input.start_time_s + k * double(motion.times.h));
    };
    const auto end = [&] {
        last_contacts.bodies = contacts.bodies;
        motion.last_bodies = motion.bodies ? &last_contacts : nullptr;
        motion.last_common = motion.common;
    };

    const int first = work.step.first_substep, last = first + work.step.substep_count - 1, pairs = sweep_pairs(p);
    bool started = false;
    for (int k = first; k <= last; ++k) {
        if (!started) {
            if (!moving_pins_.empty()) {
                team.wait();
                if (team.leads()) move_pins(work.step, k);
                team.wait();
            }
            start(k);
            move_seams(work, motion, predict_rows, seams);
        }
        // Pins move between two substeps.
        const bool turns = k < last && moving_pins_.empty();
        const MoveRows finish_or_turn = turns ? turn_rows : finish_rows;
        for (int pair = 0; pair < pairs; ++pair) {
            team.wait();
            sweep_blocks(work, motion, pair == 0 && !started ? predict_rows : nullptr, blocks);
            team.wait();
            for (int seam = seams.begin; seam < seams.end; ++seam) {
                sweep_rows(work.sweep, seam_rows(seam));
                sweep_rows_back(work.sweep, seam_rows(seam));
            }
            team.wait();
            if (pair + 1 < pairs) {
                sweep_blocks_back(work, motion, nullptr, blocks);
                continue;
            }
            end();
            if (turns) start(k + 1);
            sweep_blocks_back(work, motion, finish_or_turn, blocks);
        }
        team.wait();
        move_seams(work, motion, finish_or_turn, seams);
        started = turns;
    }
}

void StripSheet::carry(Archive& archive, const SimParams& params)
{
    bool known = last_is_known_ && !xpbd_changes(made_for_, params).times;
    archive.value(known);
    last_is_known_ = known;
    if (archive.reads()) made_for_ = params;
    if (known)
        for (StripLanes* lanes : {&last_positions_, &last_velocities_}) archive.values(std::span(*lanes));
    archive.values(std::span(sticking_));
}

void StripSheet::step(const XpbdStep& step)
{
    prepare(step);
    const SimParams& p = step.input.params;
    if (!step.accelerations.empty()) {
        accelerations_.resize(layout_.vec3_floats());
        for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v)
            put(accelerations_, sheet_.first_vertex + v, step.accelerations[sheet_.first_vertex + v]);
    }
    const StripMotion motion{.layout = &layout_,
                             .positions = positions_.data(),
                             .velocities = velocities_.data(),
                             .last_positions = last_positions_.data(),
                             .last_velocities = last_velocities_.data(),
                             .predicted = predicted_.data(),
                             .mobility = mobility_.data(),
                             .acceleration = step.accelerations.empty() ? nullptr : accelerations_.data(),
                             .common = {},
                             .last_common = {},
                             .times = SubstepTimes(p),
                             .tethers = tethers_.slots(),
                             .anchors = tethers_.anchors(),
                             .bodies = nullptr,
                             .last_bodies = nullptr,
                             .sticking = p.tethers == Tethers::contacts ? sticking_.data() : nullptr,
                             .lanes = lanes_};
    const StripSweep sweep{.positions = positions_.data(),
                           .layout = &layout_,
                           .springs = shares_.terms,
                           .has_plate = shares_.has_plate,
                           .limited = p.strain_limit > 0,
                           .rows = shares_.rows.data(),
                           .lanes = lanes_};
    const Work work{step, motion, sweep};
    run_team(step.pool, std::min(team_size(step.pool, sheet_.vertex_count), block_count_),
             [&](const Team& team) { run_thread(work, team); });
}

void StripSheet::download_positions(std::span<glm::vec4> positions) const
{
    for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v) {
        const float* const at = positions_.data() + places_[v];
        positions[sheet_.first_vertex + v] = {at[0], at[kStrips], at[2 * kStrips], inverse_masses_[v]};
    }
}

void StripSheet::download_velocities(std::span<glm::vec4> velocities) const
{
    for (std::uint32_t v = 0; v < sheet_.vertex_count; ++v) {
        const float* const at = velocities_.data() + places_[v];
        const std::uint32_t vertex = sheet_.first_vertex + v;
        velocities[vertex] = {at[0], at[kStrips], at[2 * kStrips], model_.areas[vertex]};
    }
}

}  // namespace nuno
