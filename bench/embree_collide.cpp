// Embree 3: a scene of user geometry.
#include "bench/embree_collide.h"

#include <embree3/rtcore.h>

#include <array>
#include <atomic>
#include <string>

namespace nuno {
namespace {

bool share_vertex(const glm::uvec3& a, const glm::uvec3& b)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (a[i] == b[j]) return true;
    return false;
}

}  // namespace

struct EmbreeCollide::Scene
{
    // Each thread that calls back takes the next of these; apart, so that no cache line is shared.
    struct alignas(256) Found
    {
        std::vector<FacePair> pairs;
    };

    std::span<const glm::uvec3> faces;
    const std::vector<FaceBox>& boxes;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    RTCGeometry geometry = nullptr;
    std::array<Found, 64> found;
    std::vector<FacePair> all;
    std::atomic<std::size_t> threads{0};
    std::uint64_t number;  // of this scene among all

    static std::uint64_t next_number()
    {
        static std::atomic<std::uint64_t> count{0};
        return ++count;
    }

    static void bounds(const RTCBoundsFunctionArguments* arguments)
    {
        const auto& self = *static_cast<const Scene*>(arguments->geometryUserPtr);
        const FaceBox& box = self.boxes[arguments->primID];
        *arguments->bounds_o = {box.lo.x, box.lo.y, box.lo.z, 0, box.hi.x, box.hi.y, box.hi.z, 0};
    }

    static void collide(void* user, RTCCollision* collisions, unsigned count)
    {
        auto& self = *static_cast<Scene*>(user);
        thread_local std::uint64_t seen = 0;
        thread_local std::size_t place = 0;
        if (seen != self.number) {
            seen = self.number;
            place = self.threads++;
        }
        std::vector<FacePair>& pairs = self.found[place % self.found.size()].pairs;
        for (unsigned k = 0; k < count; ++k) {
            const std::uint32_t a = collisions[k].primID0, b = collisions[k].primID1;
            if (a < b && self.boxes[a].overlaps(self.boxes[b]) && !share_vertex(self.faces[a], self.faces[b]))
                pairs.push_back({a, b});
        }
    }
};

EmbreeCollide::EmbreeCollide(std::span<const glm::uvec3> faces, const std::vector<FaceBox>& boxes, int thread_count)
    : scene_(new Scene{faces, boxes, nullptr, nullptr, nullptr, {}, {}, 0, Scene::next_number()})
{
    Scene& s = *scene_;
    s.device = rtcNewDevice(("threads=" + std::to_string(thread_count)).c_str());
    s.scene = rtcNewScene(s.device);
    rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(s.scene, RTC_BUILD_QUALITY_LOW);
    s.geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(s.geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(s.geometry, &s);
    rtcSetGeometryBoundsFunction(s.geometry, Scene::bounds, nullptr);
    rtcSetGeometryBuildQuality(s.geometry, RTC_BUILD_QUALITY_REFIT);
    rtcCommitGeometry(s.geometry);
    rtcAttachGeometry(s.scene, s.geometry);
    rtcCommitScene(s.scene);
}

EmbreeCollide::~EmbreeCollide()
{
    rtcReleaseGeometry(scene_->geometry);
    rtcReleaseScene(scene_->scene);
    rtcReleaseDevice(scene_->device);
}

void EmbreeCollide::refit()
{
    rtcCommitGeometry(scene_->geometry);
    rtcCommitScene(scene_->scene);
}

void EmbreeCollide::query()
{
    for (Scene::Found& found : scene_->found) found.pairs.clear();
    rtcCollide(scene_->scene, scene_->scene, Scene::collide, scene_.get());
    scene_->all.clear();
    for (const Scene::Found& found : scene_->found)
        scene_->all.insert(scene_->all.end(), found.pairs.begin(), found.pairs.end());
}

std::span<const FacePair> EmbreeCollide::pairs() const { return scene_->all; }

}  // namespace nuno
