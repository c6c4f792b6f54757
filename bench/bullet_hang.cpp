// The load `hang` of hang_bench.cpp in Bullet, at its default of four sweeps a frame and at more: what a packaged
// engine makes of the same sheet in the same run. Position based, so that its springs have no constant: as stiff as its sweeps
// make them, those over two cells half as much.
#include <benchmark/benchmark.h>

#include <btBulletDynamicsCommon.h>

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/stopwatch.h"

namespace nuno {
namespace {

class BulletHang
{
  public:
    BulletHang(int count, int sweeps);

    void advance_frame() { world_.stepSimulation(1.0f / 60, 0, 1.0f / 60); }
    double max_strain() const;

  private:
    int node(int i, int j) const { return j * count_ + i; }
    void link(int i, int j, int right, int down, btSoftBody::Material* material);

    const int count_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraints_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &constraints_, &configuration_};
    std::unique_ptr<btSoftBody> sheet_;
};

BulletHang::BulletHang(int count, int sweeps) : count_(count)
{
    const btVector3 gravity(0, -9.81f, 1);
    world_.setGravity(gravity);
    btSoftBodyWorldInfo& info = world_.getWorldInfo();
    info.m_gravity = gravity;
    info.air_density = info.water_density = 0;
    info.m_sparsesdf.Initialize();
    const btScalar cell = 2.0f / static_cast<btScalar>(count - 1);
    std::vector<btVector3> places;
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) places.emplace_back(-1 + btScalar(i) * cell, -btScalar(j) * cell, 0);
    const std::vector<btScalar> masses(places.size(), 0.8f / btScalar(places.size()));
    sheet_ = std::make_unique<btSoftBody>(&info, int(places.size()), places.data(), masses.data());
    btSoftBody::Material* const bend = sheet_->appendMaterial();
    bend->m_kLST = 0.5f;
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            for (const auto& [right, down] : {std::pair(1, 0), {0, 1}, {1, 1}, {-1, 1}})
                link(i, j, right, down, sheet_->m_materials[0]);
            link(i, j, 2, 0, bend);
            link(i, j, 0, 2, bend);
        }
    sheet_->setMass(node(0, 0), 0);
    sheet_->setMass(node(count - 1, 0), 0);
    sheet_->m_cfg.piterations = sweeps;
    sheet_->m_cfg.kDP = 0.2f / 60;  // drag: share of the velocity that a frame takes
    sheet_->m_cfg.collisions = 0;
    sheet_->randomizeConstraints();
    world_.addSoftBody(sheet_.get());
}

void BulletHang::link(int i, int j, int right, int down, btSoftBody::Material* material)
{
    if (i + right < 0 || i + right >= count_ || j + down >= count_) return;
    sheet_->appendLink(node(i, j), node(i + right, j + down), material);
}

double BulletHang::max_strain() const
{
    double most = 0;
    for (int k = 0; k < sheet_->m_links.size(); ++k) {
        const btSoftBody::Link& l = sheet_->m_links[k];
        const auto a = l.m_n[0] - &sheet_->m_nodes[0], b = l.m_n[1] - &sheet_->m_nodes[0];
        if (b - a != 1 && b - a != count_) continue;  // threads only
        most = std::max(most, double((l.m_n[1]->m_x - l.m_n[0]->m_x).length() / l.m_rl) - 1);
    }
    return most;
}

// Arguments: vertices a side, sweeps a frame.
void bullet_hang(benchmark::State& state)
{
    double strain = 0;
    for (auto _ : state) {
        BulletHang hang(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
        std::vector<double> frame_s;
        for (int frame = 0; frame < 120; ++frame) {
            const Stopwatch watch;
            hang.advance_frame();
            frame_s.push_back(watch.elapsed_ms() / 1000);
        }
        std::nth_element(frame_s.begin() + 60, frame_s.begin() + 90, frame_s.end());
        state.SetIterationTime(frame_s[90]);
        strain = hang.max_strain();
    }
    state.counters["strain_percent"] = 100 * strain;
}
BENCHMARK(bullet_hang)
    ->ArgsProduct({{64, 128, 256}, {4}})
    ->Args({64, 100})
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nuno
