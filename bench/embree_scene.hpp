// SPDX-License-Identifier: MIT
// Embree behind the few calls that tests and benchmarks need: the same triangles, the same rays.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bvh/triangle.hpp"

namespace vitrine {

struct EmbreeHit {
    float t;  ///< infinity: a miss
    uint32_t triangle;
};

class EmbreeScene {
  public:
    /// Borrows both arrays until destruction. Embree uses at most `threads` for building.
    EmbreeScene(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                int threads, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE)
        : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
          positions_(positions.begin(), positions.end()),
          triangles_(triangles),
          flags_(flags) {
        if (!device_) throw std::runtime_error("Embree made no device");
        // Embree reads the last position by a load of 16 bytes.
        positions_.emplace_back(0.0f);
        commit(newScene());
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// A scene that holds the mesh but has no tree yet: `commit` builds it.
    [[nodiscard]] RTCScene newScene(RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM) const {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   positions_.data(), 0, sizeof(glm::vec3), positions_.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   triangles_.data(), 0, sizeof(glm::uvec3), triangles_.size());
        rtcSetGeometryBuildQuality(geometry, quality);
        rtcCommitGeometry(geometry);
        RTCScene scene = rtcNewScene(device_);
        rtcSetSceneFlags(scene, flags_);
        rtcSetSceneBuildQuality(scene, quality);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        return scene;
    }

    /// Builds the scene's tree and keeps it in the place of the one before.
    void commit(RTCScene scene) {
        rtcCommitScene(scene);
        if (scene_) rtcReleaseScene(scene_);
        scene_ = scene;
    }

    [[nodiscard]] EmbreeHit closest(const Ray& ray) const {
        RTCRayHit query{};
        query.ray = toEmbree(ray);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
            return {std::numeric_limits<float>::infinity(), 0};
        return {query.ray.tfar, query.hit.primID};
    }
    [[nodiscard]] bool any(const Ray& ray) const {
        RTCRay query = toEmbree(ray);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0;
    }
    void closest(std::span<const Ray> rays, std::span<EmbreeHit> hits) const {
        for (size_t i = 0; i < rays.size(); ++i) hits[i] = closest(rays[i]);
    }
    void any(std::span<const Ray> rays, std::span<uint8_t> hits) const {
        for (size_t i = 0; i < rays.size(); ++i) hits[i] = any(rays[i]);
    }

    [[nodiscard]] RTCDevice device() const { return device_; }

  private:
    static RTCRay toEmbree(const Ray& ray) {
        RTCRay result{};
        result.org_x = ray.origin.x;
        result.org_y = ray.origin.y;
        result.org_z = ray.origin.z;
        result.tnear = ray.tMin;
        result.dir_x = ray.direction.x;
        result.dir_y = ray.direction.y;
        result.dir_z = ray.direction.z;
        result.tfar = ray.tMax;
        result.mask = ~0u;
        return result;
    }

    RTCDevice device_;
    std::vector<glm::vec3> positions_;
    std::span<const glm::uvec3> triangles_;
    RTCSceneFlags flags_;
    RTCScene scene_ = nullptr;
};

}  // namespace vitrine
