// The tree of faces beside Embree's rtcCollide: refit and self-query of a sheet that rolls up and of one that waves, of a
// tube that waves and of one that crumples.
//
//     tree_bench [rounds] [side ...]      rounds 3, sides 128 and 256
//
// 100 frames of a sheet of 2 m, or of a tube of 2 m around and along; found are the pairs of faces without a common vertex whose boxes, each grown by an
// eighth of the spacing, overlap. In every round all peers take their turn with all frames; pairs are stored, and
// compared outside the time. Figures are medians over the frames 50 .. 99, then the best and the median of the rounds
// [ms]. nuno's refit starts from positions; Embree's from boxes, whose making is not in its time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision/tree/face_tree.h"
#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "model/cloth_model.h"

#if NUNO_HAS_EMBREE
#include "bench/embree_collide.h"
#endif

namespace nuno {
namespace {

constexpr int kFrames = 100, kFirstTimed = 50;
constexpr float kPi = 3.14159265f;

enum class Way
{
    roll,
    drape,
    tube,
    crumple
};
constexpr const char* kWayNames[] = {"roll", "drape", "tube", "crumple"};

struct Cloth
{
    int side;
    Way way;
    float spacing;
    TriangleMesh mesh;
    std::vector<glm::vec4> positions;

    Cloth(int n, Way w) : side(n), way(w), spacing(2.0f / static_cast<float>(n - 1))
    {
        mesh = grid_mesh(n, n, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
        positions.resize(mesh.positions.size());
        if (is_grid()) return;
        // Sewn together along the last column, and round at rest.
        for (glm::vec3& p : mesh.positions) p = around(p.x, p.y, 1 / kPi);
        for (glm::uvec3& face : mesh.faces)
            for (int k = 0; k < 3; ++k)
                if (face[k] % static_cast<std::uint32_t>(n) == static_cast<std::uint32_t>(n) - 1)
                    face[k] -= static_cast<std::uint32_t>(n) - 1;
    }
    bool is_grid() const { return way == Way::roll || way == Way::drape; }
    float distance() const { return 0.25f * spacing; }

    static glm::vec3 around(float u, float v, float radius)
    {
        return {radius * std::cos(kPi * u), v, radius * std::sin(kPi * u)};
    }

    // A tube in waves, a tenth of its radius high; or pressed together and thrown about.
    glm::vec3 place_of_tube(float u, float v, float t) const
    {
        const bool crumples = way == Way::crumple;
        const float wave = std::sin(10 * v + 6 * t) * std::cos(5 * kPi * u + 4 * t);
        glm::vec3 p = around(u, crumples ? 0.5f * v : v, (1 + 0.1f * wave) / kPi);
        if (!crumples) return p;
        return p + 0.05f * glm::vec3(std::sin(40 * p.y + 9 * p.x + 6 * t), std::sin(50 * p.z + 30 * p.y),
                                     std::cos(60 * p.x + 20 * p.z + 5 * t));
    }

    // An Archimedean spiral, its layers 0.75 of the spacing apart, twisted and rippled; or a waving surface.
    glm::vec3 place(float u, float v, float t) const
    {
        if (!is_grid()) return place_of_tube(u, v, t);
        if (way == Way::drape)
            return {
                u, v,
                0.08f * std::sin(5 * u + 10 * t) * std::cos(4 * v - 6 * t) + 0.02f * std::sin(17 * u - 9 * v + 14 * t)};
        const float growth = 0.75f * spacing / 6.2831853f, r0 = 2 * std::pow(0.03f / 2, t);
        const float turn = (-r0 + std::sqrt(r0 * r0 + 2 * growth * u)) / growth;
        const float r = r0 + growth * turn + 0.15f * spacing * std::sin(9 * v + 6 * turn / (1 + turn) + 20 * t);
        const float angle = turn + 0.5f * t * v;
        return {r * std::cos(angle), v, r * std::sin(angle)};
    }
    void pose(int frame)
    {
        const float t = static_cast<float>(frame) / (kFrames - 1);
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                positions[static_cast<std::size_t>(j * side + i)] =
                    glm::vec4(place(static_cast<float>(i) * spacing, static_cast<float>(j) * spacing, t), 1);
    }
    Sheet sheet(bool as_grid) const
    {
        return {"sheet",
                0,
                static_cast<std::uint32_t>(mesh.positions.size()),
                0,
                static_cast<std::uint32_t>(mesh.faces.size()),
                as_grid ? side : 0,
                as_grid ? side : 0,
                {}};
    }
};

// What does not depend on the order of pairs.
struct Digest
{
    std::size_t count = 0;
    std::uint64_t sum = 0;

