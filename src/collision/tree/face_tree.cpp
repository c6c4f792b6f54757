// Topology and refit of the tree of faces.
#include "collision/tree/face_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>

#include "core/task_share.h"

namespace nuno {
namespace {

// Cloths with fewer faces are done in less time than it takes to wake a thread.
constexpr std::uint32_t kLargeFaceCount = 8192;
constexpr std::uint32_t kVerticesInRun = 8192, kNodesInChunk = 512;
// Levels above the cells whose boxes one task makes: 4^5 nodes of level 0.
constexpr int kParentLevels = 5;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<Sheet> one_mesh(std::uint32_t vertex_count, std::uint32_t face_count)
{
    return {{"", 0, vertex_count, 0, face_count, 0, 0, {}}};
}

int band_height(const GridPatch& grid) { return std::clamp((grid.rows / 8 + 3) / 4 * 4, 16, 64); }

}  // namespace

FaceTree::FaceTree(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
                   std::span<const Sheet> sheets)
    : rest_positions_(rest_positions.begin(), rest_positions.end()),
      faces_(faces.begin(), faces.end()),
      kernels_(&machine_tree_kernels())
{
    assert(!faces.empty());
    const auto vertex_count = static_cast<std::uint32_t>(rest_positions.size());
    const std::vector<Sheet> single = one_mesh(vertex_count, static_cast<std::uint32_t>(faces.size()));
    if (sheets.empty()) sheets = single;
    layout_ = make_tree_layout(rest_positions, faces, sheets);
    assert(layout_.levels.size() <= kMostLevels);
    share_out(sheets, vertex_count);
    find_places();
    for (const GridPatch& grid : layout_.grids) {
        const GridProof& proof = proofs_.emplace_back(grid, rest_positions);
        proof_levels_.emplace_back();
        for (int level = 1; level < kMostLevels; ++level) proof_levels_.push_back(proof.level(level));
    }
}

FaceTree::FaceTree(const ClothModel& model) : FaceTree(model.rest_positions, model.faces, model.sheets) {}

void FaceTree::find_places()
{
    grid_places_.resize(faces_.size());
    for (std::uint32_t g = 0; g < layout_.grids.size(); ++g) {
        const GridPatch& grid = layout_.grids[g];
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i)
                for (const auto& faces : grid.faces)
                    grid_places_[faces[static_cast<std::size_t>(j * grid.face_stride() + i)]] = {
                        g, static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)};
    }
}

// The partition is a property of the mesh, so the result does not depend on the number of threads.
void FaceTree::share_out(std::span<const Sheet> sheets, std::uint32_t vertex_count)
{
    is_large_ = faces_.size() >= kLargeFaceCount;
    sheet_count_ = sheets.size();
    for (std::uint32_t s = 0; s < sheets.size(); ++s) {
        const std::uint32_t end = std::min(sheets[s].first_vertex + sheets[s].vertex_count, vertex_count);
        for (std::uint32_t v = sheets[s].first_vertex; v < end; v += kVerticesInRun)
            vertex_runs_.push_back({v, std::min(v + kVerticesInRun, end), s});
    }
    for (const GridPatch& grid : layout_.grids)
        for (int row = 0; row < grid.rows; row += band_height(grid))
            bands_.push_back({&grid, row, std::min(row + band_height(grid), grid.rows), false, nullptr, 0, nullptr});
    for (const NodeRun run : layout_.mesh_nodes)
        for (std::uint32_t n = run.begin; n < run.end; n += kNodesInChunk)
            mesh_chunks_.push_back({n, std::min(n + kNodesInChunk, run.end)});
    neighbours_.resize(bands_.size());
}

void FaceTree::share(ThreadPool& pool, int task_count, const std::function<void(int task, int thread)>& body)
{
    if (!is_large_)
        for (int task = 0; task < task_count; ++task) body(task, 0);
    else
        share_tasks(pool, task_count, body);
}

