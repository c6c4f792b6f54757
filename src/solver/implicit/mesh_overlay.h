// A grid laid over a flat mesh at rest, as the next coarser level of its matrix.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "model/cloth_model.h"
#include "solver/implicit/grid_multigrid.h"

namespace nuno {

// A pair of mesh vertices (places), and its block of the matrix (0 where one of them is fixed).
struct OverlayPair
{
    std::uint32_t a, b;
    std::size_t entry;  // where the mesh keeps its stiffness
};

class MeshOverlay
{
  public:
    // None where the mesh is not flat. `places`: of the sheet's vertices. `pairs`: all springs of the sheet, once each.
    static std::optional<MeshOverlay> make(const ClothModel& model, const Sheet& sheet,
                                           const std::vector<std::size_t>& places, std::vector<OverlayPair> pairs);

    const std::vector<OverlayPair>& pairs() const { return pairs_; }
    Field6& blocks() { return blocks_; }  // one a pair, to be filled before coarsen

    // Anchors: what each vertex resists with by itself, and the blocks that tie it to fixed ones.
    struct Tie
    {
        std::size_t place;
        float block[6];
    };
    void coarsen(const Field& mass, std::span<const Tie> ties, const Team& team);
    // z += P B P^T t where `mass` is positive.
    void correct(const Field& mass, const Field3& t, Field3& z, const SheetRows& rows, const Team& team);

  private:
    MeshOverlay(int columns, int rows) : grids_(columns, rows) {}
    void place_vertices(const std::vector<glm::dvec2>& at, const std::vector<std::size_t>& places, std::size_t size);
    void place_pairs(const std::vector<glm::dvec2>& at_place);

    // Lists of unequal length: those of item i are entries[first[i]] .. entries[first[i + 1]].
    struct Share
    {
        std::uint32_t from;
        float weight;
    };
    struct Shares
    {
        std::vector<std::uint32_t> first;
        std::vector<Share> entries;
    };
    static Shares in_order(const std::vector<std::vector<Share>>& lists);

    CoarseGrids grids_;
    std::vector<OverlayPair> pairs_;
    Field6 blocks_;
    std::vector<std::array<Share, 4>> parents_;  // of each place: coarse places
    Shares children_;                            // of each coarse vertex (row by row): places
    std::array<Shares, 4> linked_;               // of each coarse link: pairs
};

}  // namespace nuno
