// A grid sheet under small-step XPBD: strips of columns side by side in vectors, one sweep over the rows and its exact
// reverse a substep.
//
// Linearised, a substep is x+ = P y with P the projections and y the BDF2 prediction. Each eigenvalue p of P gives
// ((z - 1) (z - 1/3))^2 = (1 - 1/p) z^4 with p = 1 / (1 + (2 h omega / 3)^2), and |z| <= 1 for every real p in [0, 1]
// since BDF2 is A-stable. A sweep S and its reverse are P = S^T S, whose eigenvalues are real: no energy is pumped,
// however stiff the springs. One sweep alone has complex ones, and can. S begins with light passes over the seams and the
// odd columns, which the sweep itself would leave more strained than the rest.
#pragma once

#include <optional>
#include <vector>

#include "solver/base/team.h"
#include "solver/xpbd/strip_shares.h"
#include "solver/xpbd/strip_tethers.h"
#include "solver/xpbd/xpbd_part.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {

class StripSheet final : public XpbdPart
{
  public:
    // `model` and `sheet`, a grid that suits_strips accepts, must outlive it; `lanes` as in StripSweep.
    StripSheet(const ClothModel& model, const Sheet& sheet, int lanes);

    void upload(const ClothState& state) override;
    void upload_positions(std::span<const glm::vec4> positions) override;
    void upload_velocities(std::span<const glm::vec4> velocities) override;
    void set_vertex(std::uint32_t vertex, glm::vec4 position) override;
    void move_vertices(std::span<const VertexMove> moves) override;
    void step(const XpbdStep& step) override;
    void carry(Archive& archive, const SimParams& params) override;
    void download_positions(std::span<glm::vec4> positions) const override;
    void download_velocities(std::span<glm::vec4> velocities) const override;

  private:
    // What the threads of one step share.
    struct Work
    {
        const XpbdStep& step;
        StripMotion motion;
        StripSweep sweep;
    };
    // predict_rows, turn_rows, finish_rows, or null for none of them.
    using MoveRows = void (*)(const StripMotion& motion, Range rows);
    struct MovingPin
    {
        std::size_t number, place;  // among the model's handle pins; of its x in positions_
    };

    void prepare(const XpbdStep& step);
    void place_tethers(std::span<const Tether> all);
    void take_masses();
    void move_pins(const XpbdStep& step, int substep);
    void run_thread(const Work& work, const Team& team);
    void sweep_blocks(const Work& work, const StripMotion& motion, MoveRows before, Range blocks) const;
    void sweep_blocks_back(const Work& work, const StripMotion& motion, MoveRows after, Range blocks) const;
    void move_seams(const Work& work, const StripMotion& motion, MoveRows move, Range seams) const;
    Range block_rows(int block) const;
    Range seam_rows(int seam) const;
    Range rows_of_no_seam(int block) const;
    void put(StripLanes& to, std::uint32_t vertex, const glm::vec3& a);
    glm::vec3 at(const StripLanes& from, std::uint32_t vertex) const;
    void forget_last(std::uint32_t vertex);

    const ClothModel& model_;
    const Sheet& sheet_;
    const StripLayout layout_;
    const int lanes_;
    const int block_count_;
    std::vector<std::size_t> places_, lane_of_;  // of the sheet's vertices: of x in positions_, in mobility_
    std::vector<MovingPin> moving_pins_;

    StripLanes positions_, velocities_, last_positions_, last_velocities_, predicted_, accelerations_;
    StripLanes mobility_, sticking_;
    std::vector<float> inverse_masses_;  // [1/kg], one a vertex of the sheet
    float inverse_mass_ = 1;             // [1/kg] of most of them

    StripStiffnesses stiffnesses_;
    StripShareTables shares_;
    StripTetherSlots tethers_;
    bool masses_changed_ = true;
    std::optional<SimParams> made_for_;  // the parameters of shares_
    bool last_is_known_ = false;         // false: the next substep is the first
};

}  // namespace nuno
