// A sheet of any mesh under small-step XPBD: its springs, or stars of them, colour by colour, then in the exact reverse
// (why: see solver/xpbd/strip_sheet.h).
#pragma once

#include <optional>
#include <vector>

#include "solver/base/team.h"
#include "solver/xpbd/mesh_constraints.h"
#include "solver/xpbd/mesh_motion.h"
#include "solver/xpbd/xpbd_part.h"
#include "solver/xpbd/xpbd_terms.h"

namespace nuno {

class MeshSheet final : public XpbdPart
{
  public:
    // `model` and `sheet` must outlive it; `lanes` as in MeshMotion. `in_stars`: springs that have no limit are swept in
    // stars.
    MeshSheet(const ClothModel& model, const Sheet& sheet, bool in_stars, int lanes);

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
    using Vec4s = std::vector<glm::vec4>;

    void prepare(const XpbdStep& step);
    void place_tethers(std::span<const Tether> all);
    void move_pins(const XpbdStep& step, int substep);
    void run_thread(const XpbdStep& step, MeshMotion motion, const Team& team);
    void sweep_pair(const Team& team);
    void forget_last(std::size_t place);
    std::size_t place(std::uint32_t vertex) const { return constraints_.places()[vertex - sheet_.first_vertex]; }

    const ClothModel& model_;
    const Sheet& sheet_;
    const bool in_stars_;
    const int lanes_;
    MeshConstraints constraints_;

    // By place, as MeshConstraints numbers the vertices.
    Vec4s positions_, velocities_, last_positions_, last_velocities_, predicted_, accelerations_, anchors_;
    std::vector<MeshTethers> tethers_;
    std::vector<std::uint32_t> anchor_places_;
    bool masses_changed_ = true;
    std::optional<SimParams> made_for_;  // the parameters of the constraints
    bool last_is_known_ = false;         // false: the next substep is the first
};

}  // namespace nuno