    void add(std::span<const FacePair> pairs)
    {
        count += pairs.size();
        for (const FacePair pair : pairs)
            sum += (std::uint64_t{pair.a} * 0x9e3779b97f4a7c15u) ^ (std::uint64_t{pair.b} * 0xc2b2ae3d27d4eb4fu);
    }
    bool operator==(const Digest&) const = default;
};

struct Peer
{
    std::string name;
    bool is_exact;  // finds what all exact peers find
    std::function<void()> refit, query;
    std::function<Digest()> digest;
    std::vector<double> refit_of, query_of;  // of each round [ms]
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}
double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

struct Tree
{
    FaceTree tree;
    ThreadPool pool;
    Tree(const Cloth& cloth, bool as_grid, int threads)
        : tree(cloth.mesh.positions, cloth.mesh.faces, std::vector{cloth.sheet(as_grid)}), pool(threads)
    {
    }
};

Peer tree_peer(const Cloth& cloth, bool as_grid, Culling culling, int threads)
{
    auto tree = std::make_shared<Tree>(cloth, as_grid, threads);
    const TreeSettings settings{cloth.distance(), culling};
    return {fmt::format("{}{} x{}", as_grid ? "grid" : "mesh", culling == Culling::sound ? " sound" : "", threads),
            culling == Culling::none,
            [tree, &cloth, settings] {
                tree->tree.refit({cloth.positions, cloth.positions}, settings, tree->pool);
            },
            [tree] { tree->tree.query(tree->pool); },
            [tree] {
                Digest digest;
                for (const std::span<const FacePair> part : tree->tree.pairs()) digest.add(part);
                return digest;
            },
            {},
            {}};
}

#if NUNO_HAS_EMBREE
Peer embree_peer(const Cloth& cloth, const std::vector<FaceBox>& boxes, int threads)
{
    auto embree = std::make_shared<EmbreeCollide>(cloth.mesh.faces, boxes, threads);
    return {fmt::format("Embree x{}", threads),
            true,
            [embree] { embree->refit(); },
            [embree] { embree->query(); },
            [embree] {
                Digest digest;
                digest.add(embree->pairs());
                return digest;
            },
            {},
            {}};
}
#endif

// The boxes as the tree has them.
void take_boxes(const Cloth& cloth, Tree& reference, std::vector<FaceBox>& boxes)
{
    reference.tree.refit({cloth.positions, cloth.positions}, {cloth.distance(), Culling::none}, reference.pool);
    for (std::uint32_t f = 0; f < boxes.size(); ++f) boxes[f] = reference.tree.face_box(f);
}

// All frames with one peer; what it found in each.
std::vector<Digest> run_frames(Cloth& cloth, Tree& reference, std::vector<FaceBox>& boxes, Peer& peer)
{
    std::vector<double> refit_ms, query_ms;
    std::vector<Digest> digests;
    for (int frame = 0; frame < kFrames; ++frame) {
        cloth.pose(frame);
        take_boxes(cloth, reference, boxes);
        const Stopwatch watch;
        peer.refit();
        const double refitted_ms = watch.elapsed_ms();
        peer.query();
        const double done_ms = watch.elapsed_ms();
        if (frame >= kFirstTimed) {
            refit_ms.push_back(refitted_ms);
            query_ms.push_back(done_ms - refitted_ms);
        }
        digests.push_back(peer.digest());
    }
    peer.refit_of.push_back(median(refit_ms));
    peer.query_of.push_back(median(query_ms));
    return digests;
}

// Every peer in turn. Returns how many frames had an exact peer that disagrees with the first.
int run_round(Cloth& cloth, Tree& reference, std::vector<FaceBox>& boxes, std::vector<Peer>& peers)
{
    int wrong = 0;
    std::vector<Digest> expected;
    for (Peer& peer : peers) {
        const std::vector<Digest> digests = run_frames(cloth, reference, boxes, peer);
        if (!peer.is_exact) continue;
        if (expected.empty()) expected = digests;
        for (std::size_t frame = 0; frame < digests.size(); ++frame) wrong += !(digests[frame] == expected[frame]);
    }
    return wrong;
}

std::vector<double> totals(const Peer& peer)
{
    std::vector<double> sums;
    for (std::size_t r = 0; r < peer.refit_of.size(); ++r) sums.push_back(peer.refit_of[r] + peer.query_of[r]);
    return sums;
}

void print(const Cloth& cloth, const std::vector<Peer>& peers)
{
    for (const Peer& peer : peers) {
        fmt::print("{:7} {:4} {:14} {:8.3f} {:8.3f} {:8.3f} [{:8.3f}] {:8} pairs",
                   kWayNames[static_cast<int>(cloth.way)], cloth.side, peer.name, least(peer.refit_of),
                   least(peer.query_of), least(totals(peer)), median(totals(peer)), peer.digest().count);
        if (peers[0].name.starts_with("Embree"))
            fmt::print("  x{:.1f} [x{:.1f}]", least(totals(peers[0])) / least(totals(peer)),
                       median(totals(peers[0])) / median(totals(peer)));
        fmt::print("\n");
    }
}

// Two threads over one.
void print_gain(const Peer& one, const Peer& two)
{
    const auto gain = [](const std::vector<double>& a, const std::vector<double>& b) { return least(a) / least(b); };
    fmt::print("           {} over {}: refit x{:.2f}, query x{:.2f}, both x{:.2f}\n", two.name, one.name,
               gain(one.refit_of, two.refit_of), gain(one.query_of, two.query_of), gain(totals(one), totals(two)));
}

int run(int side, Way way, int rounds)
{
    Cloth cloth(side, way);
    cloth.pose(0);
    Tree reference(cloth, cloth.is_grid(), 1);
    std::vector<FaceBox> boxes(cloth.mesh.faces.size());
    take_boxes(cloth, reference, boxes);
    int wrong = 0;
    for (const int threads : {1, 2}) {
        std::vector<Peer> peers;
#if NUNO_HAS_EMBREE
        peers.push_back(embree_peer(cloth, boxes, threads));
#endif
        const std::size_t first = peers.size();
        for (int t = 1; cloth.is_grid() && t <= threads; ++t) peers.push_back(tree_peer(cloth, true, Culling::none, t));
        for (int t = 1; t <= threads; ++t) peers.push_back(tree_peer(cloth, false, Culling::none, t));
        for (int t = 1; t <= threads; ++t) peers.push_back(tree_peer(cloth, cloth.is_grid(), Culling::sound, t));
        for (int round = 0; round < rounds; ++round) wrong += run_round(cloth, reference, boxes, peers);
        print(cloth, peers);
        for (std::size_t p = first; threads == 2 && p < peers.size(); p += 2) print_gain(peers[p], peers[p + 1]);
    }
    return wrong;
}

}  // namespace
}  // namespace nuno

int main(int argc, char** argv)
{
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
    std::vector<int> sides;
    for (int k = 2; k < argc; ++k) sides.push_back(std::max(4, std::atoi(argv[k])));
    if (sides.empty()) sides = {128, 256};
    fmt::print("seq     side peer              refit    query    both [ median]\n");
    int wrong = 0;
    for (const int side : sides)
        for (const nuno::Way way : {nuno::Way::roll, nuno::Way::drape, nuno::Way::tube, nuno::Way::crumple})
            wrong += nuno::run(side, way, rounds);
    fmt::print("{}\n", wrong == 0 ? "All exact peers found the same pairs in every frame."
                                  : fmt::format("{} times a peer found other pairs than the one before it.", wrong));
    return wrong == 0 ? 0 : 1;
}
