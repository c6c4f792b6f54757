// The tree over all faces of a cloth, of all its sheets together: which faces may touch (docs/tree.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "collision/tree/chart_proof.h"
#include "collision/tree/grid_proof.h"
#include "collision/tree/kernels.h"
#include "collision/tree/seed_flags.h"
#include "collision/tree/tree_layout.h"
#include "collision/tree/tree_node.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"
#include "model/sim_params.h"

namespace nuno {

// The box of a face in the frame of a refit, grown.
struct FaceBox
{
    glm::vec3 lo, hi;

    bool overlaps(const FaceBox& other) const
    {
        return lo.x <= other.hi.x && other.lo.x <= hi.x && lo.y <= other.hi.y && other.lo.y <= hi.y &&
               lo.z <= other.hi.z && other.lo.z <= hi.z;
    }
};

// Nothing depends on the number of threads, nor on the width of the machine's vectors: not the pairs, not their order.
class FaceTree
{
  public:
    // Rest positions [m] and faces of all sheets; without sheets, all faces are one mesh. The topology is built here.
    FaceTree(std::span<const glm::vec3> rest_positions, std::span<const glm::uvec3> faces,
             std::span<const Sheet> sheets);
    explicit FaceTree(const ClothModel& model);

    // Boxes around the cloth. Coordinates must be finite and below 1e6 m; they must stay as they are until the query is
    // done.
    void refit(const Poses& poses, const TreeSettings& settings, ThreadPool& pool);

    // Finds the pairs of faces, each once, that share no vertex and whose boxes overlap: with Culling::none all of
    // them, with Culling::sound at least those that come within the distance at some time of the way, with
    // Culling::seed less what that loses. After every refit.
    void query(ThreadPool& pool);

    // The pairs of the last query, in several parts; they last until the next refit.
    std::span<const std::span<const FacePair>> pairs() const { return parts_; }
    std::uint64_t pair_count() const;
    // Pairs of nodes that the last query looked at.
    std::uint64_t visits() const { return visits_; }
    // Whether the last refit has proven that there is nothing to find, and made no boxes.
    bool is_proven_apart() const { return proven_apart_; }

    // Whether, of the faces that share a vertex with this one, no vertex or edge comes within the distance of it
    // without a vertex in common; those pairs are in no list of the tree. Only Culling::sound knows any.
    bool is_apart_from_neighbours(std::uint32_t face) const;

    // As of the last refit.
    FaceBox face_box(std::uint32_t face) const;
    std::span<const glm::uvec3> faces() const { return faces_; }

    // For pictures: how many levels below the root the lowest nodes are, and the boxes that the last refit has made so
    // many levels below it.
    int depth() const { return static_cast<int>(layout_.levels.size()) - 1; }
    std::vector<FaceBox> node_boxes(int depth) const;
    // Of each face, what a query after the last refit leaves out for it cannot touch: 0 nothing, 1 the faces around it, 1 + n all faces
    // below the same node as it, n levels above the lowest nodes.
    std::vector<int> left_out() const;

    // For tests: 4, 8 or 16 floats a vector, if the machine has them.
    void use_lanes(int lanes) { kernels_ = &tree_kernels(lanes); }

  private:
    // What a thread works with.
    struct Worker
    {
        RowScratch rows;
        QueryScratch query;
    };
    // Vertices begin .. end - 1, of one sheet.
    struct VertexRun
    {
        std::uint32_t begin, end, sheet;
    };
    // Where a face lies in a grid; kNoGrid where it lies in none.
    struct GridPlace
    {
        std::uint32_t grid = kNoGrid;
        std::uint16_t i = 0, j = 0;
    };
    struct alignas(64) Task
    {
        PairList found;
        std::uint64_t visits = 0;
    };

    struct TaskPlan
    {
        int level;
        std::size_t node_count, pairs_each, nodes_each, pair_tasks, node_tasks, task_count;
    };

    void find_places();
    void share_out(std::span<const Sheet> sheets, std::uint32_t vertex_count);
    void share(ThreadPool& pool, int task_count, const std::function<void(int task, int thread)>& body);
    // Whether all sheets are proven apart in themselves.
    bool prove(const Poses& poses, const TreeSettings& settings, ThreadPool& pool);
    void frame_boxes(float distance, ThreadPool& pool);
    bool sheets_are_apart() const;
    void make_boxes(ThreadPool& pool);
    void make_parents(ThreadPool& pool);
    QueryFrame query_frame() const;
    bool masks_neighbours() const;
    bool skips_self(int level, std::uint32_t node) const;
    void open_down_to(int level);
    void open_children(int level);
    TaskPlan plan_tasks(int level) const;
    void run_task(const QueryFrame& frame, const TaskPlan& plan, std::size_t number, Worker& worker, Task& task);
    void visit_below(const QueryFrame& frame, int level, NodeRun nodes, Worker& worker, Task& task);

    std::vector<glm::vec3> rest_positions_;
    std::vector<glm::uvec3> faces_;
    std::vector<GridPlace> grid_places_;  // of each face
    TreeLayout layout_;
    std::vector<GridProof> proofs_;         // of each grid
    std::vector<ProofLevel> proof_levels_;  // of each grid, kMostLevels
    std::optional<ChartProof> charts_;      // of all sheets that are no grids, once asked for
    SeedFlags seed_flags_;
    std::vector<VertexRun> vertex_runs_;
    std::vector<GridBand> bands_;
    std::vector<NodeRun> mesh_chunks_;
    std::size_t sheet_count_ = 0;
    bool is_large_ = false;  // whether sharing the work among threads pays; a property of the mesh
    const TreeKernels* kernels_;

    TreeSettings settings_;
    BoxFrame frame_;
    std::vector<VertexExtent> extents_;  // of each vertex run
    std::vector<FaceBox> sheet_boxes_;   // around each sheet and more
    bool proven_apart_ = false;

    std::vector<Worker> workers_;
    std::vector<std::uint32_t> open_first_, open_second_, next_first_, next_second_;
    std::vector<BandFound> neighbours_;  // of each band
    std::vector<Task> tasks_;
    std::vector<std::span<const FacePair>> parts_;
    std::uint64_t visits_ = 0;
};

}  // namespace nuno