void FaceTree::refit(const Poses& poses, const TreeSettings& settings, ThreadPool& pool)
{
    settings_ = settings;
    parts_.clear();
    visits_ = 0;
    for (BandFound& found : neighbours_) {
        found.faces.clear();
        found.nodes.clear();
    }
    if (workers_.size() < static_cast<std::size_t>(pool.thread_count())) {
        workers_.resize(static_cast<std::size_t>(pool.thread_count()));
        int columns = 0;
        for (const GridPatch& grid : layout_.grids) columns = std::max(columns, grid.columns);
        for (Worker& worker : workers_) worker.rows.resize(columns);
    }
    frame_.t0 = poses.t0.data();
    frame_.t1 = poses.is_swept() ? poses.t1.data() : nullptr;
    proven_apart_ = false;
    if (settings.culling == Culling::sound) {
        const bool all = prove(poses, settings, pool);
        if (all && sheet_count_ == 1) proven_apart_ = true;
        if (proven_apart_) return;
        frame_boxes(settings.distance + settings.margin, pool);
        proven_apart_ = all && sheets_are_apart();
        if (proven_apart_) return;
    } else {
        frame_boxes(settings.distance + settings.margin, pool);
    }
    if (settings.culling == Culling::seed) seed_flags_.mark(layout_, faces_, poses.t1, pool);
    make_boxes(pool);
    make_parents(pool);
}

bool FaceTree::prove(const Poses& poses, const TreeSettings& settings, ThreadPool& pool)
{
    for (GridProof& proof : proofs_) proof.clear();
    share(pool, static_cast<int>(bands_.size()), [&](int task, int thread) {
        const GridBand& band = bands_[static_cast<std::size_t>(task)];
        const EdgeLevel& blocks = proofs_[static_cast<std::size_t>(band.grid - layout_.grids.data())].base();
        RowScratch& rows = workers_[static_cast<std::size_t>(thread)].rows;
        kernels_->edge_bounds(poses.t0.data(), band, blocks, rows);
        if (poses.is_swept()) kernels_->edge_bounds(poses.t1.data(), band, blocks, rows);
    });
    bool all = true;
    for (GridProof& proof : proofs_) {
        proof.prove(settings, *kernels_);
        all = all && proof.holds_for_all();
    }
    if (layout_.meshes.empty()) return all;
    // They take a while to make, and not every tree is asked to cull.
    if (!charts_) charts_.emplace(layout_, rest_positions_, faces_);
    charts_->prove(poses, settings, *kernels_, pool);
    return all && charts_->holds_for_all();
}

// The frame takes the middle of all displacements out of t1: what all vertices do together brings nothing nearer.
void FaceTree::frame_boxes(float distance, ThreadPool& pool)
{
    extents_.resize(vertex_runs_.size());
    share(pool, static_cast<int>(vertex_runs_.size()), [&](int task, int) {
        const VertexRun run = vertex_runs_[static_cast<std::size_t>(task)];
        extents_[static_cast<std::size_t>(task)] = kernels_->vertex_extent(frame_, run.begin, run.end);
    });
    glm::vec3 lo(kInfinity), hi(-kInfinity);
    for (const VertexExtent& extent : extents_) {
        lo = glm::min(lo, glm::vec3(extent.motion_lo));
        hi = glm::max(hi, glm::vec3(extent.motion_hi));
    }
    const glm::vec3 shift = 0.5f * (lo + hi), reach = glm::max(hi - shift, shift - lo);

    lo = glm::vec3(kInfinity), hi = -lo;
    sheet_boxes_.assign(sheet_count_, {lo, hi});
    for (std::size_t r = 0; r < vertex_runs_.size(); ++r) {
        FaceBox& sheet = sheet_boxes_[vertex_runs_[r].sheet];
        sheet.lo = glm::min(sheet.lo, glm::vec3(extents_[r].lo) - reach);
        sheet.hi = glm::max(sheet.hi, glm::vec3(extents_[r].hi) + reach);
        lo = glm::min(lo, sheet.lo);
        hi = glm::max(hi, sheet.hi);
    }
    // Rounding of a position less the shift, and of a side less the growth: each below half of 2^-23 of its size.
    const glm::vec3 size = glm::max(glm::abs(lo), glm::abs(hi)) + glm::abs(shift);
    frame_.growth = 0.5f * distance * (1.0f + 0x1p-20f) + 0x1p-22f * std::max({size.x, size.y, size.z});
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        frame_.shift[a] = shift[axis];
        frame_.centre[a] = 0.5f * (lo[axis] + hi[axis]);
        frame_.scale[a] = 65000.0f / std::max(hi[axis] - lo[axis] + 2 * frame_.growth, 1e-20f);
    }
    for (FaceBox& sheet : sheet_boxes_) {
        sheet.lo -= 2 * frame_.growth;
        sheet.hi += 2 * frame_.growth;
    }
}

bool FaceTree::sheets_are_apart() const
{
    for (std::size_t a = 0; a < sheet_count_; ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (sheet_boxes_[a].overlaps(sheet_boxes_[b])) return false;
    return true;
}

void FaceTree::make_boxes(ThreadPool& pool)
{
    const std::size_t band_count = bands_.size(), task_count = band_count + mesh_chunks_.size();
    TreeNode* const nodes = layout_.levels[0].data();
    share(pool, static_cast<int>(task_count), [&](int task, int thread) {
        const auto t = static_cast<std::size_t>(task);
        if (t >= band_count) {
            const NodeRun chunk = mesh_chunks_[t - band_count];
            return kernels_->cell_boxes(frame_, layout_.cells.data(), nodes, chunk.begin, chunk.end);
        }
        GridBand band = bands_[t];
        RowScratch& rows = workers_[static_cast<std::size_t>(thread)].rows;
        GridProof& proof = proofs_[static_cast<std::size_t>(band.grid - layout_.grids.data())];
        if (settings_.culling == Culling::sound) proof.prove_cells(frame_, band, *kernels_, rows);
        if (!band.grid->is_regular) return;
        band.with_neighbours = settings_.culling != Culling::seed;
        if (settings_.culling == Culling::sound) {
            band.open_blocks = proof.open_blocks();
            band.open_stride = proof.block_columns();
            band.apart_cells = proof.apart_cells();
        }
        BandFound found = std::move(neighbours_[t]);
        kernels_->grid_boxes(frame_, band, nodes, found, rows);
        neighbours_[t] = std::move(found);
    });
}

void FaceTree::make_parents(ThreadPool& pool)
{
    std::vector<std::vector<TreeNode>>& levels = layout_.levels;
    const int level_count = static_cast<int>(levels.size()), shared = std::min(kParentLevels, level_count - 1);
    // Nodes that fill a level up to fours have nothing below.
    const auto make = [&](int level, std::size_t begin, std::size_t width) {
        const auto l = static_cast<std::size_t>(level);
        const std::size_t end = std::min(begin + width, levels[l - 1].size() / 4);
        if (begin >= end) return;
        kernels_->parent_boxes(levels[l - 1].data(), levels[l].data(), static_cast<std::uint32_t>(begin),
                               static_cast<std::uint32_t>(end));
    };
    if (shared > 0)
        share(pool, static_cast<int>(levels[static_cast<std::size_t>(shared)].size()), [&](int task, int) {
            for (int level = 1; level <= shared; ++level) {
                const std::size_t width = std::size_t{1} << (2 * (shared - level));
                make(level, static_cast<std::size_t>(task) * width, width);
            }
        });
    for (int level = shared + 1; level < level_count; ++level)
        make(level, 0, levels[static_cast<std::size_t>(level)].size());
}

bool FaceTree::is_apart_from_neighbours(std::uint32_t face) const
{
    if (proven_apart_) return true;
    if (settings_.culling != Culling::sound) return false;
    const GridPlace place = grid_places_[face];
    return place.grid < kNoGrid ? proofs_[place.grid].is_apart_from_neighbours(place.i, place.j)
                                : charts_->is_apart_from_neighbours(face);
}

FaceBox FaceTree::face_box(std::uint32_t face) const
{
    FaceBox box{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    const glm::vec3 shift(frame_.shift[0], frame_.shift[1], frame_.shift[2]);
    for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t v = faces_[face][corner];
        const glm::vec3 t0(frame_.t0[v]), t1 = frame_.t1 != nullptr ? glm::vec3(frame_.t1[v]) - shift : t0;
        box.lo = glm::min(box.lo, glm::min(t0, t1));
        box.hi = glm::max(box.hi, glm::max(t0, t1));
    }
    return {box.lo - frame_.growth, box.hi + frame_.growth};
}

}  // namespace nuno
